#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "plastica/model/torsion.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// The 45-degree bend: bending about both axes and torsion at once, rotations large. Inches and
/// pounds-force throughout: nothing here knows a unit.
namespace plastica {
namespace {

constexpr double kRadius = 100.0;

Scene bend(int segments, double force) {
  Scene scene = testing::cantilever_scene(segments);
  scene.material.youngs_modulus = 1e7;
  scene.material.poisson_ratio = 0.0;
  // G J as if J were the polar moment 1/6.
  scene.material.shear_modulus = 0.5e7 / 6.0 / saint_venant_beta(1.0);
  scene.section.width = 1.0;
  scene.section.height = 1.0;
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = std::numbers::pi / 4.0;
  scene.beam.length = kRadius * scene.beam.arc_angle;
  scene.loads.push_back({.force = {force, 0.0, 0.0}});
  for (const Component axis : {Component::X, Component::Y, Component::Z}) {
    testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), axis);
  }
  return scene;
}

/// The table's displacement in our axes: x along the load, y to the centre, z along the tangent.
std::array<double, 3> reference(const testing::ReferenceTable& table, std::size_t row) {
  return {table.at("u_z_in", row), table.at("u_y_in", row), table.at("u_x_in", row)};
}

/// Distance of the tip from the reference over the way it went.
double tip_error(int segments, double force, const std::array<double, 3>& exact) {
  const Response response = testing::completed(bend(segments, force));
  double off = 0.0, displacement = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    off = std::hypot(off, testing::last_of(response, k) - exact[k]);
    displacement = std::hypot(displacement, exact[k]);
  }
  return off / displacement;
}

TEST(BatheBolourchiRun, ConvergesToTheRodWithOrderTwo) {
  const testing::ReferenceTable table("bathe-bolourchi-45/computed_tip.csv");
  int rows = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.text("model", i) != "GJ=polar 8.3333e5, inextensible unshearable") continue;
    const double force = table.at("P_lbf", i);
    SCOPED_TRACE(force);
    const auto exact = reference(table, i);
    const double coarse = tip_error(16, force, exact);
    const double middle = tip_error(32, force, exact);
    const double fine = tip_error(64, force, exact);
    EXPECT_LE(fine, testing::tolerance(0.001));
    EXPECT_GE(std::log2(coarse / middle), 1.9);
    EXPECT_GE(std::log2(middle / fine), 1.9);
    ++rows;
  }
  EXPECT_EQ(rows, 3);
}

}  // namespace
}  // namespace plastica
