#include "plastica/report/scene_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_curves.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_spectrum.hpp"
#include "plastica/report/scene_words.hpp"
#include "plastica/report/shown_probes.hpp"

namespace plastica::report {
namespace {

/// A negative entry of at most this fraction of the largest can be part of a stack.
constexpr double kHardlyNegative = 0.005;
constexpr std::size_t kMaxPeaks = 6;  ///< that a spectrum is lettered with
constexpr double kMinPeak = 1e-3;     ///< of the strongest one
constexpr double kNoteWidth = 0.09;  ///< of the letters of a peak [fraction of the picture's width]

std::string_view color_of(std::string_view entry) {
  if (entry == "external") return kDark;
  if (entry == "kinetic") return "#56B4E9";
  if (entry == "elastic") return kBlue;
  if (entry == "plastic") return kVermillion;
  if (entry == "damping") return "#009E73";
  if (entry == "numerical_dissipation") return "#CC79A7";
  return entry == "impact" ? "#E69F00" : "#7A1F1F";
}

/// The unit of a probe's values, best read beside `largest`.
std::string value_label(const ShownProbes& probes, const DisplayUnit& unit) {
  const std::string name = probes.names();
  return unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name);
}

void add_events(FigurePanel& panel, const io::SceneRecord& record) {
  bool broke = false;
  bool cut = false;
  for (const ChainBreak& event : record.response.chain.events) {
    panel.marks.push_back(event.time);
    for (const BrokenJoint& joint : event.joints) {
      (joint.cause == BreakCause::Cut ? cut : broke) = true;
    }
  }
  panel.mark_name = broke && cut ? "break or cut" : (cut ? "cut" : "break");
}

double largest_of_entries(const io::SceneRecord& record) {
  double largest = 0.0;
  for (const Energies& energy : record.response.chain.energy) {
    for (const EnergyEntry& entry : energy_entries()) {
      largest = std::max(largest, std::fabs(energy.*entry.member));
    }
  }
  return largest;
}

bool goes_negative(const io::SceneRecord& record, const EnergyEntry& entry) {
  const auto& all = record.response.chain.energy;
  const double least = -kHardlyNegative * largest_of_entries(record);
  return std::any_of(all.begin(), all.end(),
                     [&](const Energies& energy) { return energy.*entry.member < least; });
}

FigureCurve energy_line(const io::SceneRecord& record, double Energies::*member, std::string name,
                        std::string_view color) {
  const ChainHistory& chain = record.response.chain;
  FigureCurve curve{{}, std::move(name), color, Stroke::Line};
  for (std::size_t i = 0; i < chain.time.size(); ++i) {
    curve.points.push_back({chain.time[i], chain.energy[i].*member});
  }
  return curve;
}

/// An entry on top of what is below it, and adds it to that.
FigureCurve energy_area(const io::SceneRecord& record, const EnergyEntry& entry,
                        std::vector<double>& below) {
  const ChainHistory& chain = record.response.chain;
  FigureCurve curve{{}, label_of(entry), color_of(entry.name), Stroke::Area};
  for (std::size_t i = 0; i < chain.time.size(); ++i) {
    const double low = below[i];
    below[i] += chain.energy[i].*entry.member;
    curve.points.push_back({chain.time[i], low, below[i]});
  }
  return curve;
}

/// From zero on, where nothing but round-off is below it; else as far as the curves go.
std::array<double, 2> range_of(const std::vector<FigureCurve>& curves) {
  double low = 0.0;
  double high = 0.0;
  for (const FigureCurve& curve : curves) {
    for (const auto& point : curve.points) {
      low = std::min(low, point[1]);
      high = std::max(high, point.back());
    }
  }
  if (low < -kHardlyNegative * high) return {};
  return {0.0, 1.06 * high};
}

double largest_frequency(const theory::Spectrum& spectrum) {
  const auto peaks = theory::spectral_peaks(spectrum, kMinPeak);
  double highest = 0.0;
  for (const theory::SpectralPeak& peak : peaks) highest = std::max(highest, peak.frequency);
  return peaks.empty() ? spectrum.frequency.back()
                       : std::min(spectrum.frequency.back(),
                                  std::max(1.3 * highest, 20.0 / spectrum.duration));
}

}  // namespace

