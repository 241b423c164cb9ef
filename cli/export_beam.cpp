#include "cli/export_beam.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "calibrate/config/stored_scenes.hpp"
#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/engine_world.hpp"
#include "calibrate/engine/fitted_scene.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/find_record.hpp"
#include "cli/fit_targets.hpp"
#include "cli/input_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/units.hpp"
#include "plastica/model/numbered_place.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::cli {
namespace {

/// A scene, and where its material comes from.
struct BeamSource {
  Setup setup;
  std::vector<std::string> notes;
  std::vector<int> fitted_segments{};   ///< of the scenes of a fit, each number once
  std::optional<io::SceneFile> file{};  ///< that says all of it, if there is one
};

template <typename Record>
const Record& record_of(const BeamRequest& request, const std::vector<Record>& records) {
  if (request.which.empty() && records.size() == 1) return records.front();
  return find_record(records, request.which, request.file);
}

io::SceneFile read_beam(const std::string& path) {
  io::SceneFile file = io::read_scene_file(path, io::SceneUse::Beam);
  tell_notes(file.notes);
  return file;
}

Setup setup_of(const BeamRequest& request) {
  if (!request.scene.empty()) {
    expect_input(request.scene, {InputKind::Scene});
    return read_beam(request.scene).setup;
  }
  throw InputError({}, "--scene", "",
                   "is missing: a fit knows the material; a scene file has the beam");
}

BeamSource fitted_beam(const BeamRequest& request) {
  const calibrate::FitStoreContents contents = calibrate::read_fit_store(request.file);
  const calibrate::FitRecord& record = record_of(request, contents.records);
  BeamSource source{setup_of(request), {}};
  auto fitted = calibrate::fitted_scene(source.setup.scene, record, contents.options);
  source.setup.scene = std::move(fitted.scene);
  source.notes = std::move(fitted.notes);
  return source;
}

/// With how many segments a fit was made: of the scenes that are beams, each number once.
std::vector<int> segments_of(const std::vector<calibrate::StoredScene>& scenes,
                             const calibrate::SceneFitRecord& record) {
  std::vector<int> segments;
  for (const calibrate::StoredScene& scene : scenes) {
    if (!scene.setup || scene.setup->scene.is_coupon()) continue;
    const int n = scene.setup->scene.beam.segments;
    if (std::ranges::find(segments, n) == segments.end()) segments.push_back(n);
  }
  if (segments.empty() && record.result.segments) {
    segments.push_back(record.result.segments->segments);
  }
  return segments;
}

BeamSource scene_fitted_beam(const BeamRequest& request) {
  const auto contents = calibrate::read_scene_fit_store(request.file);
  const calibrate::SceneFitRecord& record = record_of(request, contents.records);
  const auto stored = calibrate::read_stored_scenes(contents.inputs);
  FitTargets targets(contents.records, record, stored ? &*stored : nullptr, request.target);
  // A stored scene goes before a file of its name: it is what was fitted.
  const bool is_stored =
      stored && std::ranges::find(stored->scenes, request.scene, &calibrate::StoredScene::name) !=
                    stored->scenes.end();
  const bool from_file =
      !request.scene.empty() && !is_stored && std::filesystem::is_regular_file(request.scene);
  if (from_file || !stored) {
    Setup setup = setup_of(request);
    const auto law = targets.harden(setup);
    auto fitted = calibrate::fitted_setup(setup, record, law);
    fitted.notes.emplace_back("What the fit held fixed or tied is the scene's.");
    if (!request.target.empty()) fitted.notes.push_back("hardening: of " + targets.names());
    return {std::move(fitted.setup), std::move(fitted.notes),
            segments_of(targets.scenes(), record)};
  }
  const calibrate::StoredScene& scene = targets.take_scene(request.scene);
  if (!scene.setup) throw InputError({}, "--scene", scene.name, scene.why_not);
  auto fitted = calibrate::fitted_setup(*scene.setup, record, targets.law(), stored->parameters);
  fitted.notes.push_back(
      fmt::format("scene: {}, as the fit has it for {}", scene.name, targets.names()));
  return {std::move(fitted.setup), std::move(fitted.notes), segments_of({scene}, record)};
}

/// A chain of some segments answers otherwise than the continuous beam, and fitted numbers make up
/// for it: those of one number are off for another.
void tell_of_segments(const BeamRequest& request, BeamSource& source) {
  const std::vector<int>& fitted = source.fitted_segments;
  if (fitted.empty()) return;
  const std::string with = fmt::format("{} segment{}", fmt::join(fitted, " and "),
                                       fitted.size() == 1 && fitted.front() == 1 ? "" : "s");
  source.notes.push_back("fitted with " + with + ": the numbers make up for what so many do");
  const int now = source.setup.scene.beam.segments;
  if (std::ranges::find(fitted, now) != fitted.end()) return;
  source.notes.push_back(
      fmt::format("the fit was made with {}, this beam has {}: the numbers may be off", with, now));
  tell("warning: {}: {}\n", request.file, source.notes.back());
}

/// A scene of its own: of a file, or of a result, which stores what every support holds, even a
/// pillar, as if it were given.
BeamSource beam_of_scene(const BeamRequest& request) {
  if (kind_of_input(request.file) == InputKind::Scene) {
    io::SceneFile file = read_beam(request.file);
    Setup setup = file.setup;
    return {std::move(setup), {}, {}, std::move(file)};
  }
  BeamSource source{io::read_scene_store(request.file).setup, {}};
  for (Support& support : source.setup.scene.supports) {
    if (support.hold == traits_of(support).held) support.hold.reset();
  }
  return source;
}

/// Whether a format has a world with an up axis and gravity.
bool has_world(calibrate::EngineFormat format) {
  using enum calibrate::EngineFormat;
  return format == Mjcf || format == Agx || format == Bullet || format == Chrono;
}

/// Whether a format's joints have the damping that is asked for.
bool takes_damping(calibrate::EngineFormat format) {
  using enum calibrate::EngineFormat;
  return format == Mjcf || format == Bullet || format == Chrono;
}

/// The world that the options ask for.
/// @throws InputError for what the format has not
calibrate::EngineWorld world_of(const BeamRequest& request, calibrate::EngineFormat format) {
  using enum calibrate::EngineFormat;
  const bool in_world = has_world(format);
  constexpr std::string_view kWithWorld = "goes with --to mjcf, agx, bullet or chrono";
  refuse_option(!request.up.empty() && !in_world, "--up", kWithWorld);
  refuse_option(!request.gravity.empty() && !in_world, "--gravity", kWithWorld);
  constexpr std::string_view kWithMjcf = "goes with --to mjcf";
  refuse_option(!request.damping.empty() && !takes_damping(format), "--damping",
                "goes with --to mjcf, bullet or chrono");
  refuse_option(!request.contacts.empty() && format != Mjcf, "--contacts", kWithMjcf);
  calibrate::EngineWorld world{.up = request.up};
  if (!request.gravity.empty()) {
    world.gravity = io::parse_quantity(request.gravity, Dimension::Acceleration, {}, "--gravity");
  }
  world.damping_time = seconds_of("--damping", request.damping);
  const auto words = contact_words();
  const auto contacts = std::ranges::find(words, request.contacts);
  if (contacts != words.end()) {
    world.contacts = static_cast<calibrate::EngineContacts>(contacts - words.begin());
  }
  return world;
}

}  // namespace

