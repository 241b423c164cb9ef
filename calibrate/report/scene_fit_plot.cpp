#include "calibrate/report/scene_fit_plot.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "calibrate/report/interval_figures.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/scene_fit_figures.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"

namespace plastica::calibrate {
namespace {

using report::Figure;
using report::PlotScript;

constexpr std::array<PlotKind, 9> kScenePlotKinds = {{
    {"fit", "one fit: curves of each target, bands of 95 %, the break (choose it with --case)"},
    {"residuals", "measured minus fitted of each target, and the noise (--case)"},
    {"starts", "what the searches found, in rising order of their costs (--case)"},
    {"correlation", "correlations of the fitted parameters (--case)"},
    {"segments", "values over the length of the segments, and where they lead (--case)"},
    {"profile", "rise of the least cost over each parameter, of a fit with profiles (--case)"},
    {"bootstrap", "resampled values of the parameters and of pairs (--case)"},
    {"laws", "what each law of a comparison makes of the targets, and how far off it is (--case)"},
    {"population", "values and intervals of all fits, with mean and deviation of the specimens"},
}};

const SceneFitRecord& find_fit(std::span<const SceneFitRecord> records, const std::string& name) {
  if (name.empty()) return records.front();
  const auto found = std::ranges::find(records, name, &SceneFitRecord::name);
  if (found != records.end()) return *found;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(records.size(), 8); ++i) {
    names += (i == 0 ? "" : ", ") + records[i].name;
  }
  if (records.size() > 8) names += ", …";
  throw InputError({}, "--case", name, "is not a fit of this file; it has " + names);
}

PlotScript make(std::span<const SceneFitRecord> all, PlotRequest request) {
  if (all.empty()) throw InputError({}, "plot", request.what, "there is no fit to draw");
  const std::string what =
      request.what.empty() ? std::string(kScenePlotKinds[0].name) : request.what;
  if (std::ranges::find(kScenePlotKinds, what, &PlotKind::name) == kScenePlotKinds.end()) {
    throw InputError(
        {}, "--what", what,
        "must be fit, residuals, starts, correlation, segments, profile, bootstrap, laws or "
        "population");
  }
  const bool terminal = request.output == "-";
  const auto drawn = [&](const Figure& figure) {
    return terminal ? plastica::report::figure_terminal(figure)
                    : plastica::report::figure_page(figure);
  };
  if (what == "laws") {
    report::refuse_law(request);
    return drawn(report::laws_figure(all, request.specimen));
  }
  split_label(all, request.specimen, request.law);
  const std::vector<SceneFitRecord> records = of_law(all, request.law);
  if (what == "population") {
    if (!request.specimen.empty()) {
      throw InputError({}, "--case", request.specimen, "does not go with the picture 'population'");
    }
    return drawn(report::population_figure(records));
  }
  SceneFitRecord record = find_fit(records, request.specimen);
  record.name = label_of(record, compares_laws(all));
  if (what == "correlation") return report::correlation_plot(record, terminal);
  if (what == "segments") return drawn(report::segments_figure(record));
  if (what == "profile")
    return drawn(report::profile_figure(report::shown_intervals(record.result, record.name)));
  if (what == "bootstrap")
    return drawn(report::bootstrap_figure(report::shown_intervals(record.result, record.name)));
  if (what == "starts") return drawn(report::starts_figure(record));
  if (what == "residuals") return drawn(report::residuals_figure(record));
  return drawn(report::fit_figure(record, terminal));
}

}  // namespace

std::span<const PlotKind> scene_fit_plot_kinds() { return kScenePlotKinds; }

std::string scene_fit_plot_script(std::span<const SceneFitRecord> records,
                                  const PlotRequest& request) {
  return make(records, request).text();
}

void draw_scene_fit_plot(std::span<const SceneFitRecord> records, const PlotRequest& request,
                         std::ostream& standard_output) {
  plastica::report::check_picture_output(request.output);
  plastica::report::draw_picture(make(records, request), request.output, standard_output,
                                 request.overwrite);
}

}  // namespace plastica::calibrate
