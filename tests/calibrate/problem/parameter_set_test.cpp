#include "calibrate/problem/parameter_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

Target steel(Deformation test = Deformation::Tension) {
  const std::vector<double> strain = ramp(41, 0.02);
  return target_of(strain, ideal_curve(strain, 200e9, 300e6), test);
}

Target broken_steel(Deformation test = Deformation::Tension) {
  Target target = steel(test);
  break_at(target, 0.0205, 0.0187);
  return target;
}

TEST(ParameterSet, MovesTheFreeOnesAlone) {
  const ParameterSet set(steel(), fit_of({fixed_parameter("youngs_modulus", 190e9),
                                          free_parameter("yield_stress", 250e6),
                                          tied_parameter("shear_yield_stress", "yield_stress", 0.6),
                                          tied_parameter("shear_modulus", "youngs_modulus", 0.4)}));
  ASSERT_EQ(set.active().size(), 1U);
  EXPECT_EQ(set.active()[0], 1U);
  std::vector<double> all(4);
  set.expand(std::vector<double>{310e6}, all);
  EXPECT_EQ(all, (std::vector<double>{190e9, 310e6, 0.6 * 310e6, 0.4 * 190e9}));
  EXPECT_EQ(set.all()[2].start, 0.6 * 250e6);
}

TEST(ParameterSet, SumsDerivativesOverTies) {
  const ParameterSet set(steel(),
                         fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                                 tied_parameter("shear_yield_stress", "yield_stress", 0.6),
                                 fixed_parameter("poisson_ratio", 0.3),
                                 tied_parameter("kinematic_fraction", "poisson_ratio", 2.0)}));
  std::vector<double> by(2, -1.0);
  set.contract(std::vector<double>{3.0, 5.0, 10.0, 100.0, 1000.0}, by);
  EXPECT_EQ(by, (std::vector<double>{3.0, 11.0}));
}

TEST(ParameterSet, TiesMayPrecedeWhatTheyFollow) {
  const ParameterSet set(steel(), fit_of({tied_parameter("shear_yield_stress", "yield_stress", 0.5),
                                          free_parameter("yield_stress", 300e6)}));
  EXPECT_EQ(set.all()[0].start, 150e6);
  EXPECT_EQ(set.all()[0].base, 1U);
}

TEST(ParameterSet, CoordinatesAreLogarithmsWhereBoundsArePositive) {
  Parameter modulus = free_parameter("youngs_modulus", 300e6);
  modulus.lower = 100e6;
  modulus.upper = 900e6;
  const ParameterSet set(steel(), fit_of({modulus}));
  EXPECT_TRUE(set.all()[0].logarithmic);
  EXPECT_NEAR(set.lower(0), -std::log(3.0), 1e-15);
  EXPECT_NEAR(set.upper(0), std::log(3.0), 1e-15);
  EXPECT_EQ(set.coordinate(0, 300e6), 0.0);
  EXPECT_NEAR(set.value(0, std::log(2.0)), 600e6, 1e-6);
  EXPECT_EQ(set.value(0, 5.0), 900e6);  // never beyond a bound
  EXPECT_EQ(set.value(0, -5.0), 100e6);
  EXPECT_EQ(set.slope(0, 450e6), 450e6);
}

TEST(ParameterSet, CoordinatesAreFractionsOfTheStartOnALinearScale) {
  Parameter modulus = free_parameter("youngs_modulus", 300e6);
  modulus.lower = 100e6;
  modulus.upper = 900e6;
  modulus.scale = ParameterScale::Linear;
  Parameter fraction = free_parameter("kinematic_fraction", 0.0);
  const ParameterSet set(steel(), fit_of({modulus, fraction}));
  EXPECT_FALSE(set.all()[0].logarithmic);
  EXPECT_NEAR(set.lower(0), -2.0 / 3.0, 1e-15);
  EXPECT_NEAR(set.upper(0), 2.0, 1e-15);
  EXPECT_EQ(set.slope(0, 450e6), 300e6);
  // A start of zero has no size: the box has.
  EXPECT_FALSE(set.all()[1].logarithmic);
  EXPECT_EQ(set.coordinate(1, 0.25), 0.25);
}

TEST(ParameterSet, SearchesNoYieldStressAboveTheLargestMeasuredStress) {
  Parameter yield = free_parameter("yield_stress", 200e6);
  yield.lower = 100e6;
  yield.upper = 900e6;
  const Target target = steel();
  const double largest =
      *std::max_element(target.corrected.stress.begin(), target.corrected.stress.end());
  const ParameterSet set(target, fit_of({yield}));
  EXPECT_EQ(set.all()[0].upper, 900e6);
  EXPECT_EQ(set.all()[0].search_upper, largest);
  EXPECT_NEAR(set.upper(0), std::log(largest / 200e6), 1e-14);
  // Bounds above it are the user's own business.
  yield.lower = 2.0 * largest;
  yield.value = 3.0 * largest;
  EXPECT_EQ(ParameterSet(target, fit_of({yield})).all()[0].search_upper, 900e6);
}

TEST(ParameterSet, ValueAndCoordinateAreInverse) {
  const ParameterSet set(
      steel(), fit_of({free_parameter("youngs_modulus"), free_parameter("tangent_modulus")}));
  for (std::size_t i = 0; i < 2; ++i) {
    const double start = set.all()[i].start;
    for (const double value : {start * 0.3 + 1e7, start * 1.7 + 1e7}) {
      EXPECT_NEAR(set.value(i, set.coordinate(i, value)), value, 1e-13 * value);
    }
  }
}

