#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/fit_flags.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/repairs_text.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/report/text_groups.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;
using Align = Table::Align;

/// The symbol of the parameters that people know by one.
std::string symbol_of(std::string_view name) {
  if (name == "yield_stress") return "σ_y";
  if (name == "break_strain") return "ε_break";
  if (name == "shear_yield_stress") return "τ_y";
  if (name == "break_shear_strain") return "γ_break";
  return std::string(name);
}

/// Largest magnitude of a value over the records; 0 if none has it.
template <typename Value>
double largest(std::span<const FitRecord> records, const Value& value) {
  double most = 0.0;
  for (const FitRecord& record : records) {
    const std::optional<double> here = value(record);
    if (here && std::isfinite(*here)) most = std::max(most, std::fabs(*here));
  }
  return most;
}

struct BatchParameter {
  std::string name;
  DisplayUnit unit;
};

/// At most two parameters: yield and break, or what is fitted instead of them.
std::vector<BatchParameter> batch_parameters(std::span<const FitRecord> records) {
  std::vector<std::string> names;
  const auto consider = [&](std::string_view name) {
    if (names.size() < 2 && std::find(names.begin(), names.end(), name) == names.end()) {
      names.emplace_back(name);
    }
  };
  const auto fitted = std::find_if(records.begin(), records.end(), [](const FitRecord& record) {
    return record.result.status == FitStatus::Fitted;
  });
  if (fitted == records.end()) return {};
  for (const std::string_view name :
       {"yield_stress", "shear_yield_stress", "break_strain", "break_shear_strain"}) {
    const FittedParameter* parameter = fitted->result.find_parameter(name);
    if (parameter != nullptr && parameter->role == ParameterRole::Free) consider(name);
  }
  for (const FittedParameter& parameter : fitted->result.parameters) {
    if (parameter.role == ParameterRole::Free) consider(parameter.name());
  }
  std::vector<BatchParameter> shown;
  for (const std::string& name : names) {
    FittedParameter typical = *fitted->result.find_parameter(name);
    typical.value = largest(records, [&](const FitRecord& record) -> std::optional<double> {
      const FittedParameter* parameter = record.result.find_parameter(name);
      if (parameter == nullptr) return std::nullopt;
      return parameter->value;
    });
    shown.push_back({name, display_unit(typical)});
  }
  return shown;
}

std::string parameter_cell(const FittedParameter* parameter, const DisplayUnit& unit) {
  if (parameter == nullptr || (parameter->role == ParameterRole::Free && !parameter->identified)) {
    return "-";
  }
  return value_text(*parameter, unit);
}

/// What the reader has to know of the parameters' columns: measure and kind of strain.
std::string meaning_of_columns(std::span<const FitRecord> records,
                               const std::vector<BatchParameter>& parameters, bool total) {
  bool engineering = false;
  bool true_measure = false;
  for (const FitRecord& record : records) {
    if (record.result.status != FitStatus::Fitted) continue;
    (record.target.measure == Measure::True ? true_measure : engineering) = true;
  }
  const std::string_view measure = engineering && true_measure
                                       ? "engineering or true stress, see the specimen"
                                   : true_measure ? "true stress"
                                                  : "engineering stress";
  std::string text;
  for (const BatchParameter& parameter : parameters) {
    const std::string symbol = symbol_of(parameter.name);
    if (symbol == parameter.name) continue;
    const bool strain = parameter.name.find("strain") != std::string::npos;
    text += (text.empty() ? "" : "; ") + symbol + ": " +
            std::string(strain ? "permanent strain at break" : measure);
  }
  if (total) text += (text.empty() ? "" : "; ") + std::string("total: strain at the fitted break");
  return text;
}

