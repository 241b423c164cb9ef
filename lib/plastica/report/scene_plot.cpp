#include "plastica/report/scene_plot.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/picture.hpp"
#include "plastica/report/scene_curves.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_film.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_history.hpp"
#include "plastica/report/scene_shape.hpp"
#include "plastica/report/scene_spectrum.hpp"

namespace plastica::report {
namespace {

constexpr std::array<ScenePlotKind, 8> kKinds = {{
    {"shape", "the beam before and at --time T; colour: plastic strain"},
    {"film", "--frames N of the beam, --from T --to T; colour: plastic strain"},
    {"moment", "moments along the beam at --time T; several files lie over each other"},
    {"joint",
     "stress over strain of a joint (--joint N; else that which broke, or of the largest strain)"},
    {"load", "load factor over a probe (--probe NAME; else the first displacement)"},
    {"history", "a probe over time (--probe NAME; else the first displacement)"},
    {"energy", "the energy balance over time"},
    {"spectrum", "frequencies of a probe (--probe NAME; else the first displacement)"},
}};

bool has_picture(const io::SceneRecord& record, std::string_view name) {
  if (record.response.samples == 0) return false;
  if (record.level == Level::Coupon) return name == "joint" && coupon_stress(record) != nullptr;
  if (name == "film") return frames_of(record) > 1;
  if (name == "spectrum" && !has_spectra(record)) return false;
  const bool of_probe = name == "load" || name == "history" || name == "spectrum";
  return !of_probe || !record.setup.scene.probes.empty();
}

std::string names_of(const io::SceneRecord& record) {
  std::string names;
  for (const ScenePlotKind& kind : scene_plot_kinds_of(record)) {
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return names;
}

/// Refuses an option that does not go with a picture.
void check_options(const ScenePlotRequest& request, std::string_view what) {
  const auto only_with = [&](bool given, std::string_view option, const std::string& value,
                             std::initializer_list<std::string_view> kinds) {
    if (!given || std::find(kinds.begin(), kinds.end(), what) != kinds.end()) return;
    throw InputError({}, option, value,
                     fmt::format("goes with --what {} only", fmt::join(kinds, ", ")));
  };
  const auto seconds = [](const std::optional<double>& time) {
    return time ? brief(*time) + " s" : std::string();
  };
  only_with(request.joint.has_value(), "--joint",
            request.joint ? std::to_string(*request.joint) : "", {"joint"});
  only_with(!request.probe.empty(), "--probe", request.probe, {"load", "history", "spectrum"});
  only_with(request.time.has_value(), "--time", seconds(request.time), {"shape", "moment"});
  only_with(request.film_frames.has_value(), "--frames",
            request.film_frames ? std::to_string(*request.film_frames) : "", {"film"});
  only_with(request.film_from.has_value(), "--from", seconds(request.film_from), {"film"});
  only_with(request.film_to.has_value(), "--to", seconds(request.film_to), {"film"});
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
  check_options(request, what);
  for (const io::SceneRecord& record : records) {
    check_time(record, "--time", request.time);
    check_time(record, "--from", request.film_from);
    check_time(record, "--to", request.film_to);
  }
  if (records.size() > 1 && (what == "shape" || what == "film" || what == "energy")) {
    throw InputError({}, "--what", what, "is drawn of one file at a time");
  }
  const Sheet sheet = sheet_of(request.output, request.width);
  const bool terminal = sheet.terminal;
  const io::SceneRecord& first = records.front();
  if (what == "shape") {
    return terminal ? shape_terminal(first, request.time) : shape_page(first, request.time, sheet);
  }
  if (what == "film") {
    const FilmRequest film{request.film_frames.value_or(FilmRequest{}.frames), request.film_from,
                           request.film_to};
    return terminal ? film_terminal(first, film) : film_page(first, film, sheet);
  }
  Figure figure;
  if (what == "moment") figure = moment_figure(records, request.time);
  if (what == "joint") figure = joint_figure(records, request.joint);
  if (what == "load") figure = load_figure(records, request.probe);
  if (what == "history") figure = history_figure(records, request.probe);
  if (what == "energy") figure = energy_figure(first, !terminal);
  if (what == "spectrum") figure = spectrum_figure(records, request.probe, terminal);
  return drawn(figure, sheet);
}

}  // namespace

std::span<const ScenePlotKind> scene_plot_kinds() { return kKinds; }

std::vector<ScenePlotKind> scene_plot_kinds_of(const io::SceneRecord& record) {
  std::vector<ScenePlotKind> kinds;
  for (const ScenePlotKind& kind : kKinds) {
    if (has_picture(record, kind.name)) kinds.push_back(kind);
  }
  if (is_motion(record) && kinds.size() > 1 && kinds[1].name == "film") {
    std::swap(kinds[0], kinds[1]);
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
  draw_picture(make(records, request), request.output, standard_output, request.overwrite);
}

}  // namespace plastica::report
