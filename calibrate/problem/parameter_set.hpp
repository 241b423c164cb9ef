#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/coordinate.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// A parameter with all that its target decides: start, bounds, scale.
struct ResolvedParameter {
  const Field* field = nullptr;
  ParameterRole role = ParameterRole::Free;
  double start = 0.0;  ///< Free: start; Fixed: the value [SI]
  double lower = 0.0;
  double upper = 0.0;
  /// The search goes no further up than this. A yield stress above the largest measured stress is
  /// never better than that stress itself, and no sample can tell one from another there: a search
  /// that gets into that range does not come back.
  double search_upper = 0.0;
  bool logarithmic = false;
  /// Whether it is a break limit: it enters the break term at most and is left out of the model.
  bool is_break = false;
  /// Free, but the target has nothing that could determine it: it stays at its start.
  bool idle = false;
  std::size_t base = 0;  ///< Tied: index of the parameter it follows
  double factor = 1.0;
};

/// Which parameter decides when the test's specimen breaks: limit = factor * its value.
struct BreakParameter {
  std::size_t index = 0;  ///< into `ParameterSet::all()`; of a tied one, the one that it follows
  double factor = 1.0;    ///< sqrt(3) where a strain of tension is a torsion's limit; ties
};

/// A fit's parameters for one target, and the map between the optimizer's coordinates and SI.
///
/// A free parameter that is not idle has the coordinate ln(value/start) (logarithmic) or
/// value - start over a typical size (linear).
class ParameterSet {
 public:
  /// @throws InputError if bounds leave no room or a field cannot be fitted by this test
  ParameterSet(const Target& target, const FitOptions& options);

  std::span<const ResolvedParameter> all() const { return all_; }
  std::size_t size() const { return all_.size(); }
  /// Empty if no parameter does. In torsion it is the break shear strain if the scene or the fit
  /// has one, else the break strain; in all else the break strain.
  const std::optional<BreakParameter>& break_parameter() const { return break_parameter_; }
  /// Indices into `all()` of the parameters that the optimizer moves (n_active).
  std::span<const std::size_t> active() const { return active_; }

  /// Coordinates between which an active parameter is searched.
  double lower(std::size_t active_index) const;
  double upper(std::size_t active_index) const;
  double coordinate(std::size_t active_index, double value) const {
    return coordinates_[active_index].at(value);
  }
  double value(std::size_t active_index, double coordinate) const {
    return coordinates_[active_index].value(coordinate);
  }
  /// d value / d coordinate.
  double slope(std::size_t active_index, double value) const {
    return coordinates_[active_index].slope(value);
  }

  /// Values of all parameters [SI] (n_all) from those of the active ones (n_active).
  void expand(std::span<const double> active_values, std::span<double> all_values) const;
  /// Chain rule: sums derivatives by all parameters (n_all) into those by the active (n_active).
  void contract(std::span<const double> by_all, std::span<double> by_active) const;

 private:
  const ResolvedParameter& active_parameter(std::size_t i) const { return all_[active_[i]]; }
  void resolve_ties(const FitOptions& options);
  void find_break_parameter(const Target& target, const FitOptions& options);

  std::vector<ResolvedParameter> all_;
  std::optional<BreakParameter> break_parameter_;
  std::vector<std::size_t> active_;
  std::vector<Coordinate> coordinates_;  ///< of the active ones
  std::vector<std::size_t> active_of_;   ///< index into `active_` of each, or npos
};

}  // namespace plastica::calibrate
