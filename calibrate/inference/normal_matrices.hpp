#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calibrate/inference/small_matrices.hpp"
#include "calibrate/problem/misfit.hpp"

/// What the errors of a curve's fit are made of (uncertainty.hpp); not installed.
namespace plastica::calibrate {

/// A, with the priors', B = J^T W^2 J and B_p of the slope's prior and of stated ones, of some
/// columns, scaled by `size`.
struct NormalMatrices {
  Eigen::MatrixXd a, b, prior, stated;
  Eigen::VectorXd stated_in_a;  ///< their part of A's diagonal
  /// Whether the curve determines a column by itself, and not only beside one that is held.
  std::vector<bool> is_determined;
  /// The directions that the curve does not show (columns x directions), of the columns that it
  /// shows anything of, before one was held for each; these columns, and their units over `size`.
  Eigen::MatrixXd unseen;
  std::vector<std::size_t> shown;
  std::vector<std::size_t> blank;  ///< columns that the curve shows nothing of
  Eigen::VectorXd unit;

  /// Whether the curve determines a function of the active parameters.
  /// @param gradient  by each of them, SI (n)
  /// @param size  of each (n)
  bool determine(const std::vector<double>& gradient, const std::vector<double>& size) const;

  /// The rows and columns of those that are kept.
  NormalMatrices of(const std::vector<Eigen::Index>& kept) const {
    return {kept_of(a, kept),
            kept_of(b, kept),
            kept_of(prior, kept),
            kept_of(stated, kept),
            stated_in_a(kept),
            {},
            {},
            {},
            {},
            {}};
  }
};

/// Of the columns that the curve shows anything of. For each direction that it does not show one
/// column is held, and dropped: what the curve determines does not depend on which, and its errors
/// count that the others of the direction move.
/// @param size  of the active parameters, SI (n)
/// @param stress  the largest measured one [Pa]
/// @param columns  active indices; those that are kept at the end
NormalMatrices keep_identified(const Misfit::Details& d, const std::vector<double>& size,
                               double stress, std::vector<std::size_t>& columns);

}  // namespace plastica::calibrate
