#pragma once

#include <span>
#include <string>

#include "calibrate/fit/result.hpp"

namespace plastica::cli {

/// The record of a specimen. @throws InputError that names the file and specimens there are
const calibrate::FitRecord& find_record(std::span<const calibrate::FitRecord> records,
                                        const std::string& specimen, const std::string& file);

}  // namespace plastica::cli