std::string specimens_text(std::span<const FitRecord> records, const ReportOptions& options,
                           const Ink& ink) {
  const auto characteristic = [](std::optional<double> Characteristics::*value) {
    return [value](const FitRecord& record) { return record.target.characteristics.*value; };
  };
  const auto modulus = [](const FitRecord& record) {
    return record.target.characteristics.sound_modulus();
  };
  const auto proof = characteristic(&Characteristics::proof_stress);
  const auto strength = characteristic(&Characteristics::rm);
  const DisplayUnit gpa = display_unit(Dimension::Stress, largest(records, modulus), true);
  const DisplayUnit mpa = display_unit(Dimension::Stress, largest(records, strength));
  const std::vector<BatchParameter> parameters = batch_parameters(records);

  std::vector<Table::Column> columns = {
      {"specimen", Align::Left, ""},
      {modulus_label(records), Align::Right, std::string(gpa.name)},
      {proof_label(records), Align::Right, std::string(mpa.name)},
      {"Rm", Align::Right, std::string(mpa.name)}};
  for (const BatchParameter& parameter : parameters) {
    columns.push_back({symbol_of(parameter.name) + " ± error", Align::PlusMinus,
                       std::string(parameter.unit.name)});
  }
  const bool total = std::any_of(records.begin(), records.end(), [](const FitRecord& record) {
    return record.result.status == FitStatus::Fitted && record.result.break_strain_total;
  });
  if (total) columns.push_back({"total", Align::Right, "%"});
  columns.push_back({"misfit", Align::Right, "% of Rm"});
  columns.push_back({"flags", Align::Left, ""});
  Table table(std::move(columns));

  const std::size_t limit = options.specimens_shown == 0
                                ? records.size()
                                : std::max<std::size_t>(options.specimens_shown, 2);
  const std::size_t head = records.size() > limit ? limit / 2 : records.size();
  const std::size_t tail = records.size() > limit ? records.size() - (limit - head) : head;
  std::string seen;
  const auto cell = [](const std::optional<double>& value, const DisplayUnit& unit, int digits) {
    return value ? significant(*value / unit.scale, digits) : std::string("-");
  };
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i == head && tail > head) {
      table.add_line(fmt::format("… {} left out …", counted(tail - head, "specimen")));
      i = tail;
    }
    const FitRecord& record = records[i];
    const FitResult& result = record.result;
    const bool fitted = result.status == FitStatus::Fitted;
    std::vector<std::string> cells = {printable(record.target.name), cell(modulus(record), gpa, 4),
                                      cell(proof(record), mpa, 4), cell(strength(record), mpa, 4)};
    for (const BatchParameter& parameter : parameters) {
      const FittedParameter* found = fitted ? result.find_parameter(parameter.name) : nullptr;
      cells.push_back(parameter_cell(found, parameter.unit));
    }
    if (total) {
      cells.push_back(fitted && result.break_strain_total
                          ? significant(100.0 * *result.break_strain_total, 4)
                          : "-");
    }
    cells.push_back(fitted ? significant(100.0 * result.misfit_fraction, 2) : "-");
    const std::string flags = flags_of(record);
    seen += flags;
    cells.push_back(fitted ? flags : std::string(word_of(result.status)));
    table.add(std::move(cells));
  }
  std::string text = ink.heading("Specimens\n") + table.text(2, kWidth);
  const std::string meanings = meaning_of_columns(records, parameters, total);
  if (!meanings.empty()) text += wrapped("  ", meanings, kWidth);
  const std::string legend = legend_of(fit_flags(), seen);
  if (!legend.empty()) text += wrapped("  ", legend, kWidth);
  return text;
}

std::string names_text(std::span<const FitRecord> records, const Ink& ink) {
  std::size_t longest = 0;
  for (const FitRecord& record : records) {
    longest = std::max(longest, width_of(printable(record.target.name)));
  }
  const auto first = [&](const FitRecord& record) {
    const std::string name = cut(printable(record.target.name), 30);
    const std::size_t wide = std::min<std::size_t>(longest, 30) + 4;
    return "  " + name + std::string(wide - 2 - width_of(name), ' ');
  };
  std::string text;
  for (const FitStatus status : {FitStatus::Rejected, FitStatus::Failed}) {
    std::string list;
    for (const FitRecord& record : records) {
      if (record.result.status != status) continue;
      list += wrapped(first(record), printable(reason_of(record)), kWidth);
    }
    const std::string_view heading = status == FitStatus::Rejected ? "Rejected\n" : "Failed\n";
    if (!list.empty()) text += '\n' + ink.bad(heading) + list;
  }
  std::string unusable;
  for (const FitRecord& record : records) {
    const std::string why = why_unusable(record.result);
    if (!why.empty()) unusable += wrapped(first(record), why, kWidth);
  }
  return unusable.empty() ? text : text + '\n' + ink.bad("No usable fit\n") + unusable;
}

/// What is wrong with the curve of one is so with all, and would be but a letter in the table.
std::string shared_warnings(std::span<const FitRecord> records, const Ink& ink) {
  if (records.size() < 2) return {};
  std::string text;
  for (const std::string& warning : records.front().target.warnings) {
    const bool is_shared = std::ranges::all_of(records, [&](const FitRecord& record) {
      const std::vector<std::string>& own = record.target.warnings;
      return std::ranges::find(own, warning) != own.end();
    });
    if (is_shared) text += wrapped("  ! ", printable(warning), kWidth);
  }
  return text.empty() ? text : '\n' + ink.bad("Warnings of all specimens\n") + text;
}

}  // namespace

std::string batch_report(std::span<const FitRecord> records, const ReportOptions& options) {
  const Ink ink(options.color);
  const Counts counts = count_statuses(records);
  std::string text;
  if (!records.empty()) text += specimens_text(records, options, ink);
  std::vector<RepairedCurve> repaired;
  for (const FitRecord& record : records) {
    repaired.push_back({record.target.name, record.target.repairs});
  }
  text += groups_text(records, options, ink) + names_text(records, ink) +
          repairs_text(repaired, options.specimens_shown, ink) + shared_warnings(records, ink);
  if (!text.empty()) text += '\n';
  const std::string last =
      fmt::format("fitted {}{}, rejected {}, failed {}\n", counts.fitted,
                  unusable_text(counts.unusable), counts.rejected, counts.failed);
  const bool all = counts.rejected + counts.failed + counts.unusable == 0;
  return text + (all ? ink.good(last) : ink.bad(last));
}

}  // namespace plastica::calibrate
