#include "cli/export_beam.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/fitted_scene.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/find_record.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/scene_store.hpp"

namespace plastica::cli {
namespace {

/// A scene, and where its material comes from.
struct BeamSource {
  Setup setup;
  std::vector<std::string> notes;
};

template <typename Record>
const Record& record_of(const BeamRequest& request, const std::vector<Record>& records) {
  if (request.which.empty() && records.size() == 1) return records.front();
  return find_record(records, request.which, request.file);
}

Setup setup_of(const BeamRequest& request) {
  if (!request.scene.empty()) return io::read_scene_file(request.scene).setup;
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

BeamSource scene_fitted_beam(const BeamRequest& request) {
  const auto contents = calibrate::read_scene_fit_store(request.file);
  const calibrate::SceneFitRecord& record = record_of(request, contents.records);
  auto fitted = calibrate::fitted_setup(setup_of(request), record);
  fitted.notes.emplace_back("What the fit held fixed or tied is the scene's.");
  return {std::move(fitted.setup), std::move(fitted.notes)};
}

/// The scene of a result, which stores what every support holds, even a pillar, as if it were
/// given.
BeamSource simulated_beam(const BeamRequest& request) {
  BeamSource source{io::read_scene_store(request.file).setup, {}};
  for (Support& support : source.setup.scene.supports) {
    Support usual;
    usual.kind = support.kind;
    if (support.hold == usual.held()) support.hold.reset();
  }
  return source;
}

}  // namespace

std::string beam_text(const BeamRequest& request, ResultKind kind) {
  BeamSource source = kind == ResultKind::Fits        ? fitted_beam(request)
                      : kind == ResultKind::SceneFits ? scene_fitted_beam(request)
                                                      : simulated_beam(request);
  if (request.segments) {
    set_field(source.setup, find_field("beam.segments"), static_cast<double>(*request.segments), {},
              std::to_string(*request.segments));
  }
  calibrate::EngineBeam beam = calibrate::engine_beam(source.setup.scene, source.setup.solver);
  const auto words = calibrate::engine_formats();
  const auto format = static_cast<calibrate::EngineFormat>(
      std::find(words.begin(), words.end(), request.to) - words.begin());
  for (const std::string& note : calibrate::engine_notes(beam, format)) {
    fmt::print(stderr, "note: {}\n", note);
  }
  beam.notes.insert(beam.notes.begin(), source.notes.begin(), source.notes.end());
  return calibrate::engine_text(beam, format);
}

}  // namespace plastica::cli
