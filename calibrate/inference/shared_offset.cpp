#include "calibrate/inference/shared_offset.hpp"

#include <Eigen/QR>
#include <cmath>

#include "calibrate/inference/small_matrices.hpp"

namespace plastica::calibrate {

SharedOffset shared_offset(std::span<const double> slopes, std::span<const double> residual,
                           std::span<const double> weights) {
  using Eigen::Index;
  using Eigen::VectorXd;
  SharedOffset found;
  const auto n = static_cast<Index>(residual.size());
  if (n == 0) return found;
  const auto parameters = static_cast<Index>(slopes.size()) / n;
  VectorXd u = VectorXd::Ones(n);
  if (!weights.empty()) u = Eigen::Map<const VectorXd>(weights.data(), n).cwiseSqrt();
  VectorXd r = Eigen::Map<const VectorXd>(residual.data(), n);
  if (parameters > 0) {
    const SlopeRows j(slopes.data(), n, parameters);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(j);
    u -= j * qr.solve(u).eval();
    r -= j * qr.solve(r).eval();
  }
  constexpr double kNothing = 1e-6;  // of the ones: the parameters make up for a constant
  const double squares = u.squaredNorm();
  const double left = r.squaredNorm();
  if (!(squares > kNothing * static_cast<double>(n)) || !(left > 0.0)) return found;
  const double product = u.dot(r);
  found.value = -product / squares;
  found.of_squares = product * product / (squares * left);
  const double degrees = static_cast<double>(n - parameters) - 1.0;
  if (degrees > 0.0) {
    found.errors = std::sqrt(degrees * found.of_squares / (1.0 - found.of_squares));
  }
  return found;
}

}  // namespace plastica::calibrate