TEST(ParameterSet, ABoundGivenAloneKeepsRoomWithinTheFieldsRange) {
  const auto resolved = [](Parameter p, std::optional<double> lower, std::optional<double> upper) {
    p.lower = lower;
    p.upper = upper;
    return ParameterSet(steel(), fit_of({p})).all()[0];
  };
  const ResolvedParameter high = resolved(free_parameter("yield_stress"), 50e9, {});
  EXPECT_EQ(high.lower, 50e9);
  EXPECT_EQ(high.upper, 30.0 * 50e9);
  EXPECT_EQ(high.start, 50e9);
  const ResolvedParameter low = resolved(free_parameter("yield_stress"), {}, 3e6);
  EXPECT_EQ(low.lower, 1e5);
  EXPECT_EQ(low.start, 3e6);
  const ResolvedParameter fraction = resolved(free_parameter("kinematic_fraction"), 0.3, {});
  EXPECT_EQ(fraction.lower, 0.3);
  EXPECT_EQ(fraction.upper, 1.0);
  const ResolvedParameter softening = resolved(free_parameter("saturation_stress"), {}, -1e6);
  EXPECT_EQ(softening.lower, -30e6);
  EXPECT_EQ(softening.upper, -1e6);
  EXPECT_FALSE(softening.logarithmic);
}

TEST(ParameterSet, RefusesBoundsWithoutRoomAndALogarithmFromZero) {
  Parameter fraction = free_parameter("kinematic_fraction");
  fraction.lower = 1.0;
  EXPECT_EQ(message_of([&] { ParameterSet(steel(), fit_of({fraction})); }),
            "kinematic_fraction = [1, 1]: the bounds leave no room: give both");
  Parameter tangent = free_parameter("tangent_modulus");
  tangent.scale = ParameterScale::Logarithmic;
  EXPECT_EQ(message_of([&] { ParameterSet(steel(), fit_of({tangent})); }),
            "tangent_modulus = 0: a logarithmic scale needs a lower bound above 0");
}

TEST(ParameterSet, AStartBeyondTheDefaultBoundsWidensThem) {
  const ParameterSet set(steel(), fit_of({free_parameter("yield_stress", 1e12)}));
  EXPECT_EQ(set.all()[0].start, 1e12);
  EXPECT_EQ(set.all()[0].upper, 1e12);
}

/// Names of the active parameters.
std::string active_of(const Target& target, const FitOptions& options) {
  const ParameterSet set(target, options);
  std::string names;
  for (const std::size_t i : set.active()) names += options.parameters[i].name() + " ";
  return names;
}

TEST(ParameterSet, BreakStrainIsIdleWithoutABreakOrItsWeight) {
  FitOptions options = fit_of({free_parameter("yield_stress"), free_parameter("break_strain")});
  EXPECT_EQ(active_of(steel(), options), "yield_stress ");
  EXPECT_EQ(active_of(broken_steel(), options), "yield_stress break_strain ");
  options.break_weight = 0.0;
  EXPECT_EQ(active_of(broken_steel(), options), "yield_stress ");
}

TEST(ParameterSet, EachTestHasItsOwnBreakLimit) {
  FitOptions both = fit_of({free_parameter("yield_stress"), free_parameter("break_strain"),
                            free_parameter("break_shear_strain")});
  EXPECT_EQ(active_of(broken_steel(), both), "yield_stress break_strain ");
  EXPECT_EQ(active_of(broken_steel(Deformation::Bending), both), "yield_stress break_strain ");
  EXPECT_EQ(active_of(broken_steel(Deformation::Torsion), both),
            "yield_stress break_shear_strain ");

  FitOptions one = fit_of({free_parameter("yield_stress"), free_parameter("break_strain")});
  const ParameterSet torsion(broken_steel(Deformation::Torsion), one);
  ASSERT_TRUE(torsion.break_parameter());
  EXPECT_EQ(torsion.break_parameter()->factor, std::sqrt(3.0));
  EXPECT_EQ(ParameterSet(broken_steel(), one).break_parameter()->factor, 1.0);
  one.setup.scene.formulas = Formulas::Report;
  EXPECT_EQ(ParameterSet(broken_steel(Deformation::Torsion), one).break_parameter()->factor, 1.0);
  one.setup.scene.material.break_shear_strain = 0.3;
  EXPECT_EQ(active_of(broken_steel(Deformation::Torsion), one), "yield_stress ");
}

TEST(ParameterSet, ATiedBreakLimitStandsForWhatItFollows) {
  const FitOptions options = fit_of({free_parameter("yield_stress"), free_parameter("break_strain"),
                                     tied_parameter("break_shear_strain", "break_strain", 2.0)});
  EXPECT_EQ(active_of(broken_steel(), options), "yield_stress break_strain ");
  EXPECT_EQ(ParameterSet(broken_steel(), options).break_parameter()->factor, 1.0);
  const ParameterSet torsion(broken_steel(Deformation::Torsion), options);
  EXPECT_EQ(torsion.active().size(), 2U);
  EXPECT_EQ(torsion.break_parameter()->index, 1U);
  EXPECT_EQ(torsion.break_parameter()->factor, 2.0);
}

TEST(ParameterSet, AFitNamesTheParametersThatItMoved) {
  // Fixed, tied and idle ones stay: this specimen did not break.
  const std::vector<double> strain = ramp(41, 0.02);
  const FitResult result =
      fit_target(target_of(strain, ideal_curve(strain, 200e9, 300e6)),
                 fit_of({free_parameter("break_strain"), fixed_parameter("youngs_modulus", 200e9),
                         free_parameter("yield_stress"),
                         tied_parameter("shear_yield_stress", "yield_stress", 0.6)}));
  EXPECT_EQ(result.trace.active, std::vector<std::uint32_t>{2});
  EXPECT_EQ(result.correlation.size(), 1U);
  EXPECT_EQ(result.trace.values.size(), result.trace.costs.size());
}

}  // namespace
}  // namespace plastica::calibrate
