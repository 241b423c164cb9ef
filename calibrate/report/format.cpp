#include "calibrate/report/format.hpp"

#include <fmt/format.h>

namespace plastica::calibrate::report {

std::string reason_of(const FitRecord& record) {
  if (record.result.status == FitStatus::Fitted) return {};
  return record.result.reason.empty() ? record.target.reason : record.result.reason;
}

std::string unusable_text(std::size_t count) {
  return count == 0 ? std::string() : fmt::format(" ({} of no use)", count);
}

DisplayUnit display_unit_of(std::string_view path, Dimension dimension, double size) {
  return plastica::report::display_unit(dimension, size, path.find("modulus") != path.npos);
}

std::string sentence_of(const Repair& repair) {
  const std::string count = std::to_string(repair.count) + ' ';
  return repair.text.starts_with(count) ? repair.text.substr(count.size()) : repair.text;
}

}  // namespace plastica::calibrate::report
