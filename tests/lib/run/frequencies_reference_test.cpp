#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plastica/run/natural_frequencies.hpp"
#include "plastica/theory/beam_vibration.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Frequencies of cantilevers against the exact discrete ones, whose segments are thin rods.
namespace plastica {
namespace {

struct Convention {
  const char* name;  ///< in the table
  EndRule rule;
  int more_segments;  ///< than the table's N
};

/// The table's B, a joint of a whole length at the clamp, is none of our end rules.
constexpr std::array kConventions{Convention{"A", EndRule::Equal, 0},
                                  Convention{"C", EndRule::HalfJoint, 0},
                                  Convention{"D", EndRule::Half, 1}};

class FrequenciesReference : public ::testing::TestWithParam<Convention> {};

/// Compares every row of the convention at a level. @return how many frequencies that were
int expect_table(const Convention& convention, Level level, int modes_apart) {
  const testing::ReferenceTable table("lumped-chain-exact/discretisation_error.csv");
  int compared = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("convention", row) != convention.name) continue;
    const int n = static_cast<int>(table.at("N", row));
    SCOPED_TRACE(std::string(convention.name) + " " + std::to_string(n));
    Scene scene = testing::cantilever_scene(n + convention.more_segments);
    scene.end_rule = convention.rule;
    scene.gravity = {0.0, -9.81, 0.0};
    const SolverOptions options{.level = level, .rotary_inertia = RotaryInertia::Off};
    const theory::VibratingBeam beam{
        .length = scene.beam.length,
        .bending_stiffness = testing::bending_stiffness_of(scene),
        .mass_per_length = scene.material.density * testing::properties_of(scene).area};
    const int modes = std::isnan(table.at("freq2_ratio", row))   ? 1
                      : std::isnan(table.at("freq3_ratio", row)) ? 2
                                                                 : 3;
    const auto found = unloaded_frequencies(prepare(scene, options), modes * modes_apart);
    for (int mode = 1; mode <= modes; ++mode) {
      const double continuum =
          circular_frequency(theory::BeamEnds::ClampedFree, mode, beam) / (2.0 * std::numbers::pi);
      const double ratio = table.at("freq" + std::to_string(mode) + "_ratio", row);
      EXPECT_NEAR(found[static_cast<std::size_t>(mode * modes_apart - 1)] / continuum / ratio, 1.0,
                  testing::tolerance(1e-8));
      ++compared;
    }
  }
  return compared;
}

TEST_P(FrequenciesReference, AreThoseOfTheTableInAPlane) {
  const int compared = expect_table(GetParam(), Level::Planar, 1);
  EXPECT_EQ(compared, std::string(GetParam().name) == "A" ? 31 : 32);
}

/// In space each frequency of a square section is there twice.
TEST_P(FrequenciesReference, AreThoseOfTheTableInSpace) {
  expect_table(GetParam(), Level::Spatial, 2);
}

INSTANTIATE_TEST_SUITE_P(Conventions, FrequenciesReference, ::testing::ValuesIn(kConventions),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace plastica
