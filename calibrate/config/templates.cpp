#include "calibrate/config/templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

#include "calibrate/config/bend_test_files.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kFit =
    R"(# A fit: finds Young's modulus, yield stress and break strain of measured curves.
#
#   plastica calibrate fit.toml -o fit.h5
#
# Runs as it is, on example-curve.csv beside it. For your own curves change `files`, `strain` and
# `stress` below; `plastica inspect CURVE.csv` prints a [[target]] that suits a file.
# `#` begins a comment. Quantities stand in quotes with their unit: "355 MPa", "0.2 %".

[fit]
objective = "path"                # or "least-squares", with noise = "1 MPa"
# break_weight = 1.0              # how much the break counts beside the curve
# modulus_prior = false           # E by the law alone, without the slope of the elastic part
# algorithm    = "auto"           # or "gauss-newton", or one of NLopt's by name
# seed         = 1                # of the global stage
# confidence   = "95 %"           # of the intervals
# profile      = true             # likelihood intervals, asymmetric, beside the usual ones
# bootstrap    = 400              # and those of resampled residuals, so many times

[fit.parameters]                  # `plastica fields` lists the names that may stand here
youngs_modulus = {}               # free, bounds from the curve; or { value = "200 GPa", fixed = true }
yield_stress   = { bounds = ["10 MPa", "2 GPa"] }
break_strain   = { bounds = ["0.1 %", "100 %"] }       # the permanent strain at break
# shear_yield_stress = { tie = "yield_stress", factor = 0.577 }
# tangent_modulus = { prior = { mean = "2 GPa", standard_deviation = "0.5 GPa" } }

# What the parameters do not say of the material. `material = "6061-T6"` above [fit] names one.
[material]
poisson_ratio = 0.3
# hardening.law = "linear"        # then tangent_modulus can be a parameter

# One [[target]] for each kind of file; a file is a specimen.
[[target]]
files  = ["example-curve.csv"]    # beside this file; patterns too: "curves/*.csv"
test   = "tension"                # or "bending", "torsion"
strain = { column = "Strain", unit = "%" }
stress = { column = "Stress", unit = "MPa" }

# Where the machine wrote force and elongation:
# elongation   = { column = "Extensometer", unit = "mm" }
# gauge_length = "50 mm"
# force        = { column = "Load", unit = "kN" }
# area         = { from = "S0_mm2", unit = "mm^2" }       # a column of this table:
# table        = { file = "info.csv", key = "specimen" }  # a row for each file, by its stem
# strain_rate  = "0.01 1/s"                               # with a rate law, [material.rate]
# group        = ["temperature"]                          # columns whose values form groups
)";

constexpr std::string_view kSceneFit =
    R"(# A fit through a beam: finds Young's modulus, yield stress and break strain of a bar whose end was
# pushed down until it broke, in the scene that will be run with them.
#
#   plastica calibrate scene-fit.toml -o scene-fit.h5
#
# Runs as it is, on bend_test.csv and bend_test.toml beside it. For your own test change `scene` and
# `files`, and say below what the columns are in the scene.
# `#` begins a comment. Quantities stand in quotes with their unit: "355 MPa", "0.2 %".

[fit]
# objective = "path"              # samples count by the displacement that they stand for
# algorithm = "bobyqa"            # one of NLopt's alone, from the start, in place of what follows
# starts = 10                     # searches from the best of `screen` points; 1: from the scene's
# screen = 64                     # own values alone, a tenth of the work, where they are near
# seed   = 1                      # of the points
# profile = true                  # likelihood intervals; bootstrap = 400: resampled ones
# segments = "auto"               # as few as move no value by more than
# within = "0.5 %"
# segments_error = false          # do not repeat the fit with half and twice the segments
# shared = false                  # with several targets: a fit of each, in place of one of all

[fit.parameters]                  # `plastica fields` lists the names; a free one needs its bounds
youngs_modulus = { bounds = ["50 GPa", "500 GPa"] }
yield_stress   = { bounds = ["100 MPa", "2 GPa"] }
break_strain   = { bounds = ["0.01 %", "100 %"] }      # the permanent strain at the break
# poisson_ratio = { value = 0.3, fixed = true }
# tangent_modulus = { bounds = ["1 GPa", "20 GPa"],
#                     prior = { mean = "10 GPa", standard_deviation = "2 GPa" } }

