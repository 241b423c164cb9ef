#include "calibrate/report/plot.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_figures.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"

namespace plastica::calibrate {
namespace {

using report::PlotScript;

constexpr auto kCurveKinds = report::listed(report::kFitPictures);
constexpr auto kSceneKinds = report::listed(report::kSceneFitPictures);

const auto& pictures_of(std::span<const FitRecord>) { return report::kFitPictures; }
const auto& pictures_of(std::span<const SceneFitRecord>) { return report::kSceneFitPictures; }

/// The picture where none is asked for.
std::string default_of(std::span<const FitRecord> records, bool is_one) {
  return std::string(is_one || records.size() == 1 ? "curve" : "overview");
}
std::string default_of(std::span<const SceneFitRecord>, bool) { return "fit"; }

void set_name(FitRecord& record, std::string name) { record.target.name = std::move(name); }
void set_name(SceneFitRecord& record, std::string name) { record.name = std::move(name); }

/// What a record is called in errors.
template <typename Record>
constexpr std::string_view kNoun = std::is_same_v<Record, FitRecord> ? "specimen" : "fit";

template <typename Record>
const Record& find_named(const std::vector<Record>& records, const std::string& name) {
  if (name.empty()) return records.front();
  std::string names;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (name_of(records[i]) == name) return records[i];
    if (i < 8) names += (i == 0 ? "" : ", ") + name_of(records[i]);
  }
  if (records.size() > 8) names += ", …";
  throw InputError({}, "--case", name,
                   fmt::format("is not a {} of this file; it has {}", kNoun<Record>, names));
}

template <typename Record>
PlotScript make(std::span<const Record> all, PlotRequest request) {
  if (all.empty()) {
    throw InputError({}, "plot", request.what,
                     fmt::format("there is no {} to draw", kNoun<Record>));
  }
  const auto sheet = plastica::report::sheet_of(request.output, request.width);
  if (!request.what.empty()) {
    const auto& picture = report::find_picture(pictures_of(all), request.what);
    if (picture.of_laws != nullptr) {
      report::refuse_law(request);
      return picture.of_laws(all, request.specimen, sheet);
    }
  }
  split_label(all, request.specimen, request.law);
  const std::vector<Record> records = of_law(all, request.law);
  if (request.what.empty()) request.what = default_of(records, !request.specimen.empty());
  const auto& picture = report::find_picture(pictures_of(all), request.what);
  if (picture.of_one != nullptr) {
    Record record = find_named(records, request.specimen);
    set_name(record, label_of(record, compares_laws(all)));
    return picture.of_one(record, sheet);
  }
  if (!request.specimen.empty()) {
    throw InputError({}, "--case", request.specimen,
                     fmt::format("does not go with the picture '{}'", picture.name));
  }
  return picture.of_all(records, sheet);
}

template <typename Record>
void draw(std::span<const Record> records, const PlotRequest& request, std::ostream& out) {
  plastica::report::check_picture_output(request.output);
  plastica::report::draw_picture(make(records, request), request.output, out, request.overwrite);
}

}  // namespace

std::span<const PlotKind> plot_kinds() { return kCurveKinds; }
std::span<const PlotKind> scene_fit_plot_kinds() { return kSceneKinds; }

std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request) {
  report::require_curves(records);
  return make(records, request).text();
}
std::string plot_script(std::span<const SceneFitRecord> records, const PlotRequest& request) {
  return make(records, request).text();
}

void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output) {
  report::require_curves(records);
  draw(records, request, standard_output);
}
void draw_plot(std::span<const SceneFitRecord> records, const PlotRequest& request,
               std::ostream& standard_output) {
  draw(records, request, standard_output);
}

}  // namespace plastica::calibrate
