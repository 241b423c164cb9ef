#include <gtest/gtest.h>

#include <cmath>

#include "tests/lib/lanes/planar_fixture.hpp"

namespace plastica::lanes {
namespace {

using testing::levels;
using testing::RandomBeams;

/// By velocities of the centers of mass, where the kernel has inertias about the joints.
TEST(PlanarObservables, SayWhereSegmentsAreAndTheirEnergies) {
  for (const InstructionSet level : levels()) {
    const RandomBeams<double> b(7, 1, 3);
    for (std::size_t i = 0; i < 7; ++i) {
      b.at(i, PlanarState::Plastic) = 0.01 * static_cast<double>(i);
    }
    kernels(level).in_double.planar_observables.one(b.beam());
    double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0, direction = 0.0, spin = 0.0;
    double kinetic = 0.0, elastic = 0.0, potential = 0.0;
    for (std::size_t i = 0; i < 7; ++i) {
      direction += b.kind(i, PlanarKind::Rest) + b.at(i, PlanarState::Angle);
      spin += b.at(i, PlanarState::Rate);
      const double c = std::cos(direction), s = std::sin(direction);
      const auto observed = [&](std::size_t field) {
        return b.observables[i * PlanarObservables::kCount + field];
      };
      EXPECT_NEAR(observed(PlanarObservables::X), x, 1e-14);
      EXPECT_NEAR(observed(PlanarObservables::Y), y, 1e-14);
      EXPECT_NEAR(observed(PlanarObservables::Direction), direction, 1e-14);
      EXPECT_NEAR(observed(PlanarObservables::Cosine), c, 1e-14);
      EXPECT_NEAR(observed(PlanarObservables::Sine), s, 1e-14);
      EXPECT_NEAR(observed(PlanarObservables::Spin), spin, 1e-14);

      const double mass = b.kind(i, PlanarKind::Mass);
      const double center = b.kind(i, PlanarKind::FirstMoment) / mass;
      const double turning = b.kind(i, PlanarKind::Inertia) - mass * center * center;
      kinetic +=
          0.5 * mass * (std::pow(vx - center * s * spin, 2) + std::pow(vy + center * c * spin, 2)) +
          0.5 * turning * spin * spin;
      const double stretched = b.at(i, PlanarState::Angle) - b.at(i, PlanarState::Plastic);
      elastic += 0.5 * b.kind(i, PlanarKind::Stiffness) * stretched * stretched;
      potential += b.load(i, PlanarLoad::ForceX) * x + b.load(i, PlanarLoad::ForceY) * y +
                   b.load(i, PlanarLoad::LeverX) * c + b.load(i, PlanarLoad::LeverY) * s +
                   b.load(i, PlanarLoad::Moment) * direction;
      const double length = b.kind(i, PlanarKind::Length);
      x += length * c;
      y += length * s;
      vx -= length * s * spin;
      vy += length * c * spin;
    }
    EXPECT_NEAR(b.sum(PlanarSums::Kinetic), kinetic, 1e-13 * kinetic);
    EXPECT_NEAR(b.sum(PlanarSums::Elastic), elastic, 1e-13 * elastic);
    EXPECT_NEAR(b.sum(PlanarSums::Potential), potential, 1e-12);
  }
}

}  // namespace
}  // namespace plastica::lanes
