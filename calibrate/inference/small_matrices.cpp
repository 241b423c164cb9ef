#include "calibrate/inference/small_matrices.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plastica::calibrate {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd product(const MatrixPart& a, const MatrixPart& b) { return a * b; }

MatrixXd gram(const MatrixPart& j) { return j.transpose() * j; }

MatrixXd gram(const MatrixPart& j, const VectorXd& weight) {
  return j.transpose() * weight.asDiagonal() * j;
}

MatrixXd scaled(const MatrixXd& a, const VectorXd& size) {
  return size.asDiagonal() * a * size.asDiagonal();
}

MatrixXd between(const MatrixXd& b, const MatrixXd& a) { return b * a * b; }

MatrixXd mapped(const MatrixXd& map, const MatrixXd& covariance) {
  return map * covariance * map.transpose();
}

MatrixXd mapped(const MatrixXd& map, const VectorXd& variance) {
  return map * variance.asDiagonal() * map.transpose();
}

MatrixXd inverse_of(const MatrixXd& a) {
  return a.ldlt().solve(MatrixXd::Identity(a.rows(), a.cols()));
}

VectorXd shortest_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

UnitDirections::UnitDirections(const MatrixXd& a) : size(a.diagonal().cwiseSqrt().cwiseInverse()) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled(a, size));
  values = solver.eigenvalues();
  vectors = solver.eigenvectors();
}

std::vector<Index> held_against(MatrixXd directions) {
  std::vector<Index> held;
  for (Index k = 0; k < directions.cols(); ++k) {
    Index most = 0;
    directions.rowwise().squaredNorm().maxCoeff(&most);
    held.push_back(most);
    const VectorXd row = directions.row(most).transpose().normalized();
    directions -= directions * row * row.transpose();
  }
  return held;
}

MatrixXd kept_of(const MatrixXd& a, const std::vector<Index>& kept) { return a(kept, kept); }

void set_kept(MatrixXd& all, const std::vector<Index>& kept, const MatrixXd& a) {
  all(kept, kept) = a;
}

}  // namespace plastica::calibrate
