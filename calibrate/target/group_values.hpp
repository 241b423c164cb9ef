#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Gives values of groups that are the same number one text, that which came first: "20", "20.0",
/// "020" and "2e1" are one temperature. Groups are told apart by their texts from there on, in
/// reports, stores and the identity of a run.
class GroupValues {
 public:
  /// Of targets in their order, after those that were given before. What is no number stays as it
  /// is, "nan" and "inf" too, and so do more digits than a double tells apart, as in a specimen's
  /// number, and "1,234", which is one of two numbers.
  void unite(std::span<Target> targets);

 private:
  /// Of the name of a column and a number, as it was written first.
  std::map<std::pair<std::string, double>, std::string> first_;
};

}  // namespace plastica::calibrate
