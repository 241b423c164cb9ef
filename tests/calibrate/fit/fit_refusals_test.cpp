#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

/// What a fit says where it finds less than was asked for, or nothing.
namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

TEST(Fit, SaysWhatIsAtABound) {
  FitOptions options = fit_with(HardeningLaw::Ideal);
  options.parameters[1].upper = 250e6;
  const FitResult result =
      fit_target(target_like(options, Deformation::Tension, ramp(90, 0.02)), options);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  EXPECT_TRUE(result.parameter("yield_stress").at_upper);
  EXPECT_FALSE(result.parameter("yield_stress").at_lower);
  EXPECT_FALSE(result.parameter("youngs_modulus").at_upper);
  EXPECT_EQ(result.parameter("yield_stress").value, 250e6);
  EXPECT_EQ(std::count(result.warnings.begin(), result.warnings.end(),
                       "yield_stress is at its upper bound"),
            1);
}

TEST(Fit, SaysWhenTheSpecimenDidNotBreak) {
  const FitOptions options = fit_with(HardeningLaw::Ideal, {free_parameter("break_strain")});
  const FitResult result =
      fit_target(target_like(options, Deformation::Tension, ramp(90, 0.02)), options);
  EXPECT_FALSE(result.parameter("break_strain").identified);
  EXPECT_FALSE(result.break_strain_total);
  EXPECT_EQ(result.fitted.size(), 90U);
  EXPECT_NEAR(result.fitted.stress.back(), 317e6, tolerance(400.0));
  EXPECT_EQ(
      result.warnings,
      std::vector<std::string>{
          "break_strain is not identified: the record ends under load at 2 % strain, at 100 % "
          "of the largest stress; if the specimen broke there, say so by "
          "corrections.end_fraction = \"100 %\""});
}

/// Not what its end would be advised to be, which has no use there.
TEST(Fit, SaysWhyABreakWasNotSeen) {
  const FitOptions options = fit_with(HardeningLaw::Ideal, {free_parameter("break_strain")});
  const auto why = [&](const std::function<void(Target&)>& change) {
    Target target = target_like(options, Deformation::Tension, ramp(90, 0.02));
    change(target);
    return fit_target(target, options).warnings.at(0);
  };
  const std::string is_not = "break_strain is not identified: ";
  EXPECT_EQ(why([](Target& t) {
              t.repairs.push_back({"extensometer-removed", 9, ""});
            }),
            is_not + "the load goes on where the strain ends, at 2 % strain");
  EXPECT_EQ(why([](Target& t) {
              t.repairs.push_back({"extensometer-removed", 9, ""});
              t.ends_at_neck = true;
            }),
            is_not + "true strain is known no further than Rm, at 2 % strain");
  EXPECT_EQ(why([](Target& t) { t.ran_back = true; }),
            is_not + "the strain ran back before, beyond 2 % strain");
}

TEST(Fit, SaysWhenTheModelCannotFollow) {
  // A curve that doubles its stress after yield, fitted by ideal plasticity.
  const std::vector<double> strain = ramp(90, 0.05);
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(600e6 * (1.0 - std::exp(-60.0 * e)));
  const FitResult result = fit_target(target_of(strain, stress), fit_with(HardeningLaw::Ideal));
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  EXPECT_EQ(result.misfit_word, "poor");
  EXPECT_NEAR(result.misfit_fraction, result.misfit_rms / stress.back(), tolerance(1e-12));
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(result.warnings[0].ends_with("; try --laws ideal,linear,voce")) << result.warnings[0];
}

TEST(Fit, ARejectedTargetKeepsItsReason) {
  Target target = target_of({0.0, 0.01}, {0.0, 1e8});
  for (const TargetStatus status : {TargetStatus::Rejected, TargetStatus::TooCoarse}) {
    target.status = status;
    target.reason = "no sample on the plateau";
    const FitResult result = fit_target(target, fit_with(HardeningLaw::Ideal));
    EXPECT_EQ(result.status, FitStatus::Rejected);
    EXPECT_EQ(result.reason, "no sample on the plateau");
    EXPECT_EQ(result.evaluations(), 0U);
  }
}

