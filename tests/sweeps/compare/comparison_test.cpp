#include "sweeps/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "sweeps/compare/convergence.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/made_sweep.hpp"

namespace plastica::sweeps {
namespace {

TEST(RefinementGroups, HoldCasesFromCoarseToFine) {
  const Made made(segments_axis("[16, 4, 8]") +
                      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n" +
                      against("finest"),
                  {1, 2, 3, 4, 5, 6});
  ASSERT_EQ(made.groups.size(), 2U);
  EXPECT_EQ(made.groups[0].label, "rules.end_rule = half_joint");
  EXPECT_EQ(made.groups[0].cases, (std::vector<std::size_t>{2, 4, 0}));
  EXPECT_EQ(made.groups[0].size, (std::vector<double>{1.0 / 4, 1.0 / 8, 1.0 / 16}));
  EXPECT_EQ(made.groups[1].cases, (std::vector<std::size_t>{3, 5, 1}));
}

TEST(RefinementGroups, MoveZippedAxesWithTheRefinedOne) {
  const Made made(
      "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
      "[[axis]]\nfield = 'solver.steps'\nvalues = [10, 20]\nzip = 'a'\n" +
          against("finest"),
      {1, 2});
  ASSERT_EQ(made.groups.size(), 1U);
  EXPECT_EQ(made.groups[0].label, "");
}

TEST(RefinementGroups, KeepCasesOfOneSizeAndCountThemOnce) {
  const Made made(
      "[[axis]]\nfield = 'beam.segment_depth'\nvalues = [50, 25.1, 25]\n" + against("value:1 m"),
      {1.5, 1.125, 1.125});
  // 4 m of 20 mm: 4, 8 and 8 segments.
  EXPECT_EQ(made.groups[0].cases, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(made.groups[0].distinct(), (std::vector<std::size_t>{0, 1}));
  const GroupConvergence found = convergence_of(made.groups[0], made.results, made.compared());
  EXPECT_EQ(found.fit.points, 2U);
  EXPECT_NEAR(found.fit.order.value_or(0.0), 2.0, 1e-12);
}

TEST(RefinementGroups, AreToldApartByZippedAxesThatDoNotRefine) {
  const Made made(
      "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8, 4, 8]\nzip = 'a'\n"
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'half_joint', 'equal', "
      "'equal']\n"
      "zip = 'a'\n" +
          against("finest"),
      {1, 2, 3, 4});
  ASSERT_EQ(made.groups.size(), 2U);
  EXPECT_EQ(made.groups[1].label, "rules.end_rule = equal");
  EXPECT_EQ(made.groups[1].cases, (std::vector<std::size_t>{2, 3}));
}

TEST(RefinementGroups, AreNotMadeOfSamples) {
  const Sweep sweep = cantilever_sweep(
      "[sample]\nmethod = 'sobol'\ncount = 4\n"
      "[[axis]]\nfield = 'beam.segments'\nsampled = [4, 40]\n"
      "[[axis]]\nfield = 'beam.length'\nsampled = ['1 m', '4 m']\n" +
      kTipError);
  EXPECT_FALSE(sweep.refined.has_value());
}

TEST(Compare, TakesTheFinestThatHasAValue) {
  const Made made(segments_axis("[4, 8, 16]") + against("finest"), {2.2, 2.0, kNone});
  const Comparison comparison = made.compared();
  EXPECT_NEAR(comparison.error[0].value_or(0.0), 0.1, 1e-15);
  EXPECT_FALSE(comparison.error[1].has_value());
  EXPECT_EQ(comparison.reason[1], "is the finest, the reference of its group");
  EXPECT_FALSE(comparison.error[2].has_value());
}

TEST(Compare, ExtrapolatesAfterRichardson) {
  // 2 + 8 h^2 at h = 1/4, 1/8, 1/16.
  const Made made(segments_axis("[4, 8, 16]") + against("richardson"), {2.5, 2.125, 2.03125});
  const Comparison comparison = made.compared();
  EXPECT_NEAR(comparison.reference[0].value_or(0.0), 2.0, 1e-12);
  EXPECT_NEAR(comparison.error[0].value_or(0.0), 0.25, 1e-12);
}

// Equal swings have the order 0, by which the limit would be anywhere.
TEST(Compare, ExtrapolatesNothingThatGoesToAndFro) {
  const Made made(segments_axis("[4, 8, 16]") + against("richardson"), {1.196, 0.957, 1.196});
  const Comparison comparison = made.compared();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(comparison.error[i].has_value());
}

TEST(Compare, SaysWhereNothingCanBeExtrapolated) {
  const Made made(segments_axis("[4, 8, 16]") + against("richardson"), {1.0, 2.0, 4.0});
  EXPECT_EQ(made.compared().reason[0],
            "nothing can be extrapolated: it takes three values that converge from one side, no "
            "faster than with order 2");
}

TEST(Compare, TakesAValueAndAScale) {
  const Made made(segments_axis("[4]") + against("value:2 m"), {1.5});
  EXPECT_DOUBLE_EQ(made.compared().error[0].value_or(0.0), -0.25);
  const Made scaled(segments_axis("[4]") + against("value:2 m") + "scale = '500 mm'\n", {1.5});
  EXPECT_DOUBLE_EQ(scaled.compared().error[0].value_or(0.0), -1.0);
  const Made zero(segments_axis("[4]") + against("value:0 m"), {1.5});
  EXPECT_EQ(zero.compared().reason[0], "the reference is 0: give error.scale");
  EXPECT_EQ(made.record().against, "value:2 m");
}

TEST(Compare, SaysWhereAClosedFormDoesNotShear) {
  const std::string axis = "[[axis]]\nfield = 'solver.translation'\nvalues = ";
  EXPECT_TRUE(
      Made(axis + "['rigid']\n" + against("theory:elastica"), {1.0}).compared().notes.empty());
  const Made both(axis + "['rigid', 'elastic']\n" + against("theory:elastica"), {1.0, 1.0});
  EXPECT_EQ(both.compared().notes,
            std::vector<std::string>{"the closed form does not shear: the error of cases with "
                                     "solver.translation = \"elastic\" is the shear's, too"});
}

TEST(Compare, TakesTheRmsOfCurves) {
  Made made(
      segments_axis("[4, 8]") + "[error]\nprobe = 'tip'\ntake = 'curve'\nagainst = 'finest'\n",
      {kNone, kNone});
  made.results[1].time = {0.0, 1.0, 2.0};
  made.results[1].curve = {3.0, 3.0, 3.0};
  made.results[0].time = {0.0, 0.5, 2.0};
  made.results[0].curve = {3.3, 3.3, 3.3};
  EXPECT_NEAR(made.compared().error[0].value_or(0.0), 0.1, 1e-12);
  EXPECT_EQ(made.compared().reference_curve[0], std::vector<double>(3, 3.0));
  EXPECT_TRUE(made.compared().reference_curve[1].empty());
  made.results[0].time = {0.0, 1.0, 2.5};
  EXPECT_EQ(made.compared().reason[0], "the reference does not reach over the case's times");
}

// A path beyond its peak comes back to loads that it had: there is no one value at a load.
TEST(Compare, SaysWhereTheLoadFallsAlongThePath) {
  const std::string why =
      "the load falls along the path, so that it has several values at one load";
  Made made(
      segments_axis("[4, 8]") + "[error]\nprobe = 'tip'\ntake = 'curve'\nagainst = 'finest'\n",
      {kNone, kNone});
  made.results[1].time = {0.0, 1.0, 0.5, 2.0};
  made.results[1].curve = {3.0, 3.0, 3.0, 3.0};
  made.results[0].time = {0.0, 1.0, 2.0};
  made.results[0].curve = {3.3, 3.3, 3.3};
  EXPECT_EQ(made.compared().reason[0], why);
  EXPECT_FALSE(made.compared().error[0].has_value());
  std::swap(made.results[0].time, made.results[1].time);
  std::swap(made.results[0].curve, made.results[1].curve);
  EXPECT_EQ(made.compared().reason[0], why);
  Made stored(segments_axis("[4]") + kTipError, {-2.0});
  stored.sweep.against = {
      .kind = AgainstKind::File, .time = {0.0, 1.0, 0.5}, .curve = {0.0, -1.0, -5.0}};
  stored.results[0].last_time = 0.5;
  EXPECT_EQ(stored.compared().reason[0], why);
}

// A reference that goes on is taken as far as the case goes.
TEST(Compare, TakesAStoredCurveUpToTheCasesEnd) {
  Made made(segments_axis("[4]") + kTipError, {-2.0});
  made.sweep.against = {
      .kind = AgainstKind::File, .time = {0.0, 1.0, 3.0}, .curve = {0.0, -1.0, -5.0}};
  made.results[0].last_time = 1.5;
  EXPECT_DOUBLE_EQ(made.compared().reference[0].value_or(0.0), -2.0);
  made.sweep.quantity.take = Take::Mean;
  EXPECT_DOUBLE_EQ(made.compared().reference[0].value_or(0.0), -1.25 / 1.5);
  made.sweep.quantity.take = Take::Size;
  EXPECT_DOUBLE_EQ(made.compared().reference[0].value_or(0.0), 2.0);
  made.results[0].last_time = 3.5;
  EXPECT_EQ(made.compared().reason[0], "the reference does not reach over the case's times");
  EXPECT_FALSE(made.compared().error[0].has_value());
}

// A sine of eight periods, exact in the case; straight lines between n rows a period are off by
// (2 pi/n)^2 sqrt(1/120) of its rms.
TEST(Compare, SaysWhatTheRowsOfAStoredCurveLeaveOut) {
  const auto made_of = [](int rows, int samples) {
    Made made(
        segments_axis("[4, 8]") + "[error]\nprobe = 'tip'\ntake = 'curve'\nagainst = 'finest'\n",
        {kNone, kNone});
    const auto sine = [](int n, std::vector<double>& time, std::vector<double>& curve) {
      time.clear();
      curve.clear();
      for (int k = 0; k <= 8 * n; ++k) {
        time.push_back(static_cast<double>(k) / n);
        curve.push_back(std::sin(2.0 * std::numbers::pi * time.back()));
      }
    };
    made.sweep.against = {.kind = AgainstKind::File};
    sine(rows, made.sweep.against.time, made.sweep.against.curve);
    sine(samples, made.results[0].time, made.results[0].curve);
    return made.compared();
  };
  const Comparison coarse = made_of(16, 160);
  const double exact = std::pow(2.0 * std::numbers::pi / 16.0, 2) / std::sqrt(120.0);
  EXPECT_NEAR(coarse.error[0].value_or(0.0), exact, 0.05 * exact);
  ASSERT_EQ(coarse.notes.size(), 1U);
  EXPECT_TRUE(
      coarse.notes[0].starts_with("the reference is drawn straight between its 129 rows, "
                                  "which leaves out about 1.4 %"))
      << coarse.notes[0];
  EXPECT_TRUE(made_of(16, 16).notes.empty());  // at its rows it is what it is
  EXPECT_TRUE(made_of(160, 100).notes.empty());
}

TEST(Compare, HasNoErrorOfARunThatEndedBeforeItsClosedForm) {
  Made made(segments_axis("[4]") + kTipError, {-0.7353007});
  made.results[0].status = Status::Broken;
  EXPECT_FALSE(made.compared().error[0].has_value());
  EXPECT_EQ(made.compared().reason[0], "its run ended early, and the closed form is of the end");
}

TEST(Compare, ComparesWithAClosedForm) {
  const Made made(segments_axis("[4]") + kTipError, {-0.7353007});
  EXPECT_LT(std::abs(made.compared().error[0].value_or(1.0)), 1e-6);
}

TEST(CheckReference, RefusesAFormThatDoesNotHold) {
  const Made made("[set]\ngravity.y = '-9.81 m/s^2'\n" + segments_axis("[4]") + kTipError, {0.0});
  const std::string message =
      plastica::testing::message_of([&] { check_reference(made.sweep, made.cases); });
  EXPECT_NE(message.find("error.against = theory:elastica: is for one load, at the beam's end"),
            std::string::npos)
      << message;
}

TEST(CheckReference, RefusesAFormThatIsNone) {
  const Made made(segments_axis("[4]") + against("theory:elastico"), {0.0});
  const std::string message =
      plastica::testing::message_of([&] { check_reference(made.sweep, made.cases); });
  EXPECT_NE(message.find("theory:elastico: is not a closed form; there are elastica"),
            std::string::npos)
      << message;
}

TEST(ConvergenceOf, SeesTheOrderOfErrorsAndOfValues) {
  const Made made(segments_axis("[4, 8, 16]") + against("value:2 m"), {2.5, 2.125, 2.03125});
  const GroupConvergence found = convergence_of(made.groups[0], made.results, made.compared());
  EXPECT_NEAR(found.fit.order.value_or(0.0), 2.0, 1e-12);
  EXPECT_NEAR(found.pairwise[1].value_or(0.0), 2.0, 1e-12);
  ASSERT_TRUE(found.grid.has_value());
  EXPECT_NEAR(found.grid->extrapolated.value_or(0.0), 2.0, 1e-12);
}

}  // namespace
}  // namespace plastica::sweeps
