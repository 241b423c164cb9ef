#include "sweeps/advise/next_setting.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::sweeps {
namespace {

constexpr double kFinestFactor = 0.125;
constexpr double kCoarsestFactor = 2.0;
constexpr double kNegligible = 1e-3;
constexpr double kLeastOrder = 0.5;

}  // namespace

double left_of(double change, double ratio, double order) {
  return change / (1.0 - std::pow(ratio, -order));
}

double seen_order(double coarse_size, double coarse_change, double fine_size, double fine_change,
                  double highest) {
  const double order = std::log(coarse_change / fine_change) / std::log(coarse_size / fine_size);
  return std::clamp(order, kLeastOrder, highest);
}

Setting next_setting(const std::vector<FinenessAxis>& axes, const Setting& setting,
                     const std::vector<AxisError>& errors, double wanted) {
  const auto has_share = [&](const AxisError& e) {
    return std::isfinite(e.change) && e.error > kNegligible * wanted;
  };
  double inverse_orders = 0.0;
  for (const AxisError& e : errors) {
    if (has_share(e)) inverse_orders += 1.0 / e.order;
  }
  Setting next = setting;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const AxisError& e = errors[k];
    double factor = kCoarsestFactor;
    if (!std::isfinite(e.change)) {
      factor = 0.5;
    } else if (has_share(e)) {
      const double share = wanted / e.order / inverse_orders;
      factor = std::clamp(std::pow(share / e.error, 1.0 / e.order), kFinestFactor, kCoarsestFactor);
    }
    next[k] = axes[k].scaled(setting[k], factor);
  }
  return next;
}

}  // namespace plastica::sweeps
