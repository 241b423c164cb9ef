#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// A target's misfit as a search sees it: over the largest stress squared, in the coordinates of
/// the parameter set, each evaluation traced. A free break limit is not searched but follows the
/// other parameters, see misfit.hpp.
class TracedMisfit {
 public:
  /// All must outlive this.
  TracedMisfit(Misfit& misfit, const ParameterSet& parameters, Trace& trace);
  TracedMisfit(const TracedMisfit&) = delete;
  TracedMisfit& operator=(const TracedMisfit&) = delete;

  /// From the set's start, with cost and squares (n coordinates). Must not outlive this.
  const Problem& problem() const { return problem_; }
  std::size_t size() const { return searched_.size(); }  ///< n
  /// The parameter that a coordinate moves: index into the set's `all()`.
  std::size_t parameter(std::size_t coordinate) const {
    return parameters_.active()[searched_[coordinate]];
  }

  /// Of a value of its parameter [SI].
  double coordinate(std::size_t coordinate, double value) const {
    return parameters_.coordinate(searched_[coordinate], value);
  }

  /// As `Problem::cost`.
  double cost(std::span<const double> x, std::span<double> gradient);
  /// As `Problem::squares`.
  double squares(std::span<const double> x, std::span<double> gradient, std::span<double> normal);
  double unit() const { return misfit_.cost_unit(); }  ///< of these costs [Pa^2]
  /// Values of the active parameters at the last evaluation [SI] (n_active).
  const std::vector<double>& values() const { return values_; }

 private:
  void set_values(std::span<const double> x);
  /// d value / d coordinate at the values that are set.
  double slope(std::size_t coordinate) const;
  double traced(double cost);

  Misfit& misfit_;
  const ParameterSet& parameters_;
  Trace& trace_;
  Problem problem_;
  std::vector<std::size_t> searched_;  ///< active index of each coordinate
  std::optional<std::size_t> break_;   ///< active index of a free break limit
  std::vector<double> values_;
  std::vector<double> by_active_, normal_by_active_;
};

}  // namespace plastica::calibrate
