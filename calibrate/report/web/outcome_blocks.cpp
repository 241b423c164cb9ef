#include "calibrate/report/web/outcome_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "calibrate/report/interval_figures.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/shown_intervals.hpp"

namespace plastica::calibrate::report {
namespace {

/// The squares of the four errors add up (`FittedParameter::standard_error`); none where the others
/// are all of it but for rounding.
std::optional<double> error_of_segments(const FittedParameter& p) {
  const double rest = p.standard_error * p.standard_error - p.noise_error * p.noise_error -
                      p.sampling_error * p.sampling_error - p.misfit_error * p.misfit_error;
  if (!(rest > 1e-9 * p.standard_error * p.standard_error)) return std::nullopt;
  return std::sqrt(rest);
}

}  // namespace

Json in_unit(std::optional<double> value, const DisplayUnit& unit) {
  if (!value) return nullptr;
  return number(*value / unit.scale);
}

std::string percent_from(double confidence) {
  return fmt::format("{:.4g} % from", 100.0 * confidence);
}

Json parameters_block(const FitOutcome& fit, double confidence) {
  // As many digits as the smallest error of a value shows.
  constexpr int kLeast = 5;
  constexpr int kMost = 12;
  int digits = kLeast;
  for (const FittedParameter& p : fit.parameters) {
    if (!(p.standard_error > 0.0) || p.value == 0.0) continue;
    const double size = std::log10(std::fabs(p.value) / p.standard_error);
    digits = std::clamp(static_cast<int>(std::ceil(size)) + 2, digits, kMost);
  }
  WebTable table("Parameters");
  table.add_words("parameter");
  table.add_words("unit");
  table.add_numbers("value", "", "", digits);
  table.add_numbers("standard error", "", "noise, sampling, misfit and segments together", 2);
  table.add_numbers("of noise", "", "as if residuals were independent", 2);
  table.add_numbers("of sampling", "", "of a break, which lies between two samples", 2);
  table.add_numbers("of misfit", "", "of a model that does not follow the curve", 2);
  table.add_numbers("of segments", "", "what of the error none of these is", 2);
  table.add_numbers(percent_from(confidence), "", "confidence interval", digits);
  table.add_numbers("to", "", "", digits);
  table.add_numbers("bound from");
  table.add_numbers("bound to");
  table.add_words("verdict");
  for (const FittedParameter& p : fit.parameters) {
    const DisplayUnit unit = display_unit(p);
    const auto cell = [&](double value) { return in_unit(value, unit); };
    const bool free = p.role == ParameterRole::Free;
    table.add_row({short_name(p.path), unit.name, cell(p.value), cell(p.standard_error),
                   cell(p.noise_error), cell(p.sampling_error), cell(p.misfit_error),
                   in_unit(error_of_segments(p), unit), cell(p.interval_low), cell(p.interval_high),
                   free ? cell(p.lower) : Json(nullptr), free ? cell(p.upper) : Json(nullptr),
                   verdict_text(p)});
  }
  return table.block();
}

Json correlations_block(const FitOutcome& fit,
                        const std::vector<const FittedParameter*>& parameters) {
  const std::size_t n = parameters.size();
  if (n < 2 || fit.correlation.size() != n * n) return nullptr;
  WebTable table("Correlations");
  table.add_words("parameter");
  for (const FittedParameter* p : parameters) table.add_numbers(short_name(p->path));
  for (std::size_t i = 0; i < n; ++i) {
    Json cells = {short_name(parameters[i]->path)};
    for (std::size_t k = 0; k < n; ++k) cells.push_back(number(fit.correlation[i * n + k]));
    table.add_row(std::move(cells));
  }
  return table.block();
}

void add_intervals(Json& blocks, const FitOutcome& fit, const std::string& name) {
  const ShownIntervals shown = shown_intervals(fit, name);
  const auto add = [&](std::string title, Figure figure) {
    figure.title = std::move(title);
    blocks.push_back(plastica::report::web_figure(figure));
  };
  if (!fit.intervals.profiles.empty()) {
    add("Profiles: rise of the least cost", profile_figure(shown));
  }
  if (fit.intervals.residuals.resamples > 0 || fit.intervals.specimens.resamples > 0) {
    add("Bootstrap", bootstrap_figure(shown));
  }
}

WebParameters::WebParameters(std::span<const FitOutcome* const> fits) {
  std::vector<double> largest;
  for (const FitOutcome* fit : fits) {
    for (const FittedParameter& p : fit->parameters) {
      auto at = std::ranges::find_if(columns_, [&](const Column& c) { return c.path == p.path; });
      if (at == columns_.end()) {
        at = columns_.insert(columns_.end(), {p.path, p.dimension});
        largest.push_back(0.0);
      }
      double& most = largest[static_cast<std::size_t>(at - columns_.begin())];
      if (fit->is_fitted()) most = std::max(most, std::fabs(p.value));
    }
  }
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    columns_[c].unit = display_unit_of(columns_[c].path, columns_[c].dimension, largest[c]);
  }
}

void WebParameters::add_to(WebTable& table) const {
  for (const Column& column : columns_) {
    table.add_numbers(short_name(column.path), std::string(column.unit.name), column.path);
    table.add_numbers("±", std::string(column.unit.name), "standard error of the one before", 2);
  }
}

void WebParameters::add_cells(const FitOutcome& fit, Json& cells) const {
  for (const Column& column : columns_) {
    const FittedParameter* p = nullptr;
    for (const FittedParameter& one : fit.parameters) {
      if (one.path == column.path) p = &one;
    }
    const bool there = p != nullptr && fit.is_fitted();
    cells.push_back(there && p->identified ? in_unit(p->value, column.unit) : Json(nullptr));
    cells.push_back(there && p->has_error() ? in_unit(p->standard_error, column.unit)
                                            : Json(nullptr));
  }
}

}  // namespace plastica::calibrate::report
