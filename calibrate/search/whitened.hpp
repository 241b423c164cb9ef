#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibrate/search/marquardt_steps.hpp"
#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// Coordinates z in which a sum of squares looks alike in all directions: x = centre + T z with
/// T = (sqrt(2) L^T)^-1 and J^T J = L L^T, so that its second derivatives after Gauss and Newton
/// are the unit matrix that quasi-Newton algorithms begin with. A point beyond the box counts as
/// the nearest one in it. What a bound stops at the centre, or does not matter there, is held.
class Whitened {
 public:
  /// @param problem  its box and cost; must outlive this
  Whitened(const Problem& problem, const std::vector<double>& centre, const SquaresModel& model);

  /// The problem in z, from the centre on: z = 0 (n_moved). Must not outlive this.
  /// @param reach  how far from the centre each z may go [1]
  Problem problem(double reach);
  bool empty() const { return free_.empty(); }
  /// x of a z, within the box (n).
  std::vector<double> point(std::span<const double> z) const;

 private:
  double cost(std::span<const double> z, std::span<double> gradient);

  const Problem& problem_;
  std::vector<double> centre_;
  std::vector<std::size_t> free_;  ///< coordinates that are not held
  Eigen::MatrixXd transform_;      ///< T (n_moved x n_moved)
  std::vector<double> by_x_;       ///< the gradient in x
};

}  // namespace plastica::calibrate
