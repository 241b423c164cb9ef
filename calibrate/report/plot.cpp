#include "calibrate/report/plot.hpp"

#include <algorithm>
#include <array>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"

namespace plastica::calibrate {
namespace {

using report::PlotScript;

using report::kFitPictures;

constexpr auto kPlotKinds = report::listed(kFitPictures);

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
  const bool terminal = request.output == "-";
  if (!request.what.empty()) {
    const report::FitPicture& picture = report::find_picture(kFitPictures, request.what);
    if (picture.of_laws != nullptr) {
      report::refuse_law(request);
      return picture.of_laws(all, request.specimen, terminal);
    }
  }
  split_label(all, request.specimen, request.law);
  const std::vector<FitRecord> records = of_law(all, request.law);
  const bool is_one = records.size() == 1 || !request.specimen.empty();
  const report::FitPicture& picture =
      request.what.empty() ? report::find_picture(kFitPictures, is_one ? "curve" : "overview")
                           : report::find_picture(kFitPictures, request.what);
  if (picture.of_one != nullptr) {
    FitRecord record = find_specimen(records, request.specimen);
    record.target.name = label_of(record, compares_laws(all));
    return picture.of_one(record, terminal);
  }
  if (!request.specimen.empty()) {
    throw InputError({}, "--case", request.specimen, "goes with pictures of one specimen only");
  }
  return picture.of_all(records, terminal);
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
