#include "plastica/report/scene_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/run/path_stops.hpp"

namespace plastica::report {
namespace {

/// A name of files as people read it: "numerical dissipation".
std::string words_of(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// A plastic strain below this is what rounding leaves of an elastic one.
constexpr double kRoundedStrain = 1e-12;
/// Of the beam's length.
constexpr double kRoundedMove = 1e-13;
/// An energy below this fraction of the largest is round-off.
constexpr double kNoEnergy = 1e-12;

void raise(std::optional<Peak>& peak, const Peak& candidate) {
  const double size = std::fabs(candidate.value);
  if (size > (peak ? std::fabs(peak->value) : 0.0)) peak = candidate;
}

/// Of a joint from where it is in the undeformed beam, along the axis that it goes along most.
/// @param at  of the frame and joint, in (n_frames x n_joints)
Peak displacement_of(const io::SceneRecord& record, std::size_t at, std::size_t joint,
                     std::size_t sample) {
  Peak peak{0.0, joint, sample, 0};
  double squares = 0.0, most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double moved =
        record.response.chain.position[3 * at + axis] - record.outline.node[3 * joint + axis];
    squares += moved * moved;
    if (std::fabs(moved) <= most) continue;
    most = std::fabs(moved);
    peak.axis = axis;
  }
  // What rounding moves a joint by is nothing.
  if (most > kRoundedMove * record.setup.scene.beam.length) peak.value = std::sqrt(squares);
  return peak;
}

double largest_entry(const io::SceneRecord& record) {
  double largest = 0.0;
  for (const Energies& energy : record.response.chain.energy) {
    for (const EnergyEntry& entry : energy_entries()) {
      largest = std::max(largest, std::fabs(energy.*entry.member));
    }
  }
  return largest;
}

/// "3 joints over their limit in 2 events from 80 ms on, 1 joint cut by the scene; 3 fragments".
std::string events_line(const io::SceneRecord& record) {
  const ChainHistory& chain = record.response.chain;
  std::set<int> over_limit;  // one that was spared for another may be so again
  std::size_t by_scene = 0;
  std::size_t breaks = 0;
  std::optional<double> first;
  for (const ChainBreak& event : chain.events) {
    bool breaks_now = false;
    for (const BrokenJoint& joint : event.joints) {
      const bool is_cut = joint.cause == BreakCause::Cut;
      if (is_cut) ++by_scene;
      if (!is_cut) over_limit.insert(joint.joint);
      breaks_now = breaks_now || !is_cut;
    }
    if (!breaks_now) continue;
    ++breaks;
    if (!first) first = event.time;
  }
  const double end = chain.time.empty() ? 0.0 : chain.time.back();
  const std::size_t over = over_limit.size();
  std::string line;
  if (over > 0) {
    line =
        fmt::format("{} over {} limit {} {}", counted(over, "joint"), over == 1 ? "its" : "their",
                    breaks == 1 ? std::string("at") : "in " + counted(breaks, "event") + " from",
                    time_text(*first, end));
    if (breaks > 1) line += " on";
  }
  if (by_scene > 0) {
    line +=
        fmt::format("{}{} cut by the scene", line.empty() ? "" : ", ", counted(by_scene, "joint"));
  }
  const std::size_t fragments = fragments_at(record, end).size();
  if (fragments > 1) line += fmt::format("; {}", counted(fragments, "fragment"));
  return line;
}

std::string motion_line(const io::SceneRecord& record) {
  const Response& response = record.response;
  std::string line(name_of(response.status));
  if (!usable(response.status) && response.samples > 0) {
    const double end = response.chain.time.back();
    line += " after " + time_text(end, end);
  }
  const std::string events = events_line(record);
  return events.empty() ? line : line + ": " + events;
}

/// "unstable: it bifurcates at factor 0.25 out of its plane, and 2 times more up to factor 0.5".
std::string unstable_line(const Response& response) {
  std::string line = "unstable";
  if (!response.critical) return line + ": the path ends at an equilibrium that is not stable";
  const CriticalPoints& critical = *response.critical;
  line += fmt::format(": it bifurcates at factor {:.5g}{}", critical.factor.front(),
                      critical.out_of_plane.front() != 0 ? " out of its plane" : "");
  const std::size_t more = critical.factor.size() - 1;
  if (more > 0) {
    line += fmt::format(", and {} more up to factor {:.5g}", counted(more, "time"),
                        critical.factor.back());
  }
  if (response.limit) {
    line += fmt::format("; limit load: factor {:.5g}; at {:.5g} the beam has given way",
                        response.limit->below, response.limit->above);
  }
  return line;
}

}  // namespace

std::string_view step_cut(const io::SceneRecord& record) {
  const SolverOptions& solver = record.setup.solver;
  const double longest = record.response.longest_step;
  if (!is_motion(record) || solver.step_error > 0.0 || longest == 0.0 ||
      longest >= solver.time_step * (1.0 - 1e-9)) {
    return {};
  }
  const FixedSteps planned = fixed_steps(path_stops(record.setup.scene, solver), solver.time_step);
  return planned.samples < solver.time_step ? "samples" : "division";
}

bool is_motion(const io::SceneRecord& record) {
  return record.level != Level::Coupon && record.setup.solver.analysis == Analysis::Dynamics;
}

namespace {

/// About all axes [rad].
double plastic_angle_of(const ChainHistory& chain, std::size_t at) {
  const double* angle = chain.plastic_angle.data() + 3 * at;
  return std::hypot(angle[0], angle[1], angle[2]);
}

}  // namespace

ScenePeaks peaks_of(const io::SceneRecord& record) {
  ScenePeaks peaks;
  double most_bent = 0.0;  // of the joint of the largest plastic strain
  const ChainHistory& chain = record.response.chain;
  for (std::size_t frame = 0; frame < frames_of(record); ++frame) {
    const std::size_t sample = chain.frame_sample[frame];
    for (std::size_t joint = 0; joint < chain.joints; ++joint) {
      const std::size_t at = frame * chain.joints + joint;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        raise(peaks.moment, {chain.moment[3 * at + axis], joint, sample, axis});
      }
      raise(peaks.displacement, displacement_of(record, at, joint, sample));
      raise(peaks.stress, {chain.stress[at], joint, sample, 0});
      raise(peaks.shear_stress,
            {chain.moment[3 * at + 2] / record.outline.modulus[3 * joint + 2], joint, sample, 2});
      // A hinge's neighbours have its strain, where that is of a length over several joints.
      constexpr double kTie = 1e-9;
      const double strain = chain.plastic_strain[at];
      if (strain <= kRoundedStrain) continue;
      const double most = peaks.plastic_strain ? peaks.plastic_strain->value : 0.0;
      const double angle = plastic_angle_of(chain, at);
      if (strain > (1.0 + kTie) * most || (strain > (1.0 - kTie) * most && angle > most_bent)) {
        peaks.plastic_strain = Peak{strain, joint, sample, 0};
        most_bent = angle;
      }
    }
  }
  return peaks;
}

