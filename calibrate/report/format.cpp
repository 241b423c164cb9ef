#include "calibrate/report/format.hpp"

#include <fmt/format.h>

namespace plastica::calibrate::report {

std::string_view word_of(FitStatus status) {
  switch (status) {
    case FitStatus::Fitted: return "fitted";
    case FitStatus::Failed: return "failed";
    case FitStatus::Rejected: return "rejected";
  }
  return "unknown";
}

std::string_view word_of(TargetStatus status) {
  switch (status) {
    case TargetStatus::Ready: return "ready";
    case TargetStatus::TooCoarse: return "too-coarse";
    case TargetStatus::Rejected: return "rejected";
  }
  return "unknown";
}

std::string_view word_of(Test test) {
  switch (test) {
    case Test::Tension: return "tension";
    case Test::Bending: return "bending";
    case Test::Torsion: return "torsion";
  }
  return "unknown";
}

std::string_view word_of(Measure measure) {
  return measure == Measure::True ? "true" : "engineering";
}

std::string_view word_of(Loading loading) {
  return loading == Loading::Cyclic ? "cyclic" : "monotonic";
}

std::string_view word_of(ParameterRole role) {
  switch (role) {
    case ParameterRole::Free: return "free";
    case ParameterRole::Fixed: return "fixed";
    case ParameterRole::Tied: return "tied";
  }
  return "unknown";
}

std::string reason_of(const FitRecord& record) {
  if (record.result.status == FitStatus::Fitted) return {};
  return record.result.reason.empty() ? record.target.reason : record.result.reason;
}

DisplayUnit display_unit_of(std::string_view path, Dimension dimension, double size) {
  return plastica::report::display_unit(dimension, size, path.find("modulus") != path.npos);
}

std::string sentence_of(const Repair& repair) {
  const std::string count = std::to_string(repair.count) + ' ';
  return repair.text.starts_with(count) ? repair.text.substr(count.size()) : repair.text;
}

}  // namespace plastica::calibrate::report
