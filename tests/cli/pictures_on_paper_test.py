#!/usr/bin/env python3
"""`plastica plot`: every picture, for screens and at both widths of journals, has all of its labels
whole, none over another, in letters of the size that was asked for. A browser measures the texts.

pictures_on_paper_test.py COMMAND DATA
"""

import itertools
import os
import re
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

COMMAND, DATA = sys.argv[1:3]
WIDTHS = (85, 170)  # [mm]; a page for screens is laid out as one of 181
PIXELS = 96.0 / 25.4  # of a browser, in a millimetre
POINTS_8 = 8.0 * 96.0 / 72.0
# Texts with their boxes; slanted ones have boxes that say nothing.
TEXTS = """[...document.querySelectorAll('text')].filter((e) => e.textContent.trim()).map((e) => {
  const box = e.getBoundingClientRect();
  const m = e.getScreenCTM();
  const angle = Math.abs(Math.atan2(m.b, m.a)) * 180 / Math.PI;
  return { text: e.textContent.trim(), left: box.left, right: box.right, top: box.top,
           bottom: box.bottom, slanted: Math.min(angle, Math.abs(angle - 90)) > 1,
           size: parseFloat(getComputedStyle(e).fontSize) * Math.hypot(m.a, m.b) };
})"""
SIZE = "(() => { const r = document.documentElement.getBoundingClientRect(); return [r.width, r.height]; })()"
browser = None


def setUpModule():
    global browser
    browser = Browser()


def tearDownModule():
    browser.close()


def run(*words, code=0):
    done = subprocess.run([COMMAND, *words], capture_output=True, text=True)
    if done.returncode not in (code, 1):
        raise AssertionError(f"{words}: {done.returncode}: {done.stderr}")
    return done


