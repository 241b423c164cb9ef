#include "calibrate/report/plot.hpp"

#include <algorithm>
#include <array>

#include "calibrate/report/interval_figures.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"

namespace plastica::calibrate {
namespace {

using report::PlotScript;

constexpr std::array<PlotKind, 6> kPlotKinds = {{
    {"curve", "one specimen: measured and fitted curve, yield and break (choose it with --case)"},
    {"overview", "all curves by group, with their mean, the fits and the breaks"},
    {"parameters", "the fitted parameters of all specimens by group"},
    {"profile", "rise of the least cost over each parameter, of a fit with profiles (--case)"},
    {"bootstrap", "resampled values of the parameters and of pairs (--case)"},
    {"laws", "what each law of a comparison makes of one specimen, and how far off it is (--case)"},
}};

const FitRecord& find_specimen(std::span<const FitRecord> records, const std::string& name) {
  if (name.empty()) return records.front();
  for (const FitRecord& record : records) {
    if (record.target.name == name) return record;
  }
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(records.size(), 8); ++i) {
    names += (i == 0 ? "" : ", ") + records[i].target.name;
  }
  if (records.size() > 8) names += ", …";
  throw InputError({}, "--case", name, "is not a specimen of this file; it has " + names);
}

PlotScript make(std::span<const FitRecord> all, PlotRequest request) {
  if (all.empty()) throw InputError({}, "plot", request.what, "there is no specimen to draw");
  std::string what = request.what;
  if (what == "laws") {
    report::refuse_law(request);
    const auto figure = report::laws_figure(all, request.specimen);
    return request.output == "-" ? plastica::report::figure_terminal(figure)
                                 : plastica::report::figure_page(figure);
  }
  split_label(all, request.specimen, request.law);
  const std::vector<FitRecord> records = of_law(all, request.law);
  const auto specimen = [&] {
    FitRecord record = find_specimen(records, request.specimen);
    record.target.name = label_of(record, compares_laws(all));
    return record;
  };
  if (what.empty()) what = records.size() == 1 || !request.specimen.empty() ? "curve" : "overview";
  const bool terminal = request.output == "-";
  if (what == "curve") {
    const FitRecord record = specimen();
    return terminal ? report::curve_terminal(record) : report::curve_plot(record);
  }
  if (what == "profile" || what == "bootstrap") {
    const FitRecord record = specimen();
    const auto shown = report::shown_intervals(record.result, record.name());
    const auto figure =
        what == "profile" ? report::profile_figure(shown) : report::bootstrap_figure(shown);
    return terminal ? plastica::report::figure_terminal(figure)
                    : plastica::report::figure_page(figure);
  }
  if (what != "overview" && what != "parameters") {
    throw InputError({}, "--what", what,
                     "must be curve, overview, parameters, profile, bootstrap or laws");
  }
  if (!request.specimen.empty()) {
    throw InputError({}, "--case", request.specimen, "goes with pictures of one specimen only");
  }
  if (what == "overview") {
    return terminal ? report::overview_terminal(records) : report::overview_plot(records);
  }
  return terminal ? report::parameters_terminal(records) : report::parameters_plot(records);
}

}  // namespace

std::span<const PlotKind> plot_kinds() { return kPlotKinds; }

std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request) {
  return make(records, request).text();
}

void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output) {
  plastica::report::check_picture_output(request.output);
  plastica::report::draw_picture(make(records, request), request.output, standard_output,
                                 request.overwrite);
}

}  // namespace plastica::calibrate
