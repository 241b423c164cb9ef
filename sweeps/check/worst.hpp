#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sweeps/check/verdict.hpp"

namespace plastica::sweeps {

/// Gathers the numbers of a claim and keeps the one that is worst against its limits. A number that
/// is missing or not finite is worse than any.
class Worst {
 public:
  /// @param claim  must outlive this
  explicit Worst(const Claim& claim) : claim_(claim) {}

  /// @param whose      of a case, group or fit, counted as the caller likes
  /// @param otherwise  why there is no number, where there is none
  void add(const std::optional<double>& number, std::size_t whose, const std::string& otherwise);

  /// Whose number, or whose lack of one, decides; none if nothing was added.
  std::optional<std::size_t> whose() const { return whose_; }
  /// Whether a number was missing.
  bool lacks_one() const { return !reason_.empty(); }
  /// Number, reason, whether the claim holds, and the worst of all numbers.
  /// @param name  of whose; empty: they have no names
  ClaimVerdict verdict(const std::function<std::string(std::size_t whose)>& name = {}) const;

 private:
  struct Entry {
    std::optional<double> number;
    std::size_t whose = 0;
    std::string reason;
    double badness = 0.0;
  };

  /// Keeps it among the worst, if it is one of them.
  void keep(const std::optional<double>& number, std::size_t whose, const std::string& otherwise);
  /// How far a number is outside of the limits; inside of them at most 0.
  double badness(double number) const;

  const Claim& claim_;
  std::optional<double> number_;
  std::optional<std::size_t> whose_;
  std::string reason_;
  std::vector<Entry> worst_;  ///< the worst first, of the same the first (at most kMostJudged)
  std::size_t added_ = 0;
};

}  // namespace plastica::sweeps
