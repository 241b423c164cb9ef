#include "calibrate/config/templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

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
objective = "strain-path"         # or "least-squares", with noise = "1 MPa"
# break_weight = 1.0              # how much the break counts beside the curve
# algorithm    = "auto"           # a global stage, then a local one; or one of NLopt's by name
# seed         = 1                # of the global stage
# confidence   = "95 %"           # of the intervals

[fit.parameters]                  # `plastica fields` lists the names that may stand here
youngs_modulus = {}               # free, bounds from the curve; or { value = "200 GPa", fixed = true }
yield_stress   = { bounds = ["10 MPa", "2 GPa"] }
break_strain   = { bounds = ["0.1 %", "100 %"] }       # the permanent strain at break
# shear_yield_stress = { tie = "yield_stress", factor = 0.577 }

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
# group        = ["temperature"]                          # columns whose values form groups
)";

constexpr std::string_view kScene =
    R"(# A scene: a beam, what it is made of, and how it is deformed.
#
#   plastica simulate scene.toml -o scene.csv
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

[section]
shape  = "rectangle"              # or "circle", "round_tube", "rectangular_tube"
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
quantity = "strain"

[[probe]]
quantity = "stress"

[[probe]]
quantity = "plastic_strain"
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
    const bool whole = strain < kBreak;
    const double stress = whole ? std::min(kModulus * strain, kYield) + draw(engine) : 0.0;
    text += fmt::format("{:.2f},{:.2f}\n", strain, stress);
    if (!whole) ++broken;
  }
  return text;
}

std::span<const std::string_view> template_kinds() {
  static constexpr std::array<std::string_view, 2> kKinds{"fit", "scene"};
  return kKinds;
}

std::vector<TemplateFile> template_files(std::string_view kind) {
  if (kind == "fit") {
    return {{"fit.toml", std::string(kFit)}, {"example-curve.csv", example_curve()}};
  }
  if (kind == "scene") return {{"scene.toml", std::string(kScene)}};
  throw InputError({}, "init", kind, "must be one of fit, scene");
}

}  // namespace plastica::calibrate
