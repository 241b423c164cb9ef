#pragma once

#include <Eigen/Core>
#include <vector>

/// What the errors of fits are made of: matrices with a row for each parameter. A product of
/// Eigen's takes seconds to compile wherever it stands, so that those that several files need stand
/// here; not installed.
namespace plastica::calibrate {

/// A part of a matrix, without a copy.
using MatrixPart = Eigen::Ref<const Eigen::MatrixXd>;
/// Rows of slopes (m x n) that stand one after the other.
using SlopeRows =
    Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// A B.
Eigen::MatrixXd product(const MatrixPart& a, const MatrixPart& b);
/// J^T J (n x n). @param j  (m x n)
Eigen::MatrixXd gram(const MatrixPart& j);
/// J^T W J (n x n). @param weight  the diagonal of W (m)
Eigen::MatrixXd gram(const MatrixPart& j, const Eigen::VectorXd& weight);
/// S A S. @param size  the diagonal of S (n)
Eigen::MatrixXd scaled(const Eigen::MatrixXd& a, const Eigen::VectorXd& size);
/// B A B.
Eigen::MatrixXd between(const Eigen::MatrixXd& b, const Eigen::MatrixXd& a);
/// M C M^T (k x k), the covariance of what M (k x n) makes of numbers whose covariance is C (n x
/// n).
Eigen::MatrixXd mapped(const Eigen::MatrixXd& map, const Eigen::MatrixXd& covariance);
/// The same of numbers that do not hang together. @param variance  the diagonal of C (n)
Eigen::MatrixXd mapped(const Eigen::MatrixXd& map, const Eigen::VectorXd& variance);
/// A^-1. @param a  symmetric and positive definite
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& a);

/// The shortest x of least |A x - b|.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Eigenvalues, the smallest first, and eigenvectors (a column each) of S A S, whose diagonal is 1.
struct UnitDirections {
  Eigen::VectorXd size;  ///< the diagonal of S: one over the roots of that of A
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;

  explicit UnitDirections(const Eigen::MatrixXd& a);
};

/// As many of the coordinates as there are directions, so that none of these is left once they are
/// held: each time the one that takes the largest part in what is left.
/// @param directions  a column each, of unit length and at right angles
std::vector<Eigen::Index> held_against(Eigen::MatrixXd directions);

/// The rows and columns that are kept.
Eigen::MatrixXd kept_of(const Eigen::MatrixXd& a, const std::vector<Eigen::Index>& kept);
/// Sets these rows and columns of `all`. @param a  of as many as are kept
void set_kept(Eigen::MatrixXd& all, const std::vector<Eigen::Index>& kept,
              const Eigen::MatrixXd& a);

}  // namespace plastica::calibrate
