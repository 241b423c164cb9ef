#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/run/batch.hpp"

namespace plastica::sweeps {

/// A probe that advice looks at.
struct WatchedProbe {
  std::size_t probe = 0;  ///< its number in the scene
  std::string name{};
  /// Values that never get beyond this are rounding, and are not compared [SI of the probe].
  double least = 0.0;
};

/// A number that a run gives once: "time of the first break", "limit load", "buckling factor 1".
struct OneNumber {
  std::string name{};
  double value = 0.0;  ///< [SI]
};

/// What a run of a setting came to.
struct Outcome {
  Status status = Status::NotRun;
  std::string reason{};                        ///< why it cannot be used
  std::vector<double> time{};                  ///< of the samples [s] (n_samples)
  std::vector<std::vector<double>> history{};  ///< of each watched probe (n_watched x n_samples)
  std::vector<double> bent{};  ///< largest rotation of each joint in any frame [rad] (n_joints)
  std::optional<double> break_place{};  ///< of the first break, of the beam's length [1]
  std::vector<OneNumber> numbers{};     ///< what else the run found
  std::int64_t segments = 0;
  std::int64_t work = 0;                ///< segment-iterations; of a run without any its segments
  double seconds = 0.0;                 ///< CPU time [s]
  std::vector<std::string> warnings{};  ///< of a usable run, see `run_warnings`
};

Outcome outcome_of(const BatchRow& row, const std::vector<WatchedProbe>& watched);

/// How far one quantity is off.
struct SignedDeviation {
  std::string quantity{};  ///< "tip: history"
  /// [1]; NaN: not compared, or a history most of whose difference is not along the finer one.
  double value = 0.0;
};

/// How far a run is off a finer one.
struct Deviation {
  /// The largest of all quantities [1], >= 0; infinite where the two cannot be compared.
  double largest = 0.0;
  std::string quantity{};  ///< whose it is: "tip: history"
  std::string reason{};    ///< why the two cannot be compared
  int quantities = 0;      ///< that were compared: 0 where all stays within rounding
  /// In one order for all runs of a scene that end alike: three of each watched probe, then the
  /// numbers.
  std::vector<SignedDeviation> parts{};
};

/// Whether two runs come to the same kind of end: one status, the same numbers, and breaks alike.
bool end_alike(const Outcome& coarse, const Outcome& fine);

/// Compares two runs of one scene, at the times of which both have a sample. Of each watched probe,
/// over the largest size that the finer run has of it: the largest size and the last value; and the
/// history, the root mean square of its difference over that of the finer one. Of the time of the
/// first break, a limit load, buckling factors and frequencies the difference over the finer run's.
/// Two that do not break alike (`break_alike`) cannot be compared.
/// @param than  what the finer one is, for the reason
Deviation deviation(const Outcome& coarse, const Outcome& fine,
                    const std::vector<WatchedProbe>& watched, std::string_view than = "finer");

/// How far the coarsest of three runs is off its limit if what one axis does is a h + b h^2: the
/// worst quantity by `theory::limit_of_two_orders`. Two runs may agree where both terms cancel.
/// @param sizes   h of the three, the finest first
/// @param coarse  of the coarsest from the next one
/// @param fine    of that from the finest
SignedDeviation off_limit_of_two_orders(const std::array<double, 3>& sizes, const Deviation& coarse,
                                        const Deviation& fine);

}  // namespace plastica::sweeps
