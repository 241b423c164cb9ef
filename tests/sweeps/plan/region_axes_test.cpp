#include <gtest/gtest.h>

#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/plan/read_axes.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica::sweeps {
namespace {

/// A beam in two halves of one section and material is the beam, whatever an axis makes of it.
TEST(RegionAxes, MoveTheRegionsThatSayNothingElse) {
  plastica::Setup whole{testing::cantilever_scene(8), {}};
  whole.scene.loads = {{.at = Place::end(), .force = {0.0, -1.0, 0.0}}};
  whole.solver.steps = 1;
  testing::add_probe(whole.scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  plastica::Setup halves = whole;
  halves.scene.regions = {{.from = {0.5, {}},
                           .to = Place::end(),
                           .section = whole.scene.section,
                           .material = whole.scene.material,
                           .own = {}}};
  const auto moved_by = [](plastica::Setup setup, std::string_view path, const FieldValue& value) {
    const std::vector<const Field*> fields{&find_axis_field(path)};
    const std::vector<FieldValue> values{value};
    apply(setup, fields, values);
    return simulate(setup.scene, setup.solver).probes[0].back();
  };
  const double before = moved_by(whole, "beam.length", whole.scene.beam.length);
  const std::vector<std::pair<std::string_view, FieldValue>> axes{
      {"material.youngs_modulus", 70e9},         {"section.width", 0.05},
      {"section.shape", std::string("circle")},  {"scale.size", 2.0},
      {"material.name", std::string("6061-T6")}, {"beam.slenderness", 30.0}};
  for (const auto& [path, value] : axes) {
    const double moved = moved_by(whole, path, value);
    EXPECT_NEAR(moved_by(halves, path, value), moved, 1e-12 * std::abs(moved)) << path;
    EXPECT_GT(std::abs(moved / before - 1.0), 0.01) << path;
  }
}

}  // namespace
}  // namespace plastica::sweeps
