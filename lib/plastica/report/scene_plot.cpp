#include "plastica/report/scene_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/picture.hpp"
#include "plastica/report/scene_curves.hpp"
#include "plastica/report/scene_shape.hpp"

namespace plastica::report {
namespace {

constexpr std::array<ScenePlotKind, 5> kKinds = {{
    {"shape", "the beam before and after, in its plane or in space; colour: plastic strain"},
    {"moment", "moments along the beam at the last sample; several files lie over each other"},
    {"joint", "stress over strain of a joint (--joint N; else that of the largest strain)"},
    {"load", "load factor over a probe (--probe NAME; else the first displacement)"},
    {"energy", "elastic, plastic, external and residual energy over time"},
}};

bool has_picture(const io::SceneRecord& record, std::string_view name) {
  if (record.response.samples == 0) return false;
  if (record.level == Level::Coupon) return name == "joint" && coupon_stress(record) != nullptr;
  return name != "load" || !record.setup.scene.probes.empty();
}

std::string names_of(const io::SceneRecord& record) {
  std::string names;
  for (const ScenePlotKind& kind : scene_plot_kinds_of(record)) {
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return names;
}

PlotScript make(std::span<const io::SceneRecord> records, const ScenePlotRequest& request) {
  const auto kinds = scene_plot_kinds_of(records.front());
  if (kinds.empty()) throw InputError({}, "plot", request.what, "there is no sample to draw");
  const std::string what = request.what.empty() ? std::string(kinds.front().name) : request.what;
  for (const io::SceneRecord& record : records) {
    if (has_picture(record, what) &&
        std::any_of(kKinds.begin(), kKinds.end(), [&](const auto& k) { return k.name == what; })) {
      continue;
    }
    throw InputError({}, "--what", what, "must be one of " + names_of(record) + " for this file");
  }
  if (request.joint && what != "joint") {
    throw InputError({}, "--joint", std::to_string(*request.joint), "goes with --what joint only");
  }
  if (!request.probe.empty() && what != "load") {
    throw InputError({}, "--probe", request.probe, "goes with --what load only");
  }
  if (records.size() > 1 && (what == "shape" || what == "energy")) {
    throw InputError({}, "--what", what, "is drawn of one file at a time");
  }
  const bool terminal = request.output == "-";
  if (what == "shape") {
    return terminal ? shape_terminal(records.front()) : shape_page(records.front());
  }
  Figure figure;
  if (what == "moment") figure = moment_figure(records);
  if (what == "joint") figure = joint_figure(records, request.joint);
  if (what == "load") figure = load_figure(records, request.probe);
  if (what == "energy") figure = energy_figure(records.front());
  return terminal ? figure_terminal(figure) : figure_page(figure);
}

}  // namespace

std::span<const ScenePlotKind> scene_plot_kinds() { return kKinds; }

std::vector<ScenePlotKind> scene_plot_kinds_of(const io::SceneRecord& record) {
  std::vector<ScenePlotKind> kinds;
  for (const ScenePlotKind& kind : kKinds) {
    if (has_picture(record, kind.name)) kinds.push_back(kind);
  }
  return kinds;
}

std::string scene_plot_script(std::span<const io::SceneRecord> records,
                              const ScenePlotRequest& request) {
  return make(records, request).text();
}

void draw_scene_plot(std::span<const io::SceneRecord> records, const ScenePlotRequest& request,
                     std::ostream& standard_output) {
  check_picture_output(request.output);
  draw_picture(make(records, request), request.output, standard_output);
}

}  // namespace plastica::report
