#include "plastica/law/shear_levers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plastica::law {
namespace {

/// Levers c g^m, none above the largest, whose squares times areas sum up to J.
class Levers {
 public:
  Levers(const std::vector<double>& area, const std::vector<double>& shear,
         const TorsionTargets& targets)
      : area_(area), targets_(targets), largest_(targets.constant / targets.modulus) {
    for (const double g : shear) logarithm_.push_back(std::log(g / largest_));
    lever_.resize(area.size());
  }

  /// @return sum A lever
  double set(double exponent) {
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      lever_[i] = std::exp(exponent * logarithm_[i]);  // over the largest
    }
    const double square = targets_.constant / (largest_ * largest_);
    double scale = scale_for(square, std::vector<bool>(lever_.size(), false));
    // Each round cuts off more, and so raises the others.
    for (std::size_t cut = 0;;) {
      std::vector<bool> full(lever_.size());
      for (std::size_t i = 0; i < lever_.size(); ++i) full[i] = scale * lever_[i] >= 1.0;
      const auto now = static_cast<std::size_t>(std::count(full.begin(), full.end(), true));
      if (now == cut || now == lever_.size()) break;
      cut = now;
      scale = scale_for(square, full);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      lever_[i] = largest_ * std::min(scale * lever_[i], 1.0);
      sum += area_[i] * lever_[i];
    }
    return sum;
  }

  const std::vector<double>& levers() const { return lever_; }

 private:
  double scale_for(double square, const std::vector<bool>& full) const {
    double rest = 0.0;
    for (std::size_t i = 0; i < lever_.size(); ++i) {
      if (full[i]) {
        square -= area_[i];
      } else {
        rest += area_[i] * lever_[i] * lever_[i];
      }
    }
    return std::sqrt(std::max(square, 0.0) / rest);
  }

  const std::vector<double>& area_;
  const TorsionTargets& targets_;
  double largest_;
  std::vector<double> logarithm_;
  std::vector<double> lever_;
};

}  // namespace

std::vector<double> shear_levers(const std::vector<double>& area, const std::vector<double>& shear,
                                 const TorsionTargets& targets) {
  Levers levers(area, shear, targets);
  // The more uneven the levers, the less they sum up to at the same sum of squares.
  double low = 0.0;
  double high = 64.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (levers.set(middle) > targets.plastic_modulus ? low : high) = middle;
  }
  levers.set(0.5 * (low + high));
  return levers.levers();
}

}  // namespace plastica::law
