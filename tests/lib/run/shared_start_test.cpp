#include <gtest/gtest.h>

#include <algorithm>

#include "plastica/run/simulate.hpp"

namespace plastica {
namespace {

/// The y displacement of the middle of a beam on two pillars under its weight; one more support
/// keeps its start from sliding.
double sag(bool pillar_first) {
  Scene scene;
  scene.beam.segments = 16;
  scene.yield_model = YieldModel::Elastic;
  scene.gravity = {0.0, -9.81, 0.0};
  Support slide{Place::start(), SupportKind::Roller};
  slide.hold = HeldFreedoms{false, false, true};
  scene.supports = {
      {Place::start(), SupportKind::Pillar}, slide, {Place::end(), SupportKind::Pillar}};
  if (!pillar_first) std::swap(scene.supports[0], scene.supports[1]);
  scene.probes = {{"sag", ProbeQuantity::Displacement, {0.5, {}}}};
  SolverOptions options;
  options.steps = 1;
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.status, Status::Completed);
  return response.probes[0].back();
}

TEST(SharedStart, HoldsTheSameInWhateverOrderItsSupportsAreListed) {
  const double first = sag(true);
  // 5 q L^4/(384 E I) for q = rho g b h, I = b h^3/12, b = h = 0.1 m, L = 1 m; 16 segments are
  // within 1 %.
  const double exact = -5.0 * 7850.0 * 9.81 * 0.01 / (384.0 * 210e9 * 1e-4 / 12.0);
  EXPECT_NEAR(first, exact, 0.01 * -exact);
  EXPECT_EQ(sag(false), first);
}

}  // namespace
}  // namespace plastica
