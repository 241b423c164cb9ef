#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "plastica/theory/elastica.hpp"
#include "tests/support/chain_scene.hpp"

/// Cantilevers so flexible that they hang from their clamp, and where their tips are.
namespace plastica::testing {

enum class FlexibleLoad { TipForce, Weight };

/// A cantilever of length 1 under the tip force `load` E I/L^2, or the weight `load` E I/L^3.
/// @param history  of the load
inline Scene flexible_cantilever(FlexibleLoad kind, double load, int segments,
                                 const History& history = History::ramp()) {
  Scene scene = cantilever_scene(segments);
  const double ei = bending_stiffness_of(scene);
  if (kind == FlexibleLoad::TipForce) {
    scene.loads.push_back({.force = {0.0, load * ei, 0.0}, .history = history});
  } else {
    const double area = scene.section.width * scene.section.height;
    scene.gravity = {0.0, load * ei / (scene.material.density * area), 0.0};
    scene.gravity_history = history;
  }
  return scene;
}

/// Tip of an elastica under its own weight q = `load` E I/L^3 across it, by shooting: with phi the
/// angle to the load and x the way from the tip, phi'' = load x sin phi, phi'(0) = 0,
/// phi(1) = pi/2. Runge and Kutta's fourth-order steps; the logarithm of phi(0) by bisection, for
/// phi(1) rises with it.
inline theory::ElasticaTip elastica_weight(double load, int steps = 4000) {
  struct State {
    double phi, rate, across, along;
  };
  const auto shoot = [&](double logarithm) {
    State y{std::exp(logarithm), 0.0, 0.0, 0.0};
    const double h = 1.0 / steps;
    const auto slope = [&](double x, const State& s) {
      return State{s.rate, load * x * std::sin(s.phi), std::cos(s.phi), std::sin(s.phi)};
    };
    const auto add = [](const State& a, double w, const State& b) {
      return State{a.phi + w * b.phi, a.rate + w * b.rate, a.across + w * b.across,
                   a.along + w * b.along};
    };
    for (int i = 0; i < steps && y.phi < std::numbers::pi; ++i) {
      const double x = i * h;
      const State a = slope(x, y);
      const State b = slope(x + h / 2, add(y, h / 2, a));
      const State c = slope(x + h / 2, add(y, h / 2, b));
      const State d = slope(x + h, add(y, h, c));
      y = add(add(add(add(y, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return y;
  };
  double low = -600.0;
  double high = std::log(std::numbers::pi / 2.0);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle).phi < std::numbers::pi / 2.0 ? low : high) = middle;
  }
  const State clamp = shoot(low);
  return {std::numbers::pi / 2.0 - std::exp(low), clamp.across, clamp.along};
}

inline theory::ElasticaTip flexible_tip(FlexibleLoad kind, double load) {
  return kind == FlexibleLoad::TipForce ? theory::elastica_tip_force(load) : elastica_weight(load);
}

/// Distance of a chain's tip from the elastica's, over the way that the tip has gone.
inline double flexible_error(const Response& response, std::size_t segments,
                             const theory::ElasticaTip& exact) {
  const auto tip = last_position(response, segments);
  return std::hypot(tip[1] - exact.deflection, tip[2] - exact.position) /
         std::hypot(exact.deflection, 1.0 - exact.position);
}

/// The most that a chain of so many segments may be off: of second order in the segment over the
/// bend at the clamp, 1/sqrt(load) long, and no more than a fraction of that bend. Another
/// equilibrium is off by far more: a tip that has curled up is a length away.
inline double flexible_tolerance(double load, std::size_t segments) {
  const double segment = 1.0 / static_cast<double>(segments);
  return std::min(0.6 * std::max(load, 2.0) * segment * segment, 0.03);
}

/// The angle by which a chain has turned from clamp to tip, full turns counted [rad].
inline double rotated_in_all(const Response& response, std::size_t segments) {
  double all = 0.0;
  double before = 0.0;
  for (std::size_t i = 0; i < segments; ++i) {
    const auto inner = last_position(response, i);
    const auto outer = last_position(response, i + 1);
    const double angle = std::atan2(outer[1] - inner[1], outer[2] - inner[2]);
    all += std::remainder(angle - before, 2.0 * std::numbers::pi);
    before = angle;
  }
  return all;
}

}  // namespace plastica::testing
