#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/law/section_response.hpp"
#include "plastica/model/section.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica::law::testing {

/// Exact utilisation at first yield: von Mises over 200 points of half of each side, for
/// forces over their caps that are >= 0.
class FirstYield {
 public:
  explicit FirstYield(const Section& s) : round_(s.shape == SectionShape::Circle) {
    if (round_) return;
    const double ratio = std::max(s.width, s.height) / std::min(s.width, s.height);
    for (int i = 0; i <= kPoints; ++i) {
      const double p = static_cast<double>(i) / kPoints;
      along_x_.push_back(saint_venant_perimeter_stress(ratio, s.width >= s.height, p));
      along_y_.push_back(saint_venant_perimeter_stress(ratio, s.width < s.height, p));
    }
  }
  double operator()(const SectionForce<double>& z) const {
    if (round_) return std::hypot(std::hypot(z[0], z[1]) + z[3], z[2]);
    double largest = 0.0;
    for (std::size_t i = 0; i <= kPoints; ++i) {
      const double p = static_cast<double>(i) / kPoints;
      largest = std::max(largest, std::hypot(z[3] + z[0] + p * z[1], along_x_[i] * z[2]));
      largest = std::max(largest, std::hypot(z[3] + z[1] + p * z[0], along_y_[i] * z[2]));
    }
    return largest;
  }

 private:
  static constexpr int kPoints = 200;
  bool round_;
  std::vector<double> along_x_, along_y_;  ///< shear stress on the sides along x and y
};

}  // namespace plastica::law::testing
