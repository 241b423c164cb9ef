#include "plastica/report/scene_text.hpp"
#include "plastica/model/support_kind.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "plastica/report/format.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_mode_text.hpp"
#include "plastica/report/scene_motion_text.hpp"
#include "plastica/report/scene_setup_text.hpp"
#include "plastica/report/scene_words.hpp"
#include "plastica/report/table.hpp"

namespace plastica::report {
namespace {

using Align = Table::Align;

std::string size_label(const BeamOutline& outline, std::size_t segment) {
  const double width = outline.width[segment];
  if (outline.round[segment] != 0) return fmt::format("diameter {:.4g} mm", 1e3 * width);
  return fmt::format("{:.4g} x {:.4g} mm", 1e3 * width, 1e3 * outline.height[segment]);
}

std::string beam_label(const io::SceneRecord& record) {
  const Beam& beam = record.setup.scene.beam;
  const BeamOutline& outline = record.outline;
  bool same = true;
  for (std::size_t i = 1; i < outline.segments(); ++i) {
    same = same && outline.width[i] == outline.width[0] && outline.height[i] == outline.height[0];
  }
  return fmt::format("{} m in {}, {}{}", brief(beam.length), counted(outline.segments(), "segment"),
                     size_label(outline, 0), same ? "" : " at the start");
}

std::string head(const io::SceneRecord& record, const Ink& ink) {
  const Response& response = record.response;
  const std::string line =
      wrapped("", printable(record.setup.scene.name) + ": " + outcome_line(record), kWidth);
  std::string text = usable(response.status) ? ink.heading(line) : ink.bad(line);
  const std::string_view change = advice(response.status, is_motion(record));
  if (!change.empty()) text += entry("advice", change);
  // The reason begins with the level's name.
  text += entry("level", record.level_reason);
  if (record.level != Level::Coupon) text += entry("beam", beam_label(record));
  text += setup_text(record);
  text += scheme_text(record);
  std::string samples = std::to_string(response.samples);
  if (record.level != Level::Coupon && !keeps_all_frames(record)) {
    samples += fmt::format(", with the shape of {}", counted(frames_of(record), "frame"));
  }
  text += entry("samples", samples);
  return text;
}

std::string probe_text(const io::SceneRecord& record, const Ink& ink) {
  const auto& probes = record.setup.scene.probes;
  if (probes.empty() || record.response.samples == 0) return {};
  Table table({{"probe", Align::Left},
               {"last"},
               {"min"},
               {"max"},
               {"", Align::Left},
               {"records", Align::Left}});
  for (std::size_t p = 0; p < probes.size(); ++p) {
    const std::vector<double>& values = record.response.probes[p];
    const double largest = largest_of(values);
    const Deformation deformation = record.setup.scene.drive.deformation;
    const DisplayUnit unit = shown_unit(dimension_of(probes[p].quantity, deformation), largest);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double scale = unit.scale;
    table.add({printable(probes[p].name), beside(values.back() / scale, largest / scale),
               beside(*least / scale, largest / scale), beside(*most / scale, largest / scale),
               std::string(unit.name), probe_label(record, probes[p])});
  }
  return '\n' + ink.heading("Probes\n") + table.text(2, kWidth);
}

std::string peak_text(const io::SceneRecord& record, const Ink& ink) {
  const ScenePeaks peaks = peaks_of(record);
  if (!peaks.moment && !peaks.displacement) return {};
  Table table({{"largest", Align::Left},
               {""},
               {"joint"},
               {"at", Align::Right, "of length"},
               {"sample"},
               {"", Align::Left}});
  const auto add = [&](std::string what, const std::optional<Peak>& peak, Dimension dimension,
                       std::string_view note) {
    if (!peak) return;
    table.add({std::move(what), shown(peak->value, dimension), std::to_string(peak->joint),
               place_label(record.outline.ends[peak->joint]), std::to_string(peak->sample),
               std::string(note)});
  };
  const double moment = peaks.moment ? std::fabs(peaks.moment->value) : 0.0;
  add("displacement", peaks.displacement, Dimension::Length,
      peaks.displacement ? std::string("most along ") + "xyz"[peaks.displacement->axis] : "");
  add("moment", peaks.moment, Dimension::Moment, peaks.moment ? axis_name(peaks.moment->axis) : "");
  // What only rounding makes is no stress.
  const auto matters = [&](const std::optional<Peak>& peak) {
    if (!peak) return false;
    const double modulus = record.outline.modulus[3 * peak->joint + peak->axis];
    return std::fabs(peak->value) * modulus > 1e-9 * moment;
  };
  // Of a joint's moment, by the elastic modulus: beyond first yield no stress that is there.
  const std::string_view elastic = peaks.plastic_strain ? "as if elastic" : "";
  if (matters(peaks.stress)) add("bending stress", peaks.stress, Dimension::Stress, elastic);
  if (matters(peaks.shear_stress)) {
    add("shear stress", peaks.shear_stress, Dimension::Stress, elastic);
  }
  add("plastic strain", peaks.plastic_strain, Dimension::Strain, "in the break measure");
  const std::string frames = " of " + counted(frames_of(record), "frame");
  return '\n' + ink.heading("Joints" + (keeps_all_frames(record) ? std::string() : frames) + '\n') +
         table.text(2, kWidth);
}

std::string reaction_text(const io::SceneRecord& record, const Ink& ink) {
  const ChainHistory& chain = record.response.chain;
  if (chain.supports == 0 || frames_of(record) == 0) return {};
  const std::size_t frame = frame_at(record);
  const std::size_t last = frame * chain.supports * 6;
  const std::span<const double> all = std::span<const double>(chain.reaction).subspan(last);
  Table table({{"reaction of", Align::Left},
               {"at", Align::Right, "of length"},
               {"F_x", Align::Right, "N"},
               {"F_y", Align::Right, "N"},
               {"F_z", Align::Right, "N"},
               {"M_x", Align::Right, "N m"},
               {"M_y", Align::Right, "N m"},
               {"M_z", Align::Right, "N m"}});
  double force = 0.0;
  double moment = 0.0;
  for (std::size_t s = 0; s < chain.supports; ++s) {
    force = std::max(force, largest_of(all.subspan(6 * s, 3)));
    moment = std::max(moment, largest_of(all.subspan(6 * s + 3, 3)));
  }
  const double length = record.setup.scene.beam.length;
  for (std::size_t s = 0; s < chain.supports; ++s) {
    const Support& support = record.setup.scene.supports[s];
    if (traits_of(support).releases) continue;  // which has none
    std::vector<std::string> row = {std::string(traits_of(support).word),
                                    place_label(support.at.fraction)};
    for (std::size_t k = 0; k < 6; ++k) {
      const double size =
          k < 3 ? std::max(force, moment / length) : std::max(moment, force * length);
      row.push_back(beside(all[6 * s + k], size));
    }
    table.add(std::move(row));
  }
  const bool whole = chain.frame_sample[frame] + 1 == chain.time.size();
  const std::string when = whole
                               ? std::string("at the last sample")
                               : "at " + time_text(time_of_frame(record, frame), chain.time.back());
  return '\n' + ink.heading("Reactions " + when + '\n') + table.text(2, kWidth);
}

std::string effort_text(const io::SceneRecord& record, const Ink& ink) {
  if (record.level == Level::Coupon) return {};
  const PathCounters& counters = record.response.counters;
  return '\n' + ink.heading("Effort\n") +
         fmt::format("  {}, {}, {}\n", counted(static_cast<std::size_t>(counters.steps), "step"),
                     counted(static_cast<std::size_t>(counters.iterations), "iteration"),
                     counted(static_cast<std::size_t>(counters.cutbacks), "cut-back"));
}

std::string warning_text(const io::SceneRecord& record, const Ink& ink) {
  if (record.warnings.empty()) return {};
  std::string text = '\n' + ink.bad("Warnings\n");
  for (const std::string& warning : record.warnings) text += wrapped("  - ", warning, kWidth);
  return text;
}

}  // namespace

std::string scene_report(const io::SceneRecord& record, bool color) {
  const Ink ink(color);
  return head(record, ink) + events_text(record, ink) + probe_text(record, ink) +
         peak_text(record, ink) + reaction_text(record, ink) + energy_text(record, ink) +
         frequency_text(record, ink) + buckling_text(record, ink) + vibration_text(record, ink) +
         effort_text(record, ink) + warning_text(record, ink);
}

}  // namespace plastica::report