# One [[target]] for each kind of test; a file is a specimen.
[[target]]
scene = "bend_test.toml"          # beside this file
files = ["bend_test.csv"]         # patterns too: "curves/*.csv"

# The second support of the scene, the machine's head, follows the measured displacement, up and down.
# In its place: `probe = "displacement"`, compared along the scene's own path; or `time = true`.
abscissa = { drive = "support[2]", column = "Displacement", unit = "mm" }

# factor = -1: the machine counts against the scene's axis.
ordinate = { probe = "force", column = "Force", unit = "N", factor = -1 }
# noise  = "5 N"                  # standard deviation of the ordinate, where it is known
# weight = 2.0                    # of this target beside others

beam = { segments = 32 }          # what differs from the scene
)";

constexpr std::string_view kCoupon =
    R"(# A coupon: a beam in a uniform state, what it is made of, and how it is deformed.
#
#   plastica simulate coupon.toml -o coupon.csv
#
# Runs as it is. `plastica fields` lists every key with unit, range and default.
# `#` begins a comment. Quantities stand in quotes with their unit: "355 MPa", "0.2 %".

name = "pulled, pushed and pulled until it breaks"

[material]
name         = "S355"             # the base; what follows changes it
yield_stress = "370 MPa"
break_strain = "3 %"              # permanent strain at break; without it nothing breaks
# [material.hardening]
# law = "linear"                  # or "voce_chaboche"; "ideal" is the default
# tangent_modulus = "2 GPa"
# [material.rate]
# law = "cowper_symonds"          # or "johnson_cook" with coefficient
# reference_rate = "40.4 1/s"
# exponent       = 5
# strain_rate    = "1 1/s"        # of all; a motion can do without: each joint has its own

[section]
shape  = "rectangle"              # "circle", "round_tube", "rectangular_tube", "i_section";
                                  # or profile = "IPE 200" in place of all three lines
width  = "20 mm"
height = "40 mm"

[beam]
length   = "1 m"
segments = 10

[rules]
yield_cap     = "first_yield"     # or "fully_plastic"
break_measure = "net"             # or "accumulated": bending to and fro wears out

[drive]
deformation = "tension"           # or "bending", "torsion"; the strain is the extreme fibre's
strain = { turning_points = ["1 %", "-1 %", "4 %"], points_between = 100 }
# strain = [0, "0.1 %", "0.2 %"]                          # sample by sample
# strain = { table = "measured.csv", column = "Strain" }  # a column of a file beside this one

[[probe]]
kind = "strain"

[[probe]]
kind = "stress"

[[probe]]
kind = "plastic_strain"
)";

constexpr std::string_view kScene =
    R"(# A scene: a beam of rigid segments and joints, how it is held, and what acts on it.
#
#   plastica simulate scene.toml -o scene.h5
#
# Runs as it is. `plastica fields` lists the keys with unit, range and default.
# `#` begins a comment. Quantities stand in quotes with their unit: "355 MPa", "0.2 %".
# z runs along the beam, the width along x, the height along y; vectors are [x, y, z].
# A place on the beam is "start", "end", { segment = 3 } (the outer end of that segment), or a
# fraction of the length: 0.25, "25 %".

name = "a cantilever, bent beyond first yield and released"

[beam]
length   = "4 m"
segments = 32                     # or segment_lengths = ["1 m", "0.5 m", ...]
section  = { shape = "rectangle", width = "20 mm", height = "20 mm" }
material = "S355"                 # or { name = "S355", yield_stress = "370 MPa" }
# shape = "arc"                   # arc_angle = "45 deg", arc_towards = "y"
# shape = "polyline"              # points = [["0 m", "0 m", "0 m"], ["0 m", "1 m", "3 m"]]

