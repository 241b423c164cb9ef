#include "plastica/report/scene_motion_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_spectrum.hpp"
#include "plastica/report/scene_words.hpp"
#include "plastica/report/table.hpp"
#include "plastica/run/path_stops.hpp"

namespace plastica::report {
namespace {

using Align = Table::Align;

constexpr std::size_t kMaxRows = 20;          ///< joints, and fragments, that are listed
constexpr std::size_t kMaxReportedPeaks = 5;  ///< frequencies of a probe
constexpr double kMinReportedPeak = 1e-3;     ///< of the strongest one

/// Time in the unit in which the last sample's is read best.
DisplayUnit unit_of_time(const io::SceneRecord& record) {
  const auto& time = record.response.chain.time;
  const double end = time.empty() ? 0.0 : time.back();
  if (end >= 1.0 || end == 0.0) return {"s", 1.0};
  return end >= 1e-3 ? DisplayUnit{"ms", 1e-3} : DisplayUnit{"µs", 1e-6};
}

struct EventRow {
  double time;
  const BrokenJoint* joint;
};

std::vector<EventRow> rows_of(const std::vector<ChainBreak>& events) {
  std::vector<EventRow> rows;
  for (const ChainBreak& event : events) {
    for (const BrokenJoint& joint : event.joints) rows.push_back({event.time, &joint});
  }
  return rows;
}

std::string more(std::size_t count, std::string_view noun) {
  return count <= kMaxRows ? std::string() : fmt::format("  … {} in all\n", counted(count, noun));
}

/// The steps that a motion has taken, and why they are not those that were asked for.
std::string step_text(const io::SceneRecord& record) {
  const SolverOptions& solver = record.setup.solver;
  const Response& response = record.response;
  const auto text_of = [](double time) { return time_text(time, time); };
  const std::string asked = text_of(solver.time_step);
  if (response.longest_step == 0.0) return asked + " asked for; none was taken";
  std::string taken = text_of(response.longest_step);
  const bool varies = response.shortest_step < response.longest_step * (1.0 - 1e-6);
  if (varies) taken = text_of(response.shortest_step) + " to " + taken;
  if (solver.step_error > 0.0) {
    return fmt::format("at most {}, as an error of {} of the length asks for; {} taken", asked,
                       brief(solver.step_error), taken);
  }
  taken += varies ? ", shorter at contacts and corners and where longer ones had no solution"
                  : ", fixed";
  const std::string_view cut = step_cut(record);
  if (cut.empty()) return taken;
  const FixedSteps planned = fixed_steps(path_stops(record.setup.scene, solver), solver.time_step);
  return fmt::format("{}: {} are cut to {}the samples, {} apart", taken, asked,
                     cut == "samples" ? "" : "divide the time between ", text_of(planned.samples));
}

std::string joints_table(const io::SceneRecord& record, const std::vector<EventRow>& rows) {
  double moment = 0.0;
  double dissipation = 0.0;
  for (const EventRow& row : rows) {
    moment = std::max(moment, largest_of(row.joint->moment));
    dissipation = std::max(dissipation, row.joint->dissipation);
  }
  const DisplayUnit time = unit_of_time(record);
  const DisplayUnit unit = shown_unit(Dimension::Moment, moment);
  const std::string moment_unit(unit.name);
  Table table({{"time", Align::Right, std::string(time.name)},
               {"joint"},
               {"at", Align::Right, "fraction"},
               {"cause", Align::Left},
               {"strain", Align::Right, "%"},
               {"limit", Align::Right, "%"},
               {"M_x", Align::Right, moment_unit},
               {"M_y", Align::Right, moment_unit},
               {"T", Align::Right, moment_unit},
               {"dissipated", Align::Right, "J"},
               {"cut"}});
  for (std::size_t i = 0; i < std::min(rows.size(), kMaxRows); ++i) {
    const BrokenJoint& joint = *rows[i].joint;
    const bool limited = joint.cause != BreakCause::Cut;
    std::vector<std::string> cells{
        significant(rows[i].time / time.scale),
        std::to_string(joint.joint),
        place_label(record.outline.ends[static_cast<std::size_t>(joint.joint)]),
        std::string(cause_name(joint.cause, true)),
        significant(100.0 * joint.strain, 4),
        limited ? significant(100.0 * joint.limit, 4) : "-"};
    for (const double m : joint.moment)
      cells.push_back(beside(m / unit.scale, moment / unit.scale));
    cells.push_back(beside(joint.dissipation, dissipation));
    cells.emplace_back(joint.cut ? "yes" : "no");
    table.add(std::move(cells));
  }
  return table.text(2, kWidth);
}

std::string fragments_text(const io::SceneRecord& record, const Ink& ink) {
  const std::vector<Fragment>& fragments = record.response.chain.events.back().fragments;
  if (fragments.empty()) return {};
  const std::vector<double>& ends = record.outline.ends;
  const double length = record.setup.scene.beam.length;
  Table table({{"fragment"},
               {"segments", Align::Range},
               {"count"},
               {"length", Align::Right, "m"},
               {"from", Align::Right, "fraction"},
               {"to", Align::Right, "fraction"}});
  for (std::size_t i = 0; i < std::min(fragments.size(), kMaxRows); ++i) {
    const Fragment& fragment = fragments[i];
    const double from = ends[static_cast<std::size_t>(fragment.first)];
    const double to = ends[static_cast<std::size_t>(fragment.last) + 1];
    table.add({std::to_string(i + 1), fmt::format("{} … {}", fragment.first, fragment.last),
               std::to_string(fragment.last - fragment.first + 1),
               significant(length * (to - from), 4), place_label(from), place_label(to)});
  }
  return '\n' + ink.heading("Fragments after the last event\n") + table.text(2, kWidth) +
         more(fragments.size(), "fragment");
}

std::string events_heading(const std::vector<ChainBreak>& events) {
  bool broke = false;
  bool cut = false;
  for (const ChainBreak& event : events) {
    for (const BrokenJoint& joint : event.joints) {
      (joint.cause == BreakCause::Cut ? cut : broke) = true;
    }
  }
  const char* several = events.size() == 1 ? "" : "s";
  if (broke && cut) return fmt::format("Break{0} and cut{0}\n", several);
  return fmt::format("{}{}\n", cut ? "Cut" : "Break", several);
}

}  // namespace

std::string scheme_text(const io::SceneRecord& record) {
  if (!is_motion(record)) return {};
  const SolverOptions& solver = record.setup.solver;
  std::string scheme = solver_word(record, "solver.scheme");
  if (solver.scheme == Scheme::GeneralizedAlpha) {
    scheme += fmt::format(", rho_infinity {}", brief(solver.rho_infinity));
  }
  std::string text = entry("scheme", scheme);
  text += entry("step", step_text(record));
  if (solver.damping != Damping::None) {
    text += entry("damping", fmt::format("{}, {}", solver_word(record, "solver.damping"),
                                         time_text(solver.damping_time, solver.damping_time)));
  }
  return text;
}

std::string events_text(const io::SceneRecord& record, const Ink& ink) {
  const std::vector<ChainBreak>& events = record.response.chain.events;
  if (events.empty()) return {};
  const std::vector<EventRow> rows = rows_of(events);
  return '\n' + ink.heading(events_heading(events)) + joints_table(record, rows) +
         more(rows.size(), "joint") + fragments_text(record, ink);
}

std::string energy_text(const io::SceneRecord& record, const Ink& ink) {
  const auto fraction = residual_fraction(record);
  if (!fraction) return {};
  const Energies& last = record.response.chain.energy.back();
  Table table({{"", Align::Left}, {""}, {"", Align::Left}, {"", Align::Left}});
  const auto add = [&](std::string_view name, double value, int digits, std::string note) {
    table.add({std::string(name), significant(value, digits), "J", std::move(note)});
  };
  for (const EnergyEntry& entry : energy_entries()) {
    if (is_idle(record, entry)) continue;
    const bool begins = entry.member == &Energies::external && is_motion(record);
    add(label_of(entry), last.*entry.member, 5,
        std::string(entry.doc) + (begins ? ", and what it began with" : ""));
  }
  // Where nothing moves all of it is rounding, which the balance does not count.
  const double shown =
      is_motion(record) ? std::min(*fraction, record.response.energy_balance_error) : *fraction;
  add("residual", last.residual, 3,
      fmt::format("not explained; at most {:.2g} % of the {}", 100.0 * shown,
                  is_motion(record) ? "largest" : "energy on the path"));
  std::string text = '\n' + ink.heading("Energies at the last sample\n") + table.text(2, kWidth);
  const double momentum = record.response.momentum_error;
  if (momentum > kBalanceTolerance) {
    text +=
        ink.bad(fmt::format("  the momentum of what flies freely is off by {:.2g} %: take smaller "
                            "steps, or scheme = \"energy_momentum\"\n",
                            100.0 * momentum));
  }
  const double wrong = record.response.energy_balance_error;
  if (wrong > kBalanceTolerance) {
    const std::string percent = fmt::format("{:.2g} %", 100.0 * wrong);
    const bool made = is_motion(record) && wrong > *fraction;
    const std::string what = made ? "  the scheme has made " + percent + " of the energy"
                                  : "  the energy balance is off by " + percent;
    text +=
        ink.bad(what + (is_motion(record) ? ": take smaller steps\n" : ": raise solver.steps\n"));
  }
  return text;
}

std::string frequency_text(const io::SceneRecord& record, const Ink& ink) {
  const std::vector<std::size_t> probes = spectral_probes(record);
  if (probes.empty()) return {};
  Table table({{"probe", Align::Left},
               {"frequency", Align::Right, "Hz"},
               {"period", Align::Right, "ms"},
               {"amplitude"},
               {"", Align::Left}});
  for (const std::size_t p : probes) {
    const Probe& probe = record.setup.scene.probes[p];
    const auto peaks = theory::spectral_peaks(spectrum_of(record, p), kMinReportedPeak);
    if (peaks.empty()) continue;
    const Dimension dimension = dimension_of(probe.quantity, {});
    const DisplayUnit unit = shown_unit(dimension, peaks.front().amplitude);
    for (std::size_t k = 0; k < std::min(peaks.size(), kMaxReportedPeaks); ++k) {
      table.add({k == 0 ? printable(probe.name) : std::string(), significant(peaks[k].frequency),
                 significant(1e3 / peaks[k].frequency),
                 significant(peaks[k].amplitude / unit.scale, 4), std::string(unit.name)});
    }
  }
  const auto& time = record.response.chain.time;
  const double duration = time.back() - time.front();
  const double rate = static_cast<double>(time.size() - 1) / duration;
  const std::string text = '\n' + ink.heading("Frequencies\n");
  if (table.rows() == 0) return text + "  no peak stands out\n";
  return text + table.text(2, kWidth) +
         fmt::format("  found from {:.3g} to {:.4g} Hz, resolved if at least {:.3g} Hz apart\n",
                     theory::kHannMainLobe / duration, 0.5 * rate, theory::kApart / duration);
}

}  // namespace plastica::report
