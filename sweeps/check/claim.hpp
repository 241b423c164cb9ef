#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/base/status.hpp"
#include "sweeps/check/fit_subject.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/stability/stability.hpp"

namespace plastica::sweeps {

/// What a claim is about.
enum class ClaimSubject : unsigned {
  Sweep = 1,  ///< the cases of a sweep
  Scene = 2,  ///< the one run of a scene
  Fit = 4,    ///< fits: of a fit file that is run, or of a result
  Scan = 8,   ///< points of the study at the extremes
};

/// What of it is claimed; of several groups, cases or fits the one that keeps the limit worst
/// counts.
enum class ClaimKind {
  Order,              ///< observed order of the errors, by least squares [1]
  Correlation,        ///< of that line [1]
  Error,              ///< size of the error; of a fit, that of a parameter from the truth [1]
  ExtrapolatedError,  ///< of the value extrapolated from the three finest [1]
  Gci,                ///< grid convergence index of the finest [1]
  Work,               ///< segment-iterations of a case [1]
  Spread,             ///< largest less least value over the size of their mean [1]
  Value,              ///< the quantity, or the parameter [SI]
  EnergyBalance,      ///< energy balance error of each case [1]
  Failed,             ///< number of cases without a usable status, of fits that are of no use [1]
  Undetected,         ///< of a scan: number of undetected errors [1]
  Invalid,            ///< of a scan: number of points that are not valid, whatever they say [1]
  Status,             ///< how each case ended: one of the words
  Misfit,             ///< rms residual over the largest measured value, of the worst target [1]
  Fitted,             ///< number of fits that are of use [1]
  Interval,           ///< the confidence interval of a parameter, which is to hold a truth [SI]
};

/// What is to be known of a kind of claim.
struct ClaimTraits {
  std::string_view word;      ///< its key
  unsigned subjects = 0;      ///< of `ClaimSubject`, what it may be about
  bool fraction = false;      ///< whether its number is a fraction, shown in percent
  bool not_negative = false;  ///< whether its number is at least 0, whatever happens
};

inline constexpr auto kOfSweeps = static_cast<unsigned>(ClaimSubject::Sweep);
inline constexpr auto kOfScenes = static_cast<unsigned>(ClaimSubject::Scene);
inline constexpr auto kOfFits = static_cast<unsigned>(ClaimSubject::Fit);
inline constexpr auto kOfScans = static_cast<unsigned>(ClaimSubject::Scan);

/// In the order of `ClaimKind`.
inline constexpr std::array<ClaimTraits, 16> kClaimKinds{{
    {"order", kOfSweeps},
    {"correlation", kOfSweeps},
    {"error", kOfSweeps | kOfScenes | kOfFits, true, true},
    {"extrapolated_error", kOfSweeps, true, true},
    {"gci", kOfSweeps, true, true},
    {"work", kOfSweeps | kOfScenes, false, true},
    {"spread", kOfSweeps, true, true},
    {"value", kOfSweeps | kOfScenes | kOfFits},
    {"energy_balance", kOfSweeps | kOfScenes, true, true},
    {"failed", kOfSweeps | kOfScenes | kOfFits, false, true},
    {"undetected", kOfScans, false, true},
    {"invalid", kOfScans, false, true},
    {"status", kOfSweeps | kOfScenes},
    {"misfit", kOfFits, true, true},
    {"fitted", kOfFits, false, true},
    {"interval", kOfFits},
}};

constexpr const ClaimTraits& traits_of(ClaimKind kind) {
  return kClaimKinds[static_cast<std::size_t>(kind)];
}

/// One statement that holds or does not.
struct Claim {
  std::string name;
  SourceLocation where;
  ClaimSubject subject = ClaimSubject::Sweep;
  /// Number in `CheckFile::sweeps`, `scenes` or `fits`, by the subject.
  std::size_t of = 0;
  std::optional<stability::StabilityOptions> scan{};  ///< of a scan
  ClaimKind kind = ClaimKind::Order;
  std::optional<double> at_least{};  ///< [SI]
  std::optional<double> at_most{};   ///< [SI]
  std::vector<Status> statuses{};    ///< Status: those that are allowed
  /// Of a sweep: only cases that have one of these values on this axis, for each entry.
  std::vector<std::pair<std::size_t, std::vector<FieldValue>>> only{};
  /// Of fits: only those of these names; empty: all.
  std::vector<std::string> cases{};
  std::string law{};                      ///< of fits; empty: the one that is advised for all
  std::string parameter{};                ///< of fits: its path
  Dimension dimension = Dimension::None;  ///< of that
  double truth = 0.0;                     ///< of that, for Error and Interval [SI]
};

/// A file of claims, and what they are about, each sweep and fit once.
struct CheckFile {
  std::string path;
  std::vector<Sweep> sweeps{};
  /// Of claims on a scene, one each: sweeps without axes, whose one case is the scene.
  std::vector<Sweep> scenes{};
  std::vector<FitSubject> fits{};
  std::vector<Claim> claims{};
  std::vector<std::string> notes{};  ///< old names in it and its files, each with the new one
  std::string text{};
};

/// The texts that a check file's verdicts depend on: its own, then those of its sweeps, scenes and
/// fit files, each once. @throws InputError if a table of a fit file cannot be read
std::vector<io::InputText> input_texts(const CheckFile& file);

/// Reads a check file; see docs/file-formats.md for the keys.
/// @param before_result  called with the path of each result file before it is read; may be empty
/// @throws InputError for the first thing that is wrong, in it or in a file that it names
CheckFile read_check_file(const std::string& path,
                          const std::function<void(const std::string&)>& before_result = {});

/// What a claim and its limits are about: "sweep".
std::string_view word_of(ClaimSubject subject);

}  // namespace plastica::sweeps