Figure history_figure(std::span<const io::SceneRecord> records, const std::string& probe) {
  const std::vector<std::string> labels = labels_of(records);
  const ShownProbes shown(records, probe);
  double largest = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    largest = std::max(largest, largest_of(shown.values(r)));
  }
  const DisplayUnit unit = shown_unit(shown.dimension(), largest);
  Figure figure;
  figure.title = title_of(records);
  FigurePanel panel{shown.title(), "time [s]", value_label(shown, unit)};
  for (std::size_t r = 0; r < records.size(); ++r) {
    const io::SceneRecord& record = records[r];
    FigureCurve curve = curve_of_record(r, records.size(), shown.curve_name(r, labels[r]));
    curve.stroke = Stroke::Line;
    for (std::size_t i = 0; i < record.response.samples; ++i) {
      curve.points.push_back({record.response.chain.time[i], shown.values(r)[i] / unit.scale});
    }
    panel.curves.push_back(std::move(curve));
  }
  if (records.size() == 1) add_events(panel, records.front());
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure energy_figure(const io::SceneRecord& record, bool stacked) {
  Figure figure;
  figure.title = printable(record.setup.scene.name);
  FigurePanel panel{outcome_line(record), "time [s]", "energy [J]"};
  std::vector<FigureCurve> lines;
  std::vector<const EnergyEntry*> stack;
  for (const EnergyEntry& entry : energy_entries()) {
    if (is_idle(record, entry)) continue;
    const bool external = entry.member == &Energies::external;
    if (stacked && is_motion(record) && !external && !goes_negative(record, entry)) {
      stack.push_back(&entry);
    } else {
      lines.push_back(energy_line(record, entry.member, external ? "external" : label_of(entry),
                                  color_of(entry.name)));
    }
  }
  // What is lost for good lies below, what comes and goes on top of it.
  std::rotate(stack.begin(),
              std::find_if(stack.begin(), stack.end(),
                           [](const EnergyEntry* entry) {
                             return entry->member != &Energies::kinetic &&
                                    entry->member != &Energies::elastic;
                           }),
              stack.end());
  std::vector<double> below(record.response.chain.time.size(), 0.0);
  for (const EnergyEntry* entry : stack) {
    panel.curves.push_back(energy_area(record, *entry, below));
  }
  for (FigureCurve& line : lines) panel.curves.push_back(std::move(line));
  panel.curves.push_back(energy_line(record, &Energies::residual, "residual", kGrey));
  panel.y_range = range_of(panel.curves);
  add_events(panel, record);
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure spectrum_figure(std::span<const io::SceneRecord> records, const std::string& probe,
                       bool letters) {
  const std::vector<std::string> labels = labels_of(records);
  const ShownProbes shown(records, probe);
  std::vector<theory::Spectrum> spectra;
  double most = 0.0;
  double highest = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    spectra.push_back(spectrum_of(records[r], shown.index(r)));
    most = std::max(most, largest_of(spectra.back().amplitude));
    highest = std::max(highest, largest_frequency(spectra.back()));
  }
  const DisplayUnit unit = shown_unit(shown.dimension(), most);
  // Five decades below the largest are seen.
  const double top = most > 0.0 ? most / unit.scale : 1.0;
  const double bottom = 1e-5 * top;
  const auto height = [&](double amplitude) {
    const double value = std::max(amplitude / unit.scale, bottom);
    return letters ? std::log10(value) : value;
  };
  Figure figure;
  figure.title = title_of(records);
  FigurePanel panel{
      shown.title(), "frequency [Hz]",
      (letters ? "log10 of the amplitude of " : "amplitude of ") + value_label(shown, unit)};
  panel.logarithmic = !letters;
  panel.x_range = {0.0, highest};
  if (!letters) panel.y_range = {bottom, 4.0 * top};
  for (std::size_t r = 0; r < records.size(); ++r) {
    FigureCurve curve = curve_of_record(r, records.size(), shown.curve_name(r, labels[r]));
    curve.stroke = Stroke::Line;
    for (std::size_t k = 0; k < spectra[r].frequency.size(); ++k) {
      if (spectra[r].frequency[k] > highest) break;
      curve.points.push_back({spectra[r].frequency[k], height(spectra[r].amplitude[k])});
    }
    panel.curves.push_back(std::move(curve));
  }
  if (records.size() == 1 && !letters) {
    for (const theory::SpectralPeak& peak : theory::spectral_peaks(spectra.front(), kMinPeak)) {
      const bool covered = std::any_of(panel.notes.begin(), panel.notes.end(), [&](const auto& n) {
        return std::fabs(n.x - peak.frequency) < kNoteWidth * highest;
      });
      if (covered || panel.notes.size() == kMaxPeaks) continue;
      panel.notes.push_back(
          {peak.frequency, height(peak.amplitude), significant(peak.frequency, 4) + " Hz"});
    }
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace plastica::report