std::span<const std::string_view> contact_words() {
  static constexpr std::array<std::string_view, 3> kWords{"none", "others", "all"};
  return kWords;
}

std::string beam_text(const BeamRequest& request, ResultKind kind) {
  const auto words = calibrate::engine_formats();
  const auto format =
      static_cast<calibrate::EngineFormat>(std::ranges::find(words, request.to) - words.begin());
  const calibrate::EngineWorld world = world_of(request, format);
  BeamSource source = kind == ResultKind::Fits        ? fitted_beam(request)
                      : kind == ResultKind::SceneFits ? scene_fitted_beam(request)
                                                      : beam_of_scene(request);
  if (request.segments) {
    const std::string why =
        why_not_segments(source.setup.scene, source.setup.solver, *request.segments);
    if (!why.empty()) {
      throw InputError({}, "--segments", std::to_string(*request.segments), why);
    }
    set_field(source.setup, find_field("beam.segments"), static_cast<double>(*request.segments), {},
              std::to_string(*request.segments));
  }
  for (const std::string& note : source.notes) {
    if (note.starts_with("NO USABLE FIT") || note.starts_with("a poor fit")) {
      tell("warning: {}: {}\n", request.file, note);
    }
  }
  tell_of_segments(request, source);
  const auto read = [&] { return calibrate::engine_beam(source.setup.scene, source.setup.solver); };
  calibrate::EngineBeam beam = source.file ? io::with_place_in(*source.file, read) : read();
  calibrate::put_into(world, beam);
  for (const std::string& note : calibrate::engine_notes(beam, format)) {
    tell("note: {}\n", note);
  }
  if (has_world(format) && beam.gravity == std::array<double, 3>{}) {
    tell("note: no gravity, as in the scene; --gravity sets it\n");
  }
  if (takes_damping(format) && request.damping.empty()) {
    tell("note: --damping sets what times its stiffness damps a joint\n");
  }
  beam.notes.insert(beam.notes.begin(), source.notes.begin(), source.notes.end());
  return calibrate::engine_text(beam, format);
}

}  // namespace plastica::cli
