#pragma once

/// What a program includes that calibrates: targets, options, `fit`, and its results in a file.
///
///     #include <calibrate/calibrate.hpp>
///
///     calibrate::FitFile asked = calibrate::read_fit_file("fit.toml");
///     std::vector<calibrate::Target> targets = calibrate::import_all(asked);
///     std::vector<calibrate::FitResult> results = calibrate::fit(targets, asked.options);
///
/// Curves that a program has made itself become targets by `make_target`; `fit` takes beams, too,
/// as scenes with a curve each (`WeightedTarget`). All else in calibrate/ is its own affair.
#include "calibrate/config/fit_file.hpp"
#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "calibrate/target/import.hpp"
#include "calibrate/target/make.hpp"
#include "calibrate/target/scene_target.hpp"
