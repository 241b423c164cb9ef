#pragma once

#include <Eigen/Core>
#include <span>

namespace plastica::calibrate {

/// Numbers as a vector of Eigen's.
inline Eigen::VectorXd vector_of(std::span<const double> v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

}  // namespace plastica::calibrate
