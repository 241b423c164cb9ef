#include "plastica/model/field_table.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/rate_kind.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica {
namespace model_detail {
namespace {

/// Of the kinds in the order of their enumerators.
template <class Kinds>
std::vector<std::string_view> words_of(const Kinds& kinds) {
  std::vector<std::string_view> words;
  for (const auto* kind : kinds) words.push_back(kind->word());
  return words;
}

}  // namespace

template <>
std::span<const std::string_view> words<SectionShape>() {
  static const std::vector<std::string_view> all = words_of(section_kinds());
  return all;
}
template <>
std::span<const std::string_view> words<HardeningLaw>() {
  static const std::vector<std::string_view> all = words_of(hardening_kinds());
  return all;
}
template <>
std::span<const std::string_view> words<RateLaw>() {
  static const std::vector<std::string_view> all = words_of(rate_kinds());
  return all;
}
template <>
std::span<const std::string_view> words<Deformation>() {
  static constexpr std::array<std::string_view, 3> kWords{"tension", "bending", "torsion"};
  return kWords;
}
template <>
std::span<const std::string_view> words<Formulas>() {
  static constexpr std::array<std::string_view, 2> kWords{"mechanics", "report"};
  return kWords;
}
template <>
std::span<const std::string_view> words<YieldCap>() {
  static constexpr std::array<std::string_view, 2> kWords{"first_yield", "fully_plastic"};
  return kWords;
}
template <>
std::span<const std::string_view> words<BreakMeasure>() {
  static constexpr std::array<std::string_view, 2> kWords{"net", "accumulated"};
  return kWords;
}
template <>
std::span<const std::string_view> words<BreakPolicy>() {
  static constexpr std::array<std::string_view, 3> kWords{"cut_all", "cut_worst", "record_only"};
  return kWords;
}
template <>
std::span<const std::string_view> words<Level>() {
  static constexpr std::array<std::string_view, 5> kWords{"auto", "coupon", "twist", "planar",
                                                          "spatial"};
  return kWords;
}
template <>
std::span<const std::string_view> words<BeamShape>() {
  static constexpr std::array<std::string_view, 3> kWords{"straight", "arc", "polyline"};
  return kWords;
}
template <>
std::span<const std::string_view> words<YieldModel>() {
  static constexpr std::array<std::string_view, 5> kWords{"elastic", "per_axis", "interaction",
                                                          "conservative", "fibre"};
  return kWords;
}
template <>
std::span<const std::string_view> words<EndRule>() {
  static constexpr std::array<std::string_view, 5> kWords{"auto", "half_joint", "equal", "half",
                                                          "three_halves"};
  return kWords;
}
template <>
std::span<const std::string_view> words<JointTranslation>() {
  static constexpr std::array<std::string_view, 2> kWords{"rigid", "elastic"};
  return kWords;
}
template <>
std::span<const std::string_view> words<Precision>() {
  static constexpr std::array<std::string_view, 2> kWords{"double", "float"};
  return kWords;
}
template <>
std::span<const std::string_view> words<InstructionSet>() {
  return kInstructionSets;
}
template <>
std::span<const std::string_view> words<Analysis>() {
  static constexpr std::array<std::string_view, 2> kWords{"statics", "dynamics"};
  return kWords;
}
template <>
std::span<const std::string_view> words<Scheme>() {
  static constexpr std::array<std::string_view, 6> kWords{
      "linearly_implicit_euler", "linearly_implicit_midpoint", "generalized_alpha",
      "energy_momentum",         "articulated_euler",          "articulated_midpoint"};
  return kWords;
}
template <>
std::span<const std::string_view> words<Damping>() {
  static constexpr std::array<std::string_view, 3> kWords{"none", "stiffness", "relaxation"};
  return kWords;
}
template <>
std::span<const std::string_view> words<RotaryInertia>() {
  static constexpr std::array<std::string_view, 2> kWords{"off", "on"};
  return kWords;
}
template <>
std::span<const std::string_view> words<PathControl>() {
  static constexpr std::array<std::string_view, 4> kWords{"auto", "load", "displacement",
                                                          "arc_length"};
  return kWords;
}

namespace {

constexpr Range kAny{};

/// The fields of all kinds, each once.
template <class Kinds, class FieldsOf>
std::vector<Field> fields_of(const Kinds& kinds, const FieldsOf& of) {
  std::vector<Field> all;
  for (const auto* kind : kinds) {
    for (const Field& field : of(*kind)) {
      const bool known =
          std::any_of(all.begin(), all.end(), [&](const Field& f) { return f.path == field.path; });
      if (!known) all.push_back(field);
    }
  }
  return all;
}

std::vector<Field> make_table() {
  using enum Dimension;
  std::vector<Field> table{
      number<PLASTICA_REACH(scene.material.youngs_modulus)>("material.youngs_modulus", Stress,
                                                            kPositive, "Young's modulus E",
                                                            MaterialField::YoungsModulus),
      number<PLASTICA_REACH(scene.material.poisson_ratio)>(
          "material.poisson_ratio", None, Range{-1.0, 0.5, true, false}, "Poisson's ratio",
          MaterialField::PoissonRatio),
      number<PLASTICA_REACH(scene.material.shear_modulus)>(
          "material.shear_modulus", Stress, kPositive, "shear modulus G; unset: E/2(1+nu)",
          MaterialField::ShearModulus),
      number<PLASTICA_REACH(scene.material.density)>("material.density", Density, kPositive,
                                                     "mass density"),
      number<PLASTICA_REACH(scene.material.yield_stress)>("material.yield_stress", Stress,
                                                          kPositive, "initial yield stress",
                                                          MaterialField::YieldStress),
      number<PLASTICA_REACH(scene.material.shear_yield_stress)>(
          "material.shear_yield_stress", Stress, kPositive,
          "yield stress in shear; unset: yield_stress/sqrt(3)", MaterialField::ShearYieldStress),
      number<PLASTICA_REACH(scene.material.break_strain)>(
          "material.break_strain", Strain, kPositive,
          "permanent strain at which a joint breaks; unset: never", MaterialField::BreakStrain),
      number<PLASTICA_REACH(scene.material.break_shear_strain)>(
          "material.break_shear_strain", Strain, kPositive,
          "permanent shear strain at break; unset: sqrt(3) break_strain",
          MaterialField::BreakShearStrain),
      choice<PLASTICA_REACH(scene.material.hardening.law)>(
          "material.hardening.law", "how the stress goes on after first yield"),
      choice<PLASTICA_REACH(scene.material.rate.law)>(
          "material.rate.law", "how the flow stress grows with the rate of the plastic strain"),
      choice<PLASTICA_REACH(scene.section.shape)>("section.shape", "shape of the cross section"),
      number<PLASTICA_REACH(scene.section.shear_coefficient)>(
          "section.shear_coefficient", None, kPositive, "kappa; unset: from shape and nu"),
      number<PLASTICA_REACH(scene.beam.length)>("beam.length", Length, kPositive,
                                                "length of the beam"),
      integer<PLASTICA_REACH(scene.beam.segments)>("beam.segments", Range{1.0, 1e7},
                                                   "number of rigid segments"),
      choice<PLASTICA_REACH(scene.beam.shape)>("beam.shape", "of the undeformed axis"),
      number<PLASTICA_REACH(scene.beam.arc_angle)>("beam.arc_angle", Angle, kNotNegative,
                                                   "arc: the angle from start to end"),
      choice<PLASTICA_REACH(scene.drive.deformation)>("drive.deformation",
                                                      "what the strain history does"),
      choice<PLASTICA_REACH(scene.formulas)>("rules.formulas",
                                             "mechanics, or Wendelius' formulas to the letter"),
      choice<PLASTICA_REACH(scene.yield_model)>("rules.yield_model",
                                                "how the stresses of a chain's joint yield "
                                                "together; per_axis leaves the axial force out"),
      choice<PLASTICA_REACH(scene.yield_cap)>("rules.yield_cap",
                                              "largest moment of an ideal joint"),
      choice<PLASTICA_REACH(scene.end_rule)>(
          "rules.end_rule", "how held ends and end segments are joined; auto: half_joint"),
      choice<PLASTICA_REACH(scene.break_measure)>(
          "rules.break_measure", "which permanent strain is held against the limit"),
      choice<PLASTICA_REACH(scene.on_break)>("rules.on_break",
                                             "what happens to a joint over its limit"),
      number<PLASTICA_REACH(scene.break_limit_x)>(
          "rules.break_limit_x", Strain, kPositive,
          "permanent strain at break, bending about x; unset: the material's"),
      number<PLASTICA_REACH(scene.break_limit_y)>(
          "rules.break_limit_y", Strain, kPositive,
          "permanent strain at break, bending about y; unset: the material's"),
      number<PLASTICA_REACH(scene.break_limit_z)>(
          "rules.break_limit_z", Strain, kPositive,
          "permanent shear strain at break, torsion; unset: the material's"),
      number<PLASTICA_REACH(scene.hinge_length)>("rules.hinge_length", Length, kNotNegative,
                                                 "length over which a hinge's rotation is strain; "
                                                 "unset: the depth in the plane of bending; 0: "
                                                 "the joint's own"),
      number<PLASTICA_REACH(scene.gravity[0])>("gravity.x", Acceleration, kAny,
                                               "acceleration of gravity along x"),
      number<PLASTICA_REACH(scene.gravity[1])>("gravity.y", Acceleration, kAny,
                                               "acceleration of gravity along y"),
      number<PLASTICA_REACH(scene.gravity[2])>("gravity.z", Acceleration, kAny,
                                               "acceleration of gravity along z"),
      choice<PLASTICA_REACH(solver.level)>("solver.level", "how much of the beam is modelled"),
      choice<PLASTICA_REACH(solver.analysis)>("solver.analysis",
                                              "a path of equilibria, or a motion in time"),
      choice<PLASTICA_REACH(solver.translation)>("solver.translation",
                                                 "stretch and shear of the joints"),
      choice<PLASTICA_REACH(solver.precision)>("solver.precision",
                                               "numbers that a chain is computed with"),
      choice<PLASTICA_REACH(solver.isa)>(
          "solver.isa",
          "vector instructions of articulated schemes and batches at rest; auto: the widest"),
      integer<PLASTICA_REACH(solver.fibres)>("solver.fibres", Range{2.0, 1e4},
                                             "fibres of a fibre section, along its depth"),
      number<PLASTICA_REACH(solver.duration)>(
          "solver.duration", Time, kNotNegative,
          "end of path or motion; 0: where the last history ends"),
      integer<PLASTICA_REACH(solver.steps)>("solver.steps", Range{1.0, 1e7},
                                            "recorded samples, evenly spaced in time"),
      integer<PLASTICA_REACH(solver.frames)>(
          "solver.frames", Range{0.0, 1e7},
          "samples of which the shape is kept, evenly spaced; 0: all"),
      choice<PLASTICA_REACH(solver.scheme)>("solver.scheme", "dynamics: how time is stepped"),
      number<PLASTICA_REACH(solver.time_step)>("solver.time_step", Time, kPositive,
                                               "dynamics: the step; adaptive: the largest one"),
      number<PLASTICA_REACH(solver.step_error)>("solver.step_error", None, kNotNegative,
                                                "dynamics: largest error of a segment's place or "
                                                "twist in a step, over the length; 0: fixed"),
      number<PLASTICA_REACH(solver.rho_infinity)>(
          "solver.rho_infinity", None, Range{0.0, 1.0},
          "generalized_alpha: what a step leaves of the highest frequencies"),
      choice<PLASTICA_REACH(solver.rotary_inertia)>(
          "solver.rotary_inertia",
          "dynamics: whether sections resist bending rotation by their own inertia"),
      choice<PLASTICA_REACH(solver.damping)>("solver.damping",
                                             "dynamics: what damps the joints besides yielding"),
      number<PLASTICA_REACH(solver.damping_time)>("solver.damping_time", Time, kNotNegative,
                                                  "damped moment: this times the rate"),
      choice<PLASTICA_REACH(solver.control)>("solver.control", "how the path is followed"),
      integer<PLASTICA_REACH(solver.buckling)>(
          "solver.buckling", Range{0.0, 1000.0},
          "statics: how many buckling factors and modes about the loaded state"),
      integer<PLASTICA_REACH(solver.frequencies)>(
          "solver.frequencies", Range{0.0, 1000.0},
          "statics: how many natural frequencies and modes about the loaded state"),
      integer<PLASTICA_REACH(solver.max_iterations)>("solver.max_iterations", Range{1.0, 1e4},
                                                     "Newton iterations before a step is cut back"),
      number<PLASTICA_REACH(solver.tolerance)>("solver.tolerance", None,
                                               Range{0.0, 1.0, true, true},
                                               "largest imbalance of a converged step, relative"),
      number<PLASTICA_REACH(solver.largest_rotation)>(
          "solver.largest_rotation", Angle, kPositive,
          "largest rotation of a joint in one step; in statics, a fifth of a segment's"),
      number<PLASTICA_REACH(solver.smallest_step)>(
          "solver.smallest_step", None, Range{0.0, 1.0, true, false},
          "shortest part of a recorded step, or of time_step"),
  };
  const auto insert_after = [&](std::string_view path, const std::vector<Field>& more) {
    const auto place = std::find_if(table.begin(), table.end(),
                                    [&](const Field& field) { return field.path == path; });
    table.insert(place + 1, more.begin(), more.end());
  };
  insert_after(
      "material.hardening.law",
      fields_of(hardening_kinds(), [](const HardeningKind& kind) { return kind.parameters(); }));
  insert_after("material.rate.law",
               fields_of(rate_kinds(), [](const RateKind& kind) { return kind.parameters(); }));
  insert_after("section.shape", fields_of(section_kinds(), [](const SectionKind& kind) {
                 return kind.dimensions();
               }));
  return table;
}

}  // namespace
}  // namespace model_detail

std::span<const Field> fields() {
  static const std::vector<Field> table = model_detail::make_table();
  return table;
}

}  // namespace plastica
