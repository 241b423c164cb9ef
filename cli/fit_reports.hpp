#pragma once

#include <string>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"

/// What commands write of the contents of a result file of fits, of curves or through scenes.
namespace plastica::cli {

/// Reads either kind of file. @throws InputError
void read_fits(const std::string& path, calibrate::FitStoreContents& contents);
void read_fits(const std::string& path, calibrate::SceneFitContents& contents);

void write_fits(const std::string& path, const calibrate::FitStoreContents& contents,
                io::Overwrite overwrite);
void write_fits(const std::string& path, const calibrate::SceneFitContents& contents,
                io::Overwrite overwrite);

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
