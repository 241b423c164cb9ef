#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/advice.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/outcome_text.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/repairs_text.hpp"
#include "calibrate/report/shown_intervals.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/target/repair.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;

std::string fit_entry(std::string_view label, std::string_view text) {
  return wrapped(fmt::format("  {:<14}", label), text, kWidth);
}

std::string header(const FitRecord& record, const Ink& ink) {
  const Target& target = record.target;
  const std::string unusable = why_unusable(record.result);
  const bool usable = record.result.is_fitted() && unusable.empty();
  std::string status(word_of(record.result.status));
  if (!unusable.empty()) status += ", but no usable fit";
  std::string text = wrapped("", printable(target.name) + ": " + status, kWidth);
  text = usable ? ink.heading(text) : ink.bad(text);
  const std::string reason = unusable.empty() ? reason_of(record) : unusable;
  if (!reason.empty()) text += fit_entry("reason", printable(reason));
  text += fit_entry("file", printable(target.file));
  text += fit_entry("test", fmt::format("{}, {}", word_of(target.test), word_of(target.loading)));
  text += fit_entry("measure", fmt::format("{} strain and stress", word_of(target.measure)));
  std::string samples = fmt::format("{} measured", target.raw.samples());
  if (record.result.samples > 0) samples += fmt::format(", {} fitted", record.result.samples);
  text += fit_entry("samples", samples);
  const std::string many = too_many_dropped(target);
  if (!many.empty()) text += ink.bad(fit_entry("dropped", many));
  if (!target.group.empty()) text += fit_entry("group", printable(group_label(target.group)));
  if (!target.properties.empty()) {
    std::string list;
    for (const auto& [name, value] : target.properties) {
      list += (list.empty() ? "" : ", ") + fmt::format("{} {:.6g}", printable(name), value);
    }
    text += fit_entry("specimen (SI)", list);
  }
  return text;
}

std::string mending(const Target& target, const Ink& ink) {
  std::string text = repairs_text(target.repairs, ink);
  if (!target.corrections.empty()) {
    text += '\n' + ink.heading("Corrections\n");
    for (const Correction& correction : target.corrections) {
      const std::string size = correction.applied ? size_of(correction) : "not done";
      text += wrapped(fmt::format("  {:<17} {:<14}", correction.kind, size),
                      printable(correction.text), kWidth);
    }
  }
  return text;
}

/// A break strain and how far it is open.
std::string break_text(double strain, double error) {
  if (!(error > 0.0)) return significant(100.0 * strain, 4);
  return with_error(100.0 * strain, 100.0 * error);
}

std::string proof_label(const Characteristics& all) {
  return "Rp" + brief(100.0 * all.offset.value_or(0.002));
}

/// Whether the largest stress is that of the last sample, and the specimen did not break there.
bool ends_rising(const Target& target) {
  const Characteristics& all = target.characteristics;
  return all.strain_at_rm && !all.observed_break && !(*all.strain_at_rm < all.largest_strain);
}

std::string characteristics_text(const Target& target, const Ink& ink) {
  const Characteristics& all = target.characteristics;
  const std::string modulus = target.test == Test::Torsion ? "G" : "E";
  Table table({{"", Table::Align::Left},
               {"", Table::Align::PlusMinus},
               {"", Table::Align::Left},
               {"", Table::Align::Left}});
  const auto add_stress = [&](std::string label, std::optional<double> value, std::string note) {
    if (!value) return;
    const DisplayUnit unit = display_unit(Dimension::Stress, *value);
    if (target.measure == Measure::True) note += ", of the true stress";
    table.add({std::move(label), significant(*value / unit.scale), std::string(unit.name),
               std::move(note)});
  };
  if (all.youngs_modulus && !all.sound_modulus()) {
    table.add({modulus, "-", "", "not known: its error is above 5 %"});
  } else if (all.youngs_modulus) {
    const DisplayUnit unit = display_unit(Dimension::Stress, *all.youngs_modulus, true);
    const double value = *all.youngs_modulus / unit.scale;
    const DisplayUnit window = display_unit(Dimension::Stress, all.modulus_window_high);
    std::string note = all.modulus_method;
    if (all.modulus_window_high > all.modulus_window_low) {
      note += fmt::format(" from {} to {} {}", brief(all.modulus_window_low / window.scale),
                          brief(all.modulus_window_high / window.scale), window.name);
    }
    table.add({modulus,
               all.youngs_modulus_stderr
                   ? with_error(value, *all.youngs_modulus_stderr / unit.scale)
                   : significant(value),
               std::string(unit.name), note});
  }
  add_stress(proof_label(all), all.proof_stress, "proof stress");
  add_stress("ReH", all.reh, "upper yield strength");
  add_stress("ReL", all.rel, "lower yield strength");
  add_stress(
      "Rm", all.rm,
      ends_rising(target) ? "largest stress; the record ends while it rises" : "largest stress");
  if (all.strain_at_rm) {
    table.add({"strain at Rm", significant(100.0 * *all.strain_at_rm, 4), "%", ""});
  }
  const std::optional<BreakObservation>& observed = all.observed_break;
  if (all.break_strain) {
    std::string note = "total";
    if (observed) {
      note += fmt::format("; last intact sample at {:.5g} %, by {}",
                          100.0 * observed->last_intact_strain, observed->rule);
    }
    const double half = observed ? observed->half_interval() : 0.0;
    table.add({"break strain", break_text(*all.break_strain, half), "%", note});
  }
  if (all.break_strain_plastic) {
    const bool below = all.break_strain.has_value();
    table.add({below ? "" : "break strain",
               break_text(*all.break_strain_plastic, all.permanent_strain_error()), "%",
               "permanent"});
  }
  if (table.rows() == 0) return {};
  return '\n' + ink.heading("Characteristics\n") + table.text(2, kWidth);
}

