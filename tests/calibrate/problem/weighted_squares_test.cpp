#include "calibrate/problem/weighted_squares.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace plastica::calibrate {
namespace {

/// Samples, slopes and the sums that they should give; integers, so that sums are exact.
struct Sums {
  std::vector<double> model, target, weight, slopes, gradient;
  double cost = 0.0;

  Sums(std::size_t samples, std::size_t parameters) : gradient(parameters) {
    for (std::size_t i = 0; i < samples; ++i) {
      model.push_back(static_cast<double>(3 * i % 7));
      target.push_back(static_cast<double>(5 * i % 11));
      weight.push_back(static_cast<double>(1 + i % 3));
      const double r = model[i] - target[i];
      cost += weight[i] * r * r;
      for (std::size_t k = 0; k < parameters; ++k) {
        slopes.push_back(static_cast<double>((i + 2 * k) % 5));
        gradient[k] += 2.0 * weight[i] * r * slopes.back();
      }
    }
  }
};

TEST(WeightedSquares, AreSummedForEveryNumberOfSamplesAndParameters) {
  for (std::size_t samples = 0; samples <= 9; ++samples) {
    for (std::size_t parameters = 1; parameters <= 6; ++parameters) {
      const Sums sums(samples, parameters);
      EXPECT_EQ(weighted_squares(sums.model, sums.target, sums.weight), sums.cost) << samples;
      std::vector<double> gradient(parameters, 1e9);
      EXPECT_EQ(weighted_squares(sums.model, sums.target, sums.weight, sums.slopes, gradient),
                sums.cost);
      EXPECT_EQ(gradient, sums.gradient) << samples << " samples, " << parameters << " parameters";
    }
  }
}

TEST(WeightedProduct, IsSummedForEveryNumberOfSamples) {
  for (std::size_t samples = 0; samples <= 9; ++samples) {
    const Sums sums(samples, 1);
    double expected = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
      expected += sums.weight[i] * sums.model[i] * sums.target[i];
    }
    EXPECT_EQ(weighted_product(sums.weight, sums.model, sums.target), expected) << samples;
  }
}

}  // namespace
}  // namespace plastica::calibrate
