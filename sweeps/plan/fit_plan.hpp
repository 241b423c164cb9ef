#pragma once

#include <cstdint>
#include <string>

#include "calibrate/fit/scene_fit.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::sweeps {

/// The fit that each case of a sweep makes: a measured curve that its scene is to follow.
struct FitPlan {
  calibrate::SceneTarget target;
  calibrate::SceneFitOptions options;
  std::string file;  ///< of the curve
  std::string text;  ///< what stands in it
};

/// Reads [fit]: `target`, `abscissa` and `ordinate` (`probe`, `column`, `factor`), `noise`,
/// `parameters` as in a fit file with bounds, `evaluations`, `starts`, `seed`.
/// @param path  of the sweep's file, where relative paths begin
/// @throws InputError
FitPlan read_fit_plan(const io::TomlTable& fit, const std::string& path, const Scene& scene);

/// Digest of all that decides what the fit of a scene gives.
std::uint64_t digest_of(const FitPlan& plan);

}  // namespace plastica::sweeps