[rules]
yield_model = "fibre"             # "interaction", "per_axis", "elastic": one moment for a joint
# yield_cap    = "fully_plastic"  # the largest moment of those that are not fibres
# break_limit_x = "3 %"           # permanent strain at which a joint breaks in bending about x
# on_break      = "cut_all"       # "cut_worst", "record_only"

# [solver]
# level = "planar"                # "auto" takes the least level that holds the scene
# steps = 20                      # recorded steps of the path
# analysis = "dynamics"           # a motion in time: it needs a duration, such as "2 s", and may
#                                 # have scheme, time_step, damping, [[initial_motion]] and [[cut]]

# gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
# gravity = { y = "-9.81 m/s^2", history = "constant" }

[[support]]
at   = "start"
kind = "clamp"                    # "pin", "roller", "guide", "elastic", "inclined_roller", "pillar"
# hold = ["x", "y", "z", "rx", "ry", "rz"]                 # if not what the kind holds
# translation = ["0 mm", "5 mm", "0 mm"]                   # moves, times its history

[[load]]
at      = "end"                   # or from and to, and force in N/m: spread between both
force   = ["0 N", "-140 N", "0 N"]
# moment  = ["10 N m", "0 N m", "0 N m"]
# follows = true                  # turns with the beam
history = { turning_points = [1, 0] }
# history = "ramp"                # 0 at time 0, 1 at time 1, and on
# history = "constant"            # 1 from the first
# history = { cycles = 3 }        # three times over 1 and -1, then 0
# history = { time = ["0 s", "2 s"], factor = [0, 1] }      # holds its last factor, as all tables

# [[mass]]                        # a body that the beam carries; gravity acts on it
# at      = "end"
# mass    = "2 kg"
# inertia = ["0.02 kg m^2", "0.02 kg m^2", "0.01 kg m^2"]

[[probe]]
name = "tip"
kind = "displacement"
at   = "end"
component = "y"                   # "x", "z", "size"

[[probe]]
name = "clamp"
kind = "moment"
at   = "start"
component = "x"

[[probe]]
name = "plastic work"
kind = "energy"
energy = "plastic"                # "elastic", "external", "residual"; in time also "kinetic", ...
)";

/// Close to normal, with mean 0 and standard deviation 1: the sum of twelve uniform numbers. Whole
/// numbers and sums alone, so that every machine draws the same.
double draw(std::mt19937_64& engine) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine() >> 11U) * 0x1p-53;
  return sum;
}

}  // namespace

std::string example_curve() {
  constexpr double kModulus = 2000.0;  // MPa per % of strain
  constexpr double kYield = 350.0;     // MPa
  constexpr double kBreak = 2.0 + kYield / kModulus;
  constexpr double kStep = 0.02;  // %
  constexpr int kBroken = 3;      // samples that the machine still writes after the break
  std::mt19937_64 engine(2024);
  std::string text = "Strain (%),Stress (MPa)\n";
  int broken = 0;
  for (int i = 0; broken < kBroken; ++i) {
    const double strain = kStep * i;
    const bool intact = strain < kBreak;
    const double stress = intact ? std::min(kModulus * strain, kYield) + draw(engine) : 0.0;
    text += fmt::format("{:.2f},{:.2f}\n", strain, stress);
    if (!intact) ++broken;
  }
  return text;
}

std::span<const std::string_view> template_kinds() {
  static constexpr std::array<std::string_view, 4> kKinds{"fit", "scene-fit", "scene", "coupon"};
  return kKinds;
}

std::vector<TemplateFile> template_files(std::string_view kind) {
  if (kind == "fit") {
    return {{"fit.toml", std::string(kFit)}, {"example-curve.csv", example_curve()}};
  }
  if (kind == "scene-fit") {
    return {{"scene-fit.toml", std::string(kSceneFit)},
            {"bend_test.toml", std::string(bend_test_scene())},
            {"bend_test.csv", std::string(bend_test_curve())}};
  }
  if (kind == "scene") return {{"scene.toml", std::string(kScene)}};
  if (kind == "coupon") return {{"coupon.toml", std::string(kCoupon)}};
  throw InputError({}, "init", kind, "must be one of fit, scene-fit, scene, coupon");
}

}  // namespace plastica::calibrate