def overlap(a, b):
    """Of two boxes, along the axis where they overlap least [pixels]."""
    return min(min(a["right"], b["right"]) - max(a["left"], b["left"]),
               min(a["bottom"], b["bottom"]) - max(a["top"], b["top"]))


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def check(self, result, what, width, *options):
        picture = self.path("p.svg")
        paper = [] if width is None else ["--width", str(width)]
        run("plot", result, "--what", what, "-o", picture, "--force", *paper, *options)
        browser.open(picture)
        wide, high = browser.evaluate(SIZE)
        texts = browser.evaluate(TEXTS)
        self.assertTrue(texts)
        faults = []
        if width is not None:
            self.assertAlmostEqual(wide, width * PIXELS, delta=0.5)
            for text in texts:
                if text["size"] > 1.01 * POINTS_8:
                    faults.append(f"{text['text']!r} has {text['size']:.2f} pixels")
            # Numbers within a map's fields are smaller.
            usual = [t for t in texts if abs(t["size"] - POINTS_8) < 0.01 * POINTS_8]
            self.assertGreater(len(usual), 0.2 * len(texts))
        for text in texts:
            outside = max(-text["left"], text["right"] - wide, -text["top"], text["bottom"] - high)
            if outside > 1.0:
                faults.append(f"{text['text']!r} is cut by {outside:.1f} pixels")
        straight = [t for t in texts if not t["slanted"]]
        for a, b in itertools.combinations(straight, 2):
            # Boxes are a little higher than letters.
            if overlap(a, b) > 3.0:
                faults.append(f"{a['text']!r} lies over {b['text']!r} by {overlap(a, b):.1f} pixels")
        if width is None:
            return [f"{what}: {fault}" for fault in faults]
        # Names of users may be cut, our own words not.
        own = ("resamples", "normal", "noise", "engineering", "along the beam", "youngs_modulus")
        faults += [f"{t['text']!r} is cut short" for t in texts
                   if "…" in t["text"] and t["text"].startswith(own)]
        shown = " ".join(t["text"] for t in texts)
        script = self.path("p.gp")
        run("plot", result, "--what", what, "-o", script, "--force", *paper, *options)
        with open(script, encoding="utf-8") as file:
            for label in re.findall(r"^set (?:xlabel|label 899) '(.+?)'(?: at .*)?$", file.read(), re.M):
                if re.sub(r"\s+", " ", label.replace("''", "'")) not in shown:
                    faults.append(f"{label!r} is not there")
        return [f"{what} at {width}: {fault}" for fault in faults]

    def check_all(self, result, widths=WIDTHS, **options):
        listed = run("plot", "--list", result).stdout
        kinds = [line.split()[0] for line in listed.splitlines()]
        self.assertTrue(kinds)
        faults = []
        for what in kinds:
            for width in widths:
                faults += self.check(result, what, width, *options.get(what, []))
        self.assertEqual(faults, [], "\n" + "\n".join(faults))

    def made(self, name, *words):
        result = self.path(name)
        if not os.path.exists(result):
            run(*words, "-o", result, "--quiet")
        return result

    def test_fits(self):
        self.check_all(self.made("fits.h5", "calibrate", os.path.join(DATA, "fits/demo.toml"),
                                 "--laws", "ideal,linear", "--profile", "--bootstrap", "40"),
                       widths=(None, *WIDTHS))

    def test_profiles_of_exact_data(self):
        curve = self.path("exact.csv")
        with open(curve, "w", encoding="utf-8") as file:
            file.write("strain,stress [MPa]\n")
            file.writelines(f"{1e-4 * i:g},{min(20.0 * i, 300.0):g}\n" for i in range(1, 81))
        result = self.made("exact.h5", "calibrate", curve, "--strain", "strain", "--stress", "stress",
                           "--profile")
        self.assertEqual(self.check(result, "profile", 85), [])

    def test_long_names(self):
        with open(os.path.join(DATA, "scenes/cantilever.toml"), encoding="utf-8") as file:
            text = file.read().replace('name = "tip"', 'name = "displacement of the far end of the boom"')
        scene = self.path("long.toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text)
        self.check_all(self.made("long.h5", "simulate", scene))

    def test_fits_through_scenes(self):
        self.check_all(self.made("bend.h5", "calibrate", os.path.join(DATA, "fits/bend_test.toml"),
                                 "--laws", "ideal,linear", "--profile", "--bootstrap", "20"))

    def test_motions(self):
        for scene in ("crash_bumper",):
            self.check_all(self.made(scene + ".h5", "simulate",
                                     os.path.join(DATA, f"scenes/{scene}.toml")))

    def test_paths(self):
        for scene in ("bathe_bolourchi_45", "three_point_bend"):
            self.check_all(self.made(scene + ".h5", "simulate",
                                     os.path.join(DATA, f"scenes/{scene}.toml")))

    def test_sweeps(self):
        self.check_all(self.made("bend_45.h5", "sweep", os.path.join(DATA, "sweeps/bend_45.toml")))
        # The shipped study in so few cases that each group of lines is still there.
        with open(os.path.join(DATA, "sweeps/falling_cantilever_trade.toml"), encoding="utf-8") as file:
            text = file.read()
        for shipped, here in (("[16, 32, 64, 128, 256]", "[8, 16, 32]"),
                              (', "0.5 ms", "0.25 ms", "0.125 ms", "62.5 us"]', "]"),
                              ("../scenes", os.path.join(DATA, "scenes")),
                              ("../../tests", os.path.join(DATA, "../tests"))):
            self.assertIn(shipped, text)
            text = text.replace(shipped, here)
        sweep = self.path("trade.toml")
        with open(sweep, "w", encoding="utf-8") as file:
            file.write(text)
        # Ids of cases differ between instruction sets.
        self.check_all(self.made("trade.h5", "sweep", sweep),
                       curve=["--case", "beam.segments = 32, solver.time_step = 1 ms"])

    def test_files_have_the_size_that_was_asked_for(self):
        result = self.made("cantilever.h5", "simulate", os.path.join(DATA, "scenes/cantilever.toml"))
        png, pdf = self.path("p.png"), self.path("p.pdf")
        run("plot", result, "-o", png, "--width", "85")
        with open(png, "rb") as file:
            head = file.read(45)
        self.assertEqual(int.from_bytes(head[16:20], "big"), round(85 / 25.4 * 300))
        self.assertEqual(head[37:41], b"pHYs")
        self.assertEqual(int.from_bytes(head[41:45], "big"), round(300 / 0.0254))  # a metre
        run("plot", result, "-o", pdf, "--width", "85")
        with open(pdf, "rb") as file:
            box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ", file.read())
        self.assertAlmostEqual(float(box[1]), 85 / 25.4 * 72, delta=1.0)

    def test_bad_widths_have_a_line(self):
        result = self.made("cantilever.h5", "simulate", os.path.join(DATA, "scenes/cantilever.toml"))
        for words in (["--width", "20", "-o", self.path("w.svg")], ["--width", "85"],
                      ["--width", "85mm", "-o", self.path("w.svg")]):
            done = run("plot", result, *words, code=2)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--width", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertFalse(os.path.exists(self.path("w.svg")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