namespace {

/// With as many digits as tell the two factors apart.
std::string limit_line(const LimitLoad& limit) {
  constexpr int kFewest = 5;
  constexpr int kMost = 15;
  int digits = kFewest;
  const auto text = [&](double factor) { return fmt::format("{:.{}g}", factor, digits); };
  while (digits < kMost && text(limit.below) == text(limit.above)) ++digits;
  return fmt::format("limit load: factor {}; at {} the beam has given way", text(limit.below),
                     text(limit.above));
}

}  // namespace

std::string outcome_line(const io::SceneRecord& record) {
  const Response& response = record.response;
  if (is_motion(record)) return motion_line(record);
  if (response.status == Status::LimitLoad && response.limit) {
    return limit_line(*response.limit);
  }
  if (response.status == Status::Unstable) return unstable_line(response);
  if (response.event) {
    return fmt::format("broken at sample {}, strain {:.6g}, permanent strain {:.6g}",
                       response.event->sample, response.event->strain,
                       response.event->permanent_strain);
  }
  if (!response.chain.events.empty()) {
    const auto& events = response.chain.events;
    std::size_t joints = 0;
    for (const ChainBreak& event : events) joints += event.joints.size();
    const bool recorded_only = response.status != Status::Broken;
    return fmt::format("{}: {} over {} limit{} at factor {:.5g}, time {:.5g} s",
                       recorded_only ? std::string(name_of(response.status)) + ", a break recorded"
                                     : std::string("broken"),
                       counted(joints, "joint"), joints == 1 ? "its" : "their",
                       events.size() == 1 ? "" : ", first", events.front().factor,
                       events.front().time);
  }
  return std::string(name_of(response.status));
}

