#pragma once

#include <span>
#include <string>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::cli {

/// The record of a specimen. @throws InputError that names the file and specimens there are
const calibrate::FitRecord& find_record(std::span<const calibrate::FitRecord> records,
                                        const std::string& specimen, const std::string& file);
/// The record of a fit through scenes. @throws InputError likewise
const calibrate::SceneFitRecord& find_record(std::span<const calibrate::SceneFitRecord> records,
                                             const std::string& fit, const std::string& file);

}  // namespace plastica::cli
