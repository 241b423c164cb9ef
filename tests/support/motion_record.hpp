#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "tests/support/scene_record.hpp"

namespace plastica::testing {

/// What a made-up motion looks like.
struct MadeUpMotion {
  int segments = 12;
  std::size_t samples = 201;
  std::size_t frames = 21;  ///< one more than divides samples - 1 evenly
  double duration = 0.2;    ///< [s]
  bool breaks = true;
};

/// The record of a cantilever above a pillar that was never simulated: it swings, breaks at 40 % of
/// the time in joint N/2 (the joint beside it goes over its limit but holds), and at 70 % the scene
/// cuts joint 3N/4; the outer fragments fall, turning. Energies balance but for a residual.
inline io::SceneRecord motion_record(const MadeUpMotion& made = {}) {
  std::string text = R"([beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
material = "S355"
segments = )" + std::to_string(made.segments) +
                     R"(
[solver]
analysis = "dynamics"
duration = "1 ms"
steps = 1
[[support]]
at = "start"
kind = "clamp"
[[support]]
at = 0.5
kind = "pillar"
normal = "y"
gap = "100 mm"
[[load]]
at = "end"
force = ["0 N", "-1 N", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
[[probe]]
name = "speed"
kind = "displacement"
at = "end"
[[probe]]
name = "kinetic"
kind = "energy"
energy = "kinetic"
)";
  io::SceneRecord record = record_of(text);
  record.setup.scene.probes[1].quantity = ProbeQuantity::Velocity;
  record.setup.solver.duration = made.duration;
  record.setup.solver.steps = static_cast<int>(made.samples) - 1;
  record.setup.solver.frames = static_cast<int>(made.frames) - 1;
  Response& response = record.response;
  ChainHistory& chain = response.chain;
  chain = ChainHistory{};
  const auto n = static_cast<std::size_t>(made.segments);
  const double length = 1.0 / made.segments;
  chain.joints = n + 1;
  chain.supports = 2;
  response.samples = made.samples;
  response.counters = {static_cast<int>(10 * made.samples), static_cast<int>(23 * made.samples), 4};
  response.energy_balance_error = 3e-4;
  response.momentum_error = 2e-5;
  response.shortest_step = response.longest_step = record.setup.solver.time_step;
  const double first_break = made.breaks ? 0.4 * made.duration : 2.0 * made.duration;
  const double second_break = made.breaks ? 0.7 * made.duration : 2.0 * made.duration;
  const std::size_t hinge = n / 2;
  const std::size_t cut = 3 * n / 4;
  constexpr double kFrequency = 30.0;  // of the tip [Hz]
  response.probes.assign(3, std::vector<double>(made.samples));
  for (std::size_t s = 0; s < made.samples; ++s) {
    const double time =
        made.duration * static_cast<double>(s) / static_cast<double>(made.samples - 1);
    const double phase = 2.0 * std::numbers::pi * kFrequency * time;
    response.probes[0][s] = -0.01 * std::sin(phase) + 0.002 * std::sin(5.0 * phase) - 0.004;
    response.probes[1][s] = -0.01 * 2.0 * std::numbers::pi * kFrequency * std::cos(phase);
    chain.time.push_back(time);
    chain.factor.push_back(1.0);
    chain.iterations.push_back(static_cast<int>(s));
    const double late = std::max(0.0, time - first_break) / made.duration;
    Energies energy;
    energy.external = 20.0;
    energy.plastic = 8.0 * std::min(time, first_break) / made.duration;
    energy.damping = 2.0 * time / made.duration;
    energy.numerical_dissipation = 0.4 * time / made.duration;
    energy.fracture = late > 0.0 ? 1.0 : 0.0;
    const double rest = energy.external - energy.plastic - energy.damping -
                        energy.numerical_dissipation - energy.fracture -
                        0.006 * time / made.duration;
    energy.elastic = 0.5 * rest * (1.0 + std::cos(2.0 * phase)) * (late > 0.0 ? 0.2 : 1.0);
    energy.kinetic = rest - energy.elastic;
    energy.residual = 0.006 * time / made.duration;
    chain.energy.push_back(energy);
    response.probes[2][s] = energy.kinetic;
  }
  for (std::size_t f = 0; f < made.frames; ++f) {
    const std::size_t sample = f * (made.samples - 1) / (made.frames - 1);
    const double time = chain.time[sample];
    chain.frame_sample.push_back(sample);
    const double bent = 0.5 * std::min(time, first_break) / made.duration;  // of the hinge [rad]
    const double after = std::max(0.0, time - first_break);
    const double later = std::max(0.0, time - second_break);
    // Slope of a segment against z, and where its inner end is.
    double y = 0.0;
    double z = 0.0;
    for (std::size_t i = 0; i <= n; ++i) {
      const bool outer = i >= hinge;
      const bool tip = i >= cut;
      double slope = -0.1 * static_cast<double>(std::min(i, hinge)) / static_cast<double>(hinge) *
                     std::sin(2.0 * std::numbers::pi * kFrequency * time) * (outer ? 1.0 : 1.0);
      if (outer) slope -= 2.0 * bent + 6.0 * after;
      if (tip) slope -= 12.0 * later;
      if (made.breaks && i == hinge) y -= 5.0 * after * after * 9.81;
      if (made.breaks && i == hinge) z += 0.8 * after;
      if (made.breaks && i == cut) z += 1.5 * later;
      chain.position.insert(chain.position.end(), {0.0, y, z});
      if (i < n) chain.rotation.insert(chain.rotation.end(), {-slope, 0.0, 0.0});
      y += length * std::sin(slope);
      z += length * std::cos(slope);
      const double near = std::fabs(static_cast<double>(i) - static_cast<double>(hinge));
      const double strain = 0.12 * 2.0 * bent * std::max(0.0, 1.0 - near / 3.0);
      chain.plastic_strain.push_back(strain);
      const double moment = -100.0 * (1.0 - static_cast<double>(i) / static_cast<double>(n));
      chain.moment.insert(chain.moment.end(), {moment, 0.0, 0.0});
      chain.force.insert(chain.force.end(), {0.0, 100.0, 0.0});
      chain.angle.insert(chain.angle.end(), {0.01 * static_cast<double>(f), 0.0, 0.0});
      chain.plastic_angle.insert(chain.plastic_angle.end(), {strain, 0.0, 0.0});
      chain.stress.push_back(moment / record.outline.modulus[3 * i]);
    }
    for (std::size_t k = 0; k < 12; ++k) {
      chain.reaction.push_back(static_cast<double>(100 * f + k));
    }
  }
  response.permanent_strain = 0.12 * 2.0 * 0.5 * std::min(1.0, first_break / made.duration);
  response.status = made.breaks ? Status::Broken : Status::Completed;
  if (!made.breaks) return record;
  const auto of = [](std::size_t index) { return static_cast<int>(index); };
  ChainBreak first{first_break, 1.0, {}, {{0, of(hinge) - 1}, {of(hinge), of(n) - 1}}};
  first.joints.push_back({of(hinge),
                          BreakCause::BendingX,
                          true,
                          0.1002,
                          0.1,
                          {-709.5, 0.0, 0.0},
                          {-0.4, 0.0, 0.0},
                          7.25});
  first.joints.push_back({of(hinge) + 1,
                          BreakCause::BendingX,
                          false,
                          0.1001,
                          0.1,
                          {-702.25, 0.0, 0.0},
                          {-0.39, 0.0, 0.0},
                          7.0});
  ChainBreak second{
      second_break, 1.0, {}, {{0, of(hinge) - 1}, {of(hinge), of(cut) - 1}, {of(cut), of(n) - 1}}};
  second.joints.push_back({of(cut), BreakCause::Cut, true, 0.0, 0.0, {12.5, 0.0, 0.0}, {}, 0.0});
  chain.events = {first, second};
  return record;
}

}  // namespace plastica::testing
