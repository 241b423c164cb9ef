#include "plastica/report/scene_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "plastica/report/format.hpp"

namespace plastica::report {
namespace {

/// A plastic strain below this is what rounding leaves of an elastic one.
constexpr double kNoStrain = 1e-12;

void raise(std::optional<Peak>& peak, const Peak& candidate) {
  const double size = std::fabs(candidate.value);
  if (size > (peak ? std::fabs(peak->value) : 0.0)) peak = candidate;
}

}  // namespace

ScenePeaks peaks_of(const io::SceneRecord& record) {
  ScenePeaks peaks;
  const ChainHistory& chain = record.response.chain;
  for (std::size_t sample = 0; sample < chain.time.size(); ++sample) {
    for (std::size_t joint = 0; joint < chain.joints; ++joint) {
      const std::size_t at = sample * chain.joints + joint;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        raise(peaks.moment, {chain.moment[3 * at + axis], joint, sample, axis});
      }
      raise(peaks.stress, {chain.stress[at], joint, sample, 0});
      raise(peaks.shear_stress,
            {chain.moment[3 * at + 2] / record.outline.modulus[3 * joint + 2], joint, sample, 2});
      if (chain.plastic_strain[at] > kNoStrain) {
        raise(peaks.plastic_strain, {chain.plastic_strain[at], joint, sample, 0});
      }
    }
  }
  return peaks;
}

std::string outcome_line(const io::SceneRecord& record) {
  const Response& response = record.response;
  if (response.status == Status::LimitLoad && response.limit) {
    return fmt::format("limit load: no equilibrium beyond factor {:.5g} (none found at {:.5g})",
                       response.limit->below, response.limit->above);
  }
  if (response.event) {
    return fmt::format("broken at sample {}, strain {:.6g}, permanent strain {:.6g}",
                       response.event->sample, response.event->strain,
                       response.event->permanent_strain);
  }
  if (!response.chain.events.empty()) {
    const ChainBreak& event = response.chain.events.front();
    const bool recorded_only = response.status != Status::Broken;
    return fmt::format("{}: {} over {} limit at factor {:.5g}, time {:.5g} s",
                       recorded_only ? std::string(name_of(response.status)) + ", a break recorded"
                                     : std::string("broken"),
                       counted(event.joints.size(), "joint"),
                       event.joints.size() == 1 ? "its" : "their", event.factor, event.time);
  }
  return std::string(name_of(response.status));
}

std::optional<double> residual_share(const io::SceneRecord& record) {
  double largest = 0.0;
  double residual = 0.0;
  for (const Energies& energy : record.response.chain.energy) {
    largest = std::max({largest, std::fabs(energy.external), energy.elastic + energy.plastic});
    residual = std::max(residual, std::fabs(energy.residual));
  }
  if (!(largest > 0.0)) return std::nullopt;
  return residual / largest;
}

std::string_view axis_name(std::size_t axis) {
  constexpr std::array<std::string_view, 3> kNames{"about x", "about y", "torque"};
  return kNames[axis];
}

std::string_view cause_name(BreakCause cause) {
  switch (cause) {
    case BreakCause::BendingX: return "bending about x";
    case BreakCause::BendingY: return "bending about y";
    case BreakCause::Biaxial: return "bending about both";
    case BreakCause::Torsion: return "torsion";
    case BreakCause::Stretch: return "stretch";
    case BreakCause::Cut: return "cut by the scene";
  }
  return "";
}

std::string place_label(double share) {
  if (share == 0.0) return "start";
  return share == 1.0 ? "end" : fmt::format("{:.4g}", share);
}

std::string probe_label(const io::SceneRecord& record, const Probe& probe) {
  std::string label(probe_kinds()[static_cast<std::size_t>(probe.quantity)]);
  if (record.level == Level::Coupon || probe.quantity == ProbeQuantity::LoadFactor) return label;
  if (probe.quantity == ProbeQuantity::Energy) {
    return label + ' ' + std::string(kEnergyKinds[static_cast<std::size_t>(probe.energy)]);
  }
  return fmt::format("{} {} at {}", label, kComponents[static_cast<std::size_t>(probe.component)],
                     place_label(probe.at.fraction));
}

}  // namespace plastica::report
