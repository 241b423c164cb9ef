#include "calibrate/report/scene_fit_plot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/scene_fit_figures.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"

namespace plastica::calibrate {
namespace {

using report::PlotScript;

using report::kSceneFitPictures;

constexpr auto kScenePlotKinds = report::listed(kSceneFitPictures);

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
  const report::SceneFitPicture& picture =
      request.what.empty() ? kSceneFitPictures.front()
                           : report::find_picture(kSceneFitPictures, request.what);
  const bool terminal = request.output == "-";
  if (picture.of_laws != nullptr) {
    report::refuse_law(request);
    return picture.of_laws(all, request.specimen, terminal);
  }
  split_label(all, request.specimen, request.law);
  const std::vector<SceneFitRecord> records = of_law(all, request.law);
  if (picture.of_all != nullptr) {
    if (!request.specimen.empty()) {
      throw InputError({}, "--case", request.specimen,
                       fmt::format("does not go with the picture '{}'", picture.name));
    }
    return picture.of_all(records, terminal);
  }
  SceneFitRecord record = find_fit(records, request.specimen);
  record.name = label_of(record, compares_laws(all));
  return picture.of_one(record, terminal);
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
