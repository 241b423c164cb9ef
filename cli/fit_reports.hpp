#pragma once

#include <string>
#include <type_traits>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"

/// What commands write of the contents of a result file of fits, of curves or through scenes.
namespace plastica::cli {

/// Reads a file of either kind. @param samples  of fits of curves @throws InputError
template <class Contents>
Contents read_fits(const std::string& path, calibrate::FitSamples samples) {
  if constexpr (std::is_same_v<Contents, calibrate::SceneFitContents>) {
    return calibrate::read_scene_fit_store(path);
  } else {
    return calibrate::read_fit_store(path, samples);
  }
}

/// The summary for scripts.
std::string json_of(const calibrate::FitStoreContents& contents);
std::string json_of(const calibrate::SceneFitContents& contents);

/// Prints the report. Records are put into another order where laws are compared.
/// @param all  the whole report of each fit, and of all that there are
void print_fits(calibrate::FitStoreContents& contents, bool all = false);
void print_fits(calibrate::SceneFitContents& contents, bool all = false);

/// Prints the whole report of one fit. @throws InputError if there is none of that name
void print_fit(const calibrate::FitStoreContents& contents, const std::string& name,
               const std::string& file);
void print_fit(const calibrate::SceneFitContents& contents, const std::string& name,
               const std::string& file);

}  // namespace plastica::cli
