#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// A parameter with all that its target decides: start, bounds, scale.
struct ResolvedParameter {
  const Field* field = nullptr;
  ParameterRole role = ParameterRole::Free;
  double start = 0.0;  ///< Free: start; Fixed: the value [SI]
  double lower = 0.0;
  double upper = 0.0;
  bool logarithmic = false;
  /// Whether it enters the break term only. Such a one is left out of the model.
  bool is_break = false;
  /// Free, but the target has nothing that could determine it: it stays at its start.
  bool idle = false;
  std::size_t base = 0;  ///< Tied: index of the parameter it follows
  double factor = 1.0;
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
  /// Indices into `all()` of the parameters that the optimizer moves (n_active).
  std::span<const std::size_t> active() const { return active_; }

  double lower(std::size_t active_index) const;
  double upper(std::size_t active_index) const;
  double coordinate(std::size_t active_index, double value) const;
  double value(std::size_t active_index, double coordinate) const;
  /// d value / d coordinate.
  double slope(std::size_t active_index, double value) const;

  /// Values of all parameters [SI] (n_all) from those of the active ones (n_active).
  void expand(std::span<const double> active_values, std::span<double> all_values) const;
  /// Chain rule: sums derivatives by all parameters (n_all) into those by the active (n_active).
  void contract(std::span<const double> by_all, std::span<double> by_active) const;

 private:
  const ResolvedParameter& active_parameter(std::size_t i) const { return all_[active_[i]]; }

  std::vector<ResolvedParameter> all_;
  std::vector<std::size_t> active_;
  std::vector<double> size_;            ///< typical size of each active parameter, linear scale
  std::vector<std::size_t> active_of_;  ///< index into `active_` of each, or npos
};

}  // namespace plastica::calibrate
