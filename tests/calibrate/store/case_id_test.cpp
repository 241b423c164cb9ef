#include "calibrate/store/case_id.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/calibrate/store/synthetic_fits.hpp"

namespace plastica::calibrate {
namespace {

TEST(CaseId, BeginsWithTheNameOfTheTarget) {
  const std::string id = case_id(ideal_target("Stab 7", 3e8), 1);
  EXPECT_EQ(id.substr(0, 7), "Stab 7 ");
  EXPECT_EQ(id.size(), 7U + 16U);
}

TEST(CaseId, ChangesWithWhateverOfATargetDecidesItsFit) {
  using Change = std::function<void(Target&)>;
  const Change changes[] = {
      [](Target& t) { t.test = Deformation::Torsion; },
      [](Target& t) { t.measure = Measure::True; },
      [](Target& t) { t.loading = Loading::Cyclic; },
      [](Target& t) { t.status = TargetStatus::TooCoarse; },
      [](Target& t) { t.corrected.strain[3] = std::nextafter(t.corrected.strain[3], 1.0); },
      [](Target& t) { t.corrected.stress[0] = -0.0; },
      [](Target& t) { t.characteristics.proof_stress.reset(); },
      [](Target& t) { t.characteristics.observed_break.reset(); },
      [](Target& t) { t.characteristics.observed_break->first_broken_strain += 1e-6; },
      [](Target& t) {
        t.properties = {{"strain_rate", 1.0}};
      },
      [](Target& t) {
        t.properties = {{"strain_rate", 2.0}};
      },
  };
  const Target target = ideal_target("a", 3e8);
  std::set<std::string> ids{case_id(target, 1), case_id(target, 2)};
  for (const Change& change : changes) {
    Target changed = target;
    change(changed);
    ids.insert(case_id(changed, 1));
  }
  EXPECT_EQ(ids.size(), std::size(changes) + 2);
}

TEST(CaseId, StaysWhenWhatChangesDoesNotDecideTheFit) {
  Target target = ideal_target("a", 3e8);
  const std::string id = case_id(target, 1);
  target.file = "elsewhere/a.csv";
  target.raw.strain.clear();
  target.raw.stress.clear();
  target.group = {{"lot", "B"}};
  target.warnings = {"a repair"};
  EXPECT_EQ(case_id(target, 1), id);
}

TEST(OptionsDigest, ChangesWithEveryOption) {
  using Change = std::function<void(FitOptions&)>;
  const Change changes[] = {
      [](FitOptions& o) { o.setup.scene.section.width *= 2.0; },
      [](FitOptions& o) { o.setup.scene.material.break_strain = 0.1; },
      [](FitOptions& o) { o.setup.scene.material.hardening.law = HardeningLaw::Linear; },
      [](FitOptions& o) { o.setup.scene.break_measure = BreakMeasure::Accumulated; },
      [](FitOptions& o) { o.parameters.pop_back(); },
      [](FitOptions& o) { std::swap(o.parameters[0], o.parameters[1]); },
      [](FitOptions& o) { o.parameters[0].role = ParameterRole::Fixed; },
      [](FitOptions& o) { o.parameters[0].value = 1e11; },
      [](FitOptions& o) { o.parameters[0].lower = 1e11; },
      [](FitOptions& o) { o.parameters[0].upper = 1e11; },
      [](FitOptions& o) { o.parameters[0].scale = ParameterScale::Linear; },
      [](FitOptions& o) { o.parameters[0].tied_to = o.parameters[1].field; },
      [](FitOptions& o) { o.parameters[0].factor = 2.0; },
      [](FitOptions& o) {
        o.parameters[0].prior = Prior{2e11, 1e9};
      },
      [](FitOptions& o) {
        o.parameters[0].prior = Prior{2e11, 2e9};
      },
      [](FitOptions& o) { o.objective = Objective::LeastSquares; },
      [](FitOptions& o) { o.noise = 1e6; },
      [](FitOptions& o) {
        o.weights = {{0.0, 1.0}};
      },
      [](FitOptions& o) {
        o.weights = {{0.1, 1.0}};
      },
      [](FitOptions& o) {
        o.weights = {{0.1, 0.5}};
      },
      [](FitOptions& o) {
        o.weights = {{0.1, 0.5}, {0.2, 0.5}};
      },
      [](FitOptions& o) { o.break_weight = 0.5; },
      [](FitOptions& o) { o.algorithm = "slsqp"; },
      [](FitOptions& o) { o.stopping.global_evaluations = 7; },
      [](FitOptions& o) { o.stopping.local_evaluations = 7; },
      [](FitOptions& o) { o.stopping.parameter_tolerance = 1e-3; },
      [](FitOptions& o) { o.stopping.cost_tolerance = 1e-3; },
      [](FitOptions& o) { o.seed = 2; },
      [](FitOptions& o) { o.confidence = 0.9; },
      [](FitOptions& o) { o.intervals.profile = true; },
      [](FitOptions& o) { o.intervals.bootstrap = 40; },
      [](FitOptions& o) { o.intervals.block = 3; },
  };
  std::set<std::uint64_t> digests{digest_of(ideal_options())};
  for (const Change& change : changes) {
    FitOptions options = ideal_options();
    change(options);
    digests.insert(digest_of(options));
  }
  EXPECT_EQ(digests.size(), std::size(changes) + 1);
}

TEST(OptionsDigest, DoesNotDependOnWhereAParameterStandsInTheFile) {
  FitOptions options = ideal_options();
  options.parameters[0].where = {"somewhere/fit.toml", 12};
  EXPECT_EQ(digest_of(options), digest_of(ideal_options()));
}

}  // namespace
}  // namespace plastica::calibrate
