#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/stability/stability.hpp"

namespace plastica::sweeps {

/// What a claim is about; of several groups or cases the one that keeps the limit worst counts.
enum class ClaimKind {
  Order,              ///< observed order of the errors, by least squares [1]
  Correlation,        ///< of that line [1]
  Error,              ///< size of the error [1]
  ExtrapolatedError,  ///< of the value extrapolated from the three finest [1]
  Gci,                ///< grid convergence index of the finest [1]
  Work,               ///< segment-iterations of a case [1]
  Spread,             ///< largest less least value over the size of their mean [1]
  Value,              ///< the quantity [SI]
  EnergyBalance,      ///< energy balance error of each case [1]
  Failed,             ///< number of cases without a usable status [1]
  Undetected,         ///< of a scan: number of undetected errors [1]
  Invalid,            ///< of a scan: number of points that are not valid, whatever they say [1]
};

inline constexpr std::array<std::string_view, 12> kClaimKinds{
    "order", "correlation",    "error",  "extrapolated_error", "gci",    "work", "spread",
    "value", "energy_balance", "failed", "undetected",         "invalid"};

/// One statement about a sweep, or about scans to the edge of stability, that holds or does not.
struct Claim {
  std::string name;
  SourceLocation where;
  std::size_t sweep = 0;  ///< number in `CheckFile::sweeps`, unless it is about a scan:
  std::optional<stability::StabilityOptions> scan{};
  ClaimKind kind = ClaimKind::Order;
  std::optional<double> at_least{};  ///< [SI]
  std::optional<double> at_most{};   ///< [SI]
  /// Only cases that have one of these values on this axis, for each entry.
  std::vector<std::pair<std::size_t, std::vector<FieldValue>>> only{};
};

/// A file of claims, and the sweeps that they are about, each once.
struct CheckFile {
  std::string path;
  std::vector<Sweep> sweeps;
  std::vector<Claim> claims;
  std::vector<std::string> notes{};  ///< old names in it and its sweeps, each with the new one
};

/// Reads a check file; see docs/file-formats.md for the keys.
/// @throws InputError for the first thing that is wrong, in it or in a sweep that it names
CheckFile read_check_file(const std::string& path);

}  // namespace plastica::sweeps
