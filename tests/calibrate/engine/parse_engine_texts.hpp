#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace plastica::testing {

/// What a format says of a joint; empty where it does not say it.
struct ParsedJoint {
  double length = 0.0;
  bool half_joint = false;
  std::array<double, 3> stiffness{};
  std::array<double, 3> hardened_stiffness{};
  std::array<double, 3> yield_moment{};
  std::array<double, 3> break_angle{};
  std::array<double, 3> damping{};  ///< Chrono alone
  std::array<double, 3> point{};
  std::array<bool, 3> holds{};
};

struct ParsedSegment {
  double length = 0.0;
  double mass = 0.0;
  std::array<double, 3> inertia{};
  std::array<double, 3> center{};  ///< world axes; MJCF: from the segment's start
};

/// A beam as read back from a text.
struct ParsedBeam {
  std::map<std::string, ParsedJoint> joints;
  std::vector<ParsedSegment> segments;
};

ParsedBeam parse_csv(const std::string& text);
ParsedBeam parse_mjcf(const std::string& text);
/// AGX and Chrono: the rows of their tables.
ParsedBeam parse_agx(const std::string& text);
ParsedBeam parse_chrono(const std::string& text);
/// Yield moments as epsyP times stiffness, permanent break angles out of MinMax.
ParsedBeam parse_opensees(const std::string& text);

}  // namespace plastica::testing
