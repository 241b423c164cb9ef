"""Small result files of each kind, made with the command itself, and what is asked of them."""

import subprocess

FITS_OF_LAWS = ["--laws", "ideal,linear"]
INTERVALS = ["--profile", "--bootstrap", "20"]

BEAM = """name = "beam"
[beam]
length = "400 mm"
segments = 4
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[[support]]
at = "start"
kind = "clamp"
[[region]]
from = 0.5
to = 1.0
section.width = "10 mm"
"""
BREAKING = BEAM + """
[material]
name = "S355"
break_strain = "0.5 %"
[solver]
steps = 8
[[support]]
at = "end"
kind = "roller"
hold = ["y"]
translation = ["0 mm", "-100 mm", "0 mm"]
[[probe]]
name = "tip"
kind = "displacement"
component = "y"
[[probe]]
name = "work"
kind = "energy"
energy = "plastic"
"""
LIMIT = BEAM + """
material = "S355"
[solver]
steps = 6
[[load]]
at = "end"
force = ["0 N", "-1 MN", "0 N"]
[[load]]
at = 0.5
to = "end"
force = ["0 N/m", "-1 N/m", "0 N/m"]
[[probe]]
kind = "displacement"
component = "y"
[[probe]]
kind = "moment"
at = "start"
component = "x"
""".replace('material = "S355"\n', '[material]\nname = "S355"\n')
MOTION = BEAM + """
[material]
name = "S355"
break_strain = "2 %"
[gravity]
acceleration = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
history = "constant"
[[initial_motion]]
from = 0.5
velocity = ["0 m/s", "-5 m/s", "0 m/s"]
[[cut]]
at = 0.5
time = "4 ms"
[solver]
analysis = "dynamics"
duration = "10 ms"
steps = 10
frames = 4
[[probe]]
kind = "displacement"
component = "y"
[[probe]]
kind = "energy"
energy = "kinetic"
"""
SWEEP = """scene = "cantilever.toml"
[[axis]]
field = "beam.segments"
values = [2, 4, 8]
[[axis]]
field = "rules.hinge_length"
values = ["unset", "30 mm"]
[[axis]]
field = "rules.end_rule"
values = ["half_joint", "equal"]
[error]
probe = "tip"
"""
TIMED = SWEEP + 'against = "theory:elastica"\n[cost]\ntimed_runs = 1\n'
CURVES = SWEEP + 'take = "curve"\nagainst = "finest"\n'

SCENE_TABLES = ("probes", "joints", "energies", "events", "fragments", "spectrum", "beam")
ENGINES = ("mjcf", "agx", "chrono", "opensees")


def of_scenes(plots):
    return [["show"], *([["plot", "--what", what] for what in plots]),
            *([["export", "--what", what] for what in SCENE_TABLES]), ["export", "--to", "json"],
            *([["export", "--to", engine] for engine in ENGINES])]


def of_fits(plots, tables, scene):
    beams = [["export", "--to", engine, *scene] for engine in ENGINES]
    return [["show", "--all"], ["show"], *([["plot", "--what", what] for what in plots]),
            *([["export", "--what", what] for what in tables]), ["export", "--to", "json"], *beams]


def of_sweeps(plots, resumed):
    return [["show", "--all"], ["show"], *([["plot", "--what", what] for what in plots]),
            ["export", "--what", "cases"], ["export", "--what", "curves"],
            *([["export", "--to", to] for to in ("json", "markdown", "latex")]),
            ["recommend", "--within", "1 %"], ["recommend", "--budget", "1e6"],
            ["sweep", resumed, "--resume", "--quiet"]]


class SmallResults:
    """Makes the files in a folder of their own and knows the commands that read them."""

    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        for kind in ("fit", "scene-fit", "coupon", "sweep"):
            self.run("init", kind)
        self.pictures = self.pictures_by_kind()

    def run(self, *arguments):
        done = subprocess.run([self.command, *arguments], cwd=self.folder, capture_output=True,
                              text=True)
        if done.returncode not in (0, 1):
            raise RuntimeError(f"{' '.join(arguments)}: {done.stderr}")
        return done.stdout

    def pictures_by_kind(self):
        kinds, lines = {}, self.run("plot", "--list").splitlines()
        for line in lines:
            if line.startswith("of "):
                pictures = kinds.setdefault(line[3:].rstrip(":"), [])
            else:
                pictures.append(line.split()[0])
        return kinds

    def scene(self, name, text):
        (self.folder / f"{name}.toml").write_text(text)
        self.run("simulate", f"{name}.toml", "-o", f"{name}.h5", "--quiet")
        return f"{name}.h5", of_scenes(self.pictures["a simulated scene"])

    def sweep(self, name, text):
        (self.folder / f"{name}.toml").write_text(text)
        self.run("sweep", f"{name}.toml", "-o", f"{name}.h5", "--quiet")
        return f"{name}.h5", of_sweeps(self.pictures["a sweep"], f"{name}.toml")

    def fits(self, name, options):
        self.run("calibrate", "fit.toml", "-o", f"{name}.h5", "--quiet", *options)
        return f"{name}.h5", of_fits(self.pictures["fits"], ("specimens", "curves"),
                                     ["--scene", "bend_test.toml"])

    def scene_fits(self, name, options):
        text = (self.folder / "scene-fit.toml").read_text()
        quick = text.replace("[fit]\n", "[fit]\nstarts = 2\nscreen = 4\n", 1)
        quick = quick.replace("segments = 32", "segments = 8")
        (self.folder / f"{name}.toml").write_text(quick)
        self.run("calibrate", f"{name}.toml", "-o", f"{name}.h5", "--quiet", *options)
        return f"{name}.h5", of_fits(self.pictures["fits through scenes"],
                                     ("fits", "targets", "curves"), [])

    def all(self):
        """(kind, file, commands) of each kind."""
        made = {
            "path": self.scene("path", BREAKING),
            "limit": self.scene("limit", LIMIT),
            "motion": self.scene("motion", MOTION),
            "coupon": self.scene("coupon", (self.folder / "coupon.toml").read_text()),
            "fits": self.fits("fits", INTERVALS),
            "laws": self.fits("laws", FITS_OF_LAWS),
            "scene-fits": self.scene_fits("scene-fits", INTERVALS),
            "sweep": self.sweep("timed", TIMED),
            "curves": self.sweep("curves", CURVES),
        }
        return [(kind, *of) for kind, of in made.items()]
