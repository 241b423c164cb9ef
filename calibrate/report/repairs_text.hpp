#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "calibrate/report/text.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/ink.hpp"

/// What was mended in measured curves, of coupons and of beams; not installed. Each section is
/// empty where there is nothing to say, and begins with an empty line.
namespace plastica::calibrate::report {

/// The repairs of one curve, a line each.
std::string repairs_text(std::span<const Repair> repairs, const plastica::report::Ink& ink);

/// A curve among several.
struct RepairedCurve {
  std::string_view name;
  std::span<const Repair> repairs;
};

/// Repairs by kind and sentence, each sentence once, with the curves that it holds for.
/// @param shown  of these at most; 0: all
std::string repairs_text(std::span<const RepairedCurve> curves, std::size_t shown,
                         const plastica::report::Ink& ink);

/// Those of the targets of fits through scenes; of a lone target a line each.
std::string repairs_text(std::span<const SceneFitRecord> records, const ReportOptions& options,
                         const plastica::report::Ink& ink);

}  // namespace plastica::calibrate::report