bool is_stress_at_yield(const FittedParameter& parameter) {
  return parameter.dimension == Dimension::Stress &&
         parameter.name().find("yield_stress") != std::string::npos;
}

/// What stands below a parameter's row.
std::vector<std::string> notes_on(const FittedParameter& parameter, const FitRecord& record) {
  std::vector<std::string> notes;
  if (is_stress_at_yield(parameter)) {
    notes.push_back(fmt::format("{} stress", word_of(record.target.measure)));
  }
  const std::optional<ModulusPrior>& prior = record.result.modulus_prior;
  if (prior && parameter.name() == "youngs_modulus") {
    const DisplayUnit unit = display_unit(Dimension::Stress, prior->mean, true);
    notes.push_back(fmt::format(
        "weighed with the elastic slope, {} {}",
        with_error(prior->mean / unit.scale, prior->standard_deviation / unit.scale), unit.name));
  }
  if (parameter.is_break()) {
    std::string note = "permanent strain";
    if (record.result.break_strain_total) {
      note += fmt::format("; the fitted model breaks at {} % in total",
                          significant(100.0 * *record.result.break_strain_total, 4));
    } else if (record.result.status == FitStatus::Fitted) {
      note += "; the fitted model does not break within this curve";
    }
    notes.push_back(std::move(note));
  }
  return notes;
}

/// How far the model goes for this curve: stands beside the intervals, which say nothing of it.
std::string misfit_text(const FitRecord& record, const Ink& ink) {
  const FitResult& result = record.result;
  if (result.status != FitStatus::Fitted) return {};
  const DisplayUnit unit = display_unit(Dimension::Stress, result.misfit_rms);
  const bool tension = record.target.characteristics.rm.has_value();
  std::string line =
      fmt::format("{} % of {} (rms {} {})", significant(100.0 * result.misfit_fraction, 2),
                  tension ? "Rm" : "the largest stress",
                  significant(result.misfit_rms / unit.scale, 3), unit.name);
  if (!std::isnan(result.runs_test_p)) {
    line += fmt::format(", runs test p {:.2g}", result.runs_test_p);
  }
  if (!result.misfit_word.empty()) line += ": " + result.misfit_word;
  const std::string meaning = misfit_meaning(result);
  if (!meaning.empty()) line += ", " + meaning;
  const std::string text = fit_entry("misfit", line);
  return result.misfit_word == "poor" ? ink.bad(text) : text;
}

/// A cost [Pa^2] with the square of the stress unit of its size.
std::string cost_text(double cost) {
  const DisplayUnit unit = display_unit(Dimension::Stress, std::sqrt(std::fabs(cost)));
  return fmt::format("{:.6g} {}²", cost / (unit.scale * unit.scale), unit.name);
}

std::string fit_text(const FitRecord& record, const Ink& ink) {
  const FitResult& result = record.result;
  if (result.evaluations() == 0 && result.stages.empty()) return {};
  std::string text = '\n' + ink.heading("Fit\n");
  if (result.status == FitStatus::Fitted) {
    text += fit_entry("objective", "f = " + cost_text(result.cost));
  }
  text += fit_entry("evaluations", fmt::format("{}, seed {}", result.evaluations(), result.seed));
  Table stages({{"", Table::Align::Left},
                {"", Table::Align::Left},
                {"", Table::Align::Right},
                {"", Table::Align::Right},
                {"", Table::Align::Left}});
  for (std::size_t i = 0; i < result.stages.size();) {
    // Starts of the same algorithm that ended alike are one line.
    const OptimizerStage& first = result.stages[i];
    OptimizerStage all = first;
    std::size_t starts = 1;
    for (++i; i < result.stages.size(); ++i, ++starts) {
      const OptimizerStage& next = result.stages[i];
      if (next.algorithm != first.algorithm || next.outcome != first.outcome) break;
      all.evaluations += next.evaluations;
      all.cost = std::fmin(all.cost, next.cost);
    }
    stages.add({all.algorithm, counted(starts, "start"), std::to_string(all.evaluations),
                cost_text(all.cost), printable(all.outcome)});
  }
  return text + stages.text(4, kWidth);
}

}  // namespace

std::string fit_report(const FitRecord& record, const ReportOptions& options) {
  const Ink ink(options.color);
  std::string text =
      header(record, ink) + mending(record.target, ink) + characteristics_text(record.target, ink);
  text += parameters_text(record.result, options, ink,
                          [&](const FittedParameter& p) { return notes_on(p, record); });
  if (!record.result.parameters.empty()) text += misfit_text(record, ink);
  text += intervals_text(shown_intervals(record.result), options) +
          correlations_text(strong_correlations(record.result), ink) + fit_text(record, ink) +
          warnings_text({&record.target.warnings, &record.result.warnings}, ink);
  const std::vector<std::string> advice = advice_for(record);
  if (!advice.empty()) text += '\n' + ink.heading("Advice\n");
  for (const std::string& line : advice) text += wrapped("  - ", printable(line), kWidth);
  return text;
}

}  // namespace plastica::calibrate
