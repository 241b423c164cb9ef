#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/model/field.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::calibrate {

/// A scene with the material of a fit, and what came from where.
struct FittedScene {
  Scene scene;
  /// A sentence for each parameter: its value and standard error, or why the scene's own number
  /// stays.
  std::vector<std::string> notes;
};

/// Puts the numbers of a fit into a scene's material: every parameter of the fit, fixed and tied
/// ones too, but for those that the curve does not determine, and the hardening that the fit was
/// made with. A region that has a number from the scene's own material gets the fitted one as well.
/// All else (density, section, beam, rules) is the scene's.
/// @param record   a fit that found parameters
/// @param options  what it was told
/// @throws InputError if there is no fit, or a region's material ends up with impossible numbers
FittedScene fitted_scene(const Scene& scene, const FitRecord& record, const FitOptions& options);

/// A scene and its solver with the numbers of a fit through scenes.
struct FittedSetup {
  Setup setup;
  std::vector<std::string> notes;  ///< a sentence for each parameter
};

/// The same for a fit through scenes, whose parameters may be any fields. The record knows the free
/// ones alone.
/// @param law  of the fit's targets that the setup is for: it gets that one, with the numbers of
///             its own hardening that the fit does not have. Empty: it keeps its own
/// @param parameters  of the fit, for the fixed and tied ones among them; empty: what the fit held
///                    is the setup's
/// @throws InputError if there is no fit, or a value does not suit the setup
FittedSetup fitted_setup(const Setup& setup, const SceneFitRecord& record, std::optional<Law> law,
                         std::span<const Parameter> parameters = {});

}  // namespace plastica::calibrate