std::span<const EnergyEntry> energy_entries() {
  static constexpr std::array<EnergyEntry, 8> kEntries{{
      {&Energies::external, "external", "work of loads and moving supports"},
      {&Energies::kinetic, "kinetic", "of the motion"},
      {&Energies::elastic, "elastic", "stored in joints and springs"},
      {&Energies::plastic, "plastic", "work of yielding so far"},
      {&Energies::damping, "damping", "dissipated by the joints' damping so far"},
      {&Energies::numerical_dissipation, "numerical_dissipation",
       "dissipated by the scheme so far"},
      {&Energies::impact, "impact", "lost in impacts so far"},
      {&Energies::fracture, "fracture", "elastic energy of joints that were cut, so far"},
  }};
  return kEntries;
}

std::string label_of(const EnergyEntry& entry) { return words_of(entry.name); }

bool is_idle(const io::SceneRecord& record, const EnergyEntry& entry) {
  const double least = kNoEnergy * largest_entry(record);
  const auto& all = record.response.chain.energy;
  return std::all_of(all.begin(), all.end(), [&](const Energies& energy) {
    return std::fabs(energy.*entry.member) <= least;
  });
}

std::optional<double> residual_fraction(const io::SceneRecord& record) {
  double largest = 0.0;
  double residual = 0.0;
  for (const Energies& energy : record.response.chain.energy) {
    largest = std::max({largest, std::fabs(energy.external), energy.elastic + energy.plastic});
    residual = std::max(residual, std::fabs(energy.residual));
  }
  if (is_motion(record)) largest = largest_entry(record);
  if (!(largest > 0.0)) return std::nullopt;
  return residual / largest;
}

std::string solver_word(const io::SceneRecord& record, std::string_view field) {
  return std::get<std::string>(find_field(field).get(record.setup));
}

std::string_view axis_name(std::size_t axis) {
  constexpr std::array<std::string_view, 3> kNames{"about x", "about y", "torque"};
  return kNames[axis];
}

std::string_view cause_name(BreakCause cause, bool brief) {
  switch (cause) {
    case BreakCause::BendingX: return brief ? "bending x" : "bending about x";
    case BreakCause::BendingY: return brief ? "bending y" : "bending about y";
    case BreakCause::Biaxial: return brief ? "bending x, y" : "bending about both";
    case BreakCause::Torsion: return "torsion";
    case BreakCause::Stretch: return "stretch";
    case BreakCause::Cut: return brief ? "the scene" : "cut by the scene";
  }
  return "";
}

std::string place_label(double fraction) {
  if (fraction == 0.0) return "start";
  return fraction == 1.0 ? "end" : fmt::format("{:.4g}", fraction);
}

std::string probe_label(const io::SceneRecord& record, const Probe& probe) {
  std::string label(probe_kinds()[static_cast<std::size_t>(probe.quantity)]);
  if (probe.quantity == ProbeQuantity::Energy && record.level != Level::Coupon) {
    return label + ' ' + words_of(kEnergyKinds[static_cast<std::size_t>(probe.energy)]);
  }
  if (record.level == Level::Coupon || is_of_all(probe.quantity)) return label;
  const std::string_view component = kComponents[static_cast<std::size_t>(probe.component)];
  if (probe.quantity == ProbeQuantity::Momentum ||
      probe.quantity == ProbeQuantity::AngularMomentum) {
    return fmt::format("{} {}", label, component);
  }
  return fmt::format("{} {} at {}", label, component, place_label(probe.at.fraction));
}

}  // namespace plastica::report
