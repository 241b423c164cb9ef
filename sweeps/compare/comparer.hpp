#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sweeps/compare/closed_forms.hpp"
#include "sweeps/compare/comparison.hpp"

/// Fills in a comparison, case by case; not installed.
namespace plastica::sweeps {

class Comparer {
 public:
  Comparer(const Sweep& sweep, const CaseTable& cases, const std::vector<CaseResult>& results);

  void with_number(std::size_t i, double reference);
  /// @param time, curve  that reach over the case's own times
  void with_curve(std::size_t i, const std::vector<double>& time, const std::vector<double>& curve);
  /// With what the sweep takes of a curve up to the case's last state.
  void with_number_of(std::size_t i, const std::vector<double>& time,
                      const std::vector<double>& curve);
  /// With what another case gave.
  void with_case(std::size_t i, std::size_t reference);
  void with_theory(std::size_t i, const ClosedForm& form);

  const std::vector<CaseResult>& results() const { return results_; }
  Comparison& out() { return out_; }
  Comparison take() { return std::move(out_); }

 private:
  const Sweep& sweep_;
  const CaseTable& cases_;
  const std::vector<CaseResult>& results_;
  Comparison out_;
};

}  // namespace plastica::sweeps