TEST(Fit, RejectsCurvesThatNoModelCouldFollow) {
  const auto reason = [](std::vector<double> strain, std::vector<double> stress) {
    const FitResult result =
        fit_target(target_of(std::move(strain), std::move(stress)), fit_with(HardeningLaw::Ideal));
    EXPECT_EQ(result.status, FitStatus::Rejected);
    return result.reason;
  };
  EXPECT_EQ(reason({}, {}), "the corrected curve has fewer than two samples");
  EXPECT_EQ(reason({0.1}, {1e8}), "the corrected curve has fewer than two samples");
  EXPECT_EQ(reason({0.0, NAN, 0.2}, {0.0, 1e8, 1e8}),
            "the corrected curve holds numbers that are not finite");
  EXPECT_EQ(reason({0.0, 0.1, 0.2}, {0.0, 1e8, INFINITY}),
            "the corrected curve holds numbers that are not finite");
  EXPECT_EQ(reason({0.1, 0.1, 0.1}, {1e8, 2e8, 1e8}),
            "the strain of the corrected curve never changes");
  EXPECT_EQ(reason({0.0, 0.1, 0.2}, {0.0, 0.0, 0.0}), "the corrected curve never carries a stress");
}

TEST(Fit, RejectsATargetThatDeterminesNothing) {
  const FitResult result =
      fit_target(target_of({0.0, 0.001}, {0.0, 2e8}), fit_of({free_parameter("break_strain")}));
  EXPECT_EQ(result.status, FitStatus::Rejected);
  EXPECT_EQ(result.reason, "the curve determines none of the free parameters");
}

TEST(Fit, FailsWhereTheModelCanNeverBeRun) {
  // A negative tie puts the yield stress below zero wherever the modulus is.
  const FitOptions options = fit_of(
      {free_parameter("youngs_modulus"), tied_parameter("yield_stress", "youngs_modulus", -0.001)});
  const FitResult result = fit_target(target_of({0.0, 0.001, 0.01}, {0.0, 2e8, 3e8}), options);
  EXPECT_EQ(result.status, FitStatus::Failed);
  EXPECT_EQ(result.reason, "the model could not be run at any point of the box");
  EXPECT_GT(result.evaluations(), 0U);
}

TEST(Fit, RefusesOptionsThatMeanNothing) {
  const Target target = target_of({0.0, 0.001, 0.01}, {0.0, 2e8, 3e8});
  const auto refusal = [&](auto change) {
    FitOptions options = fit_with(HardeningLaw::Ideal);
    change(options);
    return message_of([&] { fit_target(target, options); });
  };
  EXPECT_EQ(refusal([](FitOptions& o) { o.algorithm = "annealing"; }).substr(0, 44),
            "algorithm = annealing: must be one of auto g");
  EXPECT_EQ(refusal([](FitOptions& o) { o.noise = 0.0; }), "fit.noise = 0: must be above 0 Pa");
  EXPECT_EQ(refusal([](FitOptions& o) { o.confidence = 1.0; }),
            "fit.confidence = 1: must be between 0 and 1");
  EXPECT_EQ(refusal([](FitOptions& o) { o.break_weight = -1.0; }),
            "fit.break_weight = -1: must be at least 0");
  EXPECT_EQ(refusal([](FitOptions& o) { o.stopping.local_evaluations = 0; }),
            "fit.local_evaluations = 0: must be at least 1");
  EXPECT_EQ(refusal([](FitOptions& o) {
              o.algorithm = "crs";
              o.stopping.global_evaluations = 0;
            }),
            "fit.global_evaluations = 0: must be at least 1");
  EXPECT_EQ(refusal([](FitOptions& o) { o.parameters.clear(); }),
            "fit.parameters: at least one must be free");
}

}  // namespace
}  // namespace plastica::calibrate
