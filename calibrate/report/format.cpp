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

std::string size_of(const Correction& correction) {
  if (correction.unit == "1") return fmt::format("{:+.3g} %", 100.0 * correction.amount);
  if (correction.unit == "Pa") {
    const DisplayUnit unit = display_unit(Dimension::Stress, correction.amount);
    return fmt::format("{:+.3g} {}", correction.amount / unit.scale, unit.name);
  }
  if (correction.unit == "samples" && correction.amount >= 0.0) {
    return counted(static_cast<std::size_t>(correction.amount), "sample");
  }
  return quantity(fmt::format("{:.6g}", correction.amount), correction.unit);
}

}  // namespace plastica::calibrate::report
