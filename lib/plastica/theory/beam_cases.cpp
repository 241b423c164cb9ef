#include "plastica/theory/beam_cases.hpp"

#include <algorithm>

#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

/// Reactions of the end x = L; zero where it is free.
BeamReactions end_reactions(const BeamCase& beam) {
  const auto [a, P, C, w] = beam.load;
  const double L = beam.length, L2 = L * L, L3 = L2 * L, b = L - a;
  switch (beam.ends) {
    case BeamEnds::ClampedFree:
    case BeamEnds::FreeFree: break;
    case BeamEnds::PinnedPinned: return {.end_force = -(P * a + C) / L - w * L / 2.0};
    case BeamEnds::ClampedPinned:
      return {.end_force = -P * a * a * (3.0 * L - a) / (2.0 * L3) -
                           3.0 * C * a * (2.0 * L - a) / (2.0 * L3) - 3.0 * w * L / 8.0};
    case BeamEnds::ClampedClamped:
      return {.end_force = -P * a * a * (a + 3.0 * b) / L3 - 6.0 * C * a * b / L3 - w * L / 2.0,
              .end_moment = P * a * a * b / L2 + C * a * (2.0 * b - a) / L2 + w * L2 / 12.0};
  }
  return {};
}

/// E I times slope and deflection, but for the slope at the start.
struct Integrals {
  double slope = 0.0;
  double deflection = 0.0;
};

Integrals integrals(const BeamCase& beam, double x) {
  const auto [a, P, C, w] = beam.load;
  const BeamReactions r = beam_reactions(beam);
  const double d = std::max(x - a, 0.0), x2 = x * x;
  return {.slope = r.start_force * x2 / 2.0 - r.start_moment * x + P * d * d / 2.0 - C * d +
                   w * x2 * x / 6.0,
          .deflection = r.start_force * x2 * x / 6.0 - r.start_moment * x2 / 2.0 +
                        P * d * d * d / 6.0 - C * d * d / 2.0 + w * x2 * x2 / 24.0};
}

/// E I times the slope at the start.
double start_slope(const BeamCase& beam) {
  if (beam.ends != BeamEnds::PinnedPinned) return 0.0;
  return -integrals(beam, beam.length).deflection / beam.length;
}

}  // namespace

BeamReactions beam_reactions(const BeamCase& beam) {
  require_domain(beam.ends != BeamEnds::FreeFree, "beam.ends != FreeFree");
  const auto [a, P, C, w] = beam.load;
  const double L = beam.length;
  BeamReactions r = end_reactions(beam);
  r.start_force = -P - w * L - r.end_force;
  if (beam.ends != BeamEnds::PinnedPinned) {
    r.start_moment = -P * a - C - w * L * L / 2.0 - r.end_force * L - r.end_moment;
  }
  return r;
}

double beam_moment(const BeamCase& beam, double x) {
  const auto [a, P, C, w] = beam.load;
  const BeamReactions r = beam_reactions(beam);
  const double applied = x < a ? 0.0 : P * (x - a) - C;
  return r.start_force * x - r.start_moment + applied + w * x * x / 2.0;
}

double beam_slope(const BeamCase& beam, double x) {
  return (start_slope(beam) + integrals(beam, x).slope) / beam.bending_stiffness;
}

double beam_deflection(const BeamCase& beam, double x) {
  return (start_slope(beam) * x + integrals(beam, x).deflection) / beam.bending_stiffness;
}

double cantilever_shear_deflection(double force, double distributed, double length,
                                   double shear_stiffness) {
  return (force + distributed * length / 2.0) * length / shear_stiffness;
}

}  // namespace plastica::theory
