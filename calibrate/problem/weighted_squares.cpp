#include "calibrate/problem/weighted_squares.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace plastica::calibrate {
namespace {

constexpr std::size_t kChains = 4;

/// Known to the compiler, the gradient of the usual few parameters stays in registers.
template <std::size_t kParameters>
void sum_slopes(std::span<const double> model, std::span<const double> target,
                std::span<const double> weight, const double* row, std::span<double> gradient) {
  std::array<double, kParameters> even{};
  std::array<double, kParameters> odd{};
  const auto add = [&](std::size_t i, std::array<double, kParameters>& to) {
    const double wr = weight[i] * (model[i] - target[i]);
    for (std::size_t k = 0; k < kParameters; ++k) to[k] += wr * row[i * kParameters + k];
  };
  std::size_t i = 0;
  for (; i + 2 <= model.size(); i += 2) {
    add(i, even);
    add(i + 1, odd);
  }
  if (i < model.size()) add(i, even);
  for (std::size_t k = 0; k < kParameters; ++k) gradient[k] = 2.0 * (even[k] + odd[k]);
}

/// Any number of parameters.
void sum_all_slopes(std::span<const double> model, std::span<const double> target,
                    std::span<const double> weight, const double* row, std::span<double> gradient) {
  std::fill(gradient.begin(), gradient.end(), 0.0);
  for (std::size_t i = 0; i < model.size(); ++i) {
    const double wr = weight[i] * (model[i] - target[i]);
    for (double& slope : gradient) slope += 2.0 * wr * *row++;
  }
}

/// Known to the compiler, the sums of the usual few parameters stay in registers.
template <std::size_t kParameters>
void sum_products(std::span<const double> weight, const double* row, std::span<double> normal) {
  std::array<double, kParameters * kParameters> sum{};
  for (std::size_t i = 0; i < weight.size(); ++i, row += kParameters) {
    for (std::size_t a = 0; a < kParameters; ++a) {
      const double wa = weight[i] * row[a];
      for (std::size_t b = 0; b <= a; ++b) sum[a * kParameters + b] += wa * row[b];
    }
  }
  for (std::size_t a = 0; a < kParameters; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      normal[a * kParameters + b] = normal[b * kParameters + a] = sum[a * kParameters + b];
    }
  }
}

/// Any number of parameters.
void sum_all_products(std::span<const double> weight, const double* row, std::size_t parameters,
                      std::span<double> normal) {
  std::fill(normal.begin(), normal.end(), 0.0);
  for (std::size_t i = 0; i < weight.size(); ++i, row += parameters) {
    for (std::size_t a = 0; a < parameters; ++a) {
      const double wa = weight[i] * row[a];
      for (std::size_t b = 0; b < parameters; ++b) normal[a * parameters + b] += wa * row[b];
    }
  }
}

}  // namespace

double weighted_squares(std::span<const double> model, std::span<const double> target,
                        std::span<const double> weight) {
  std::array<double, kChains> sum{};
  std::size_t i = 0;
  for (; i + kChains <= model.size(); i += kChains) {
    for (std::size_t j = 0; j < kChains; ++j) {
      const double r = model[i + j] - target[i + j];
      sum[j] += weight[i + j] * r * r;
    }
  }
  for (; i < model.size(); ++i) {
    const double r = model[i] - target[i];
    sum[0] += weight[i] * r * r;
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void weighted_normal(std::span<const double> weight, std::span<const double> slopes,
                     std::size_t parameters, std::span<double> normal) {
  const double* rows = slopes.data();
  switch (parameters) {
    case 1: sum_products<1>(weight, rows, normal); break;
    case 2: sum_products<2>(weight, rows, normal); break;
    case 3: sum_products<3>(weight, rows, normal); break;
    case 4: sum_products<4>(weight, rows, normal); break;
    default: sum_all_products(weight, rows, parameters, normal); break;
  }
}

double weighted_product(std::span<const double> weight, std::span<const double> a,
                        std::span<const double> b) {
  std::array<double, kChains> sum{};
  std::size_t i = 0;
  for (; i + kChains <= weight.size(); i += kChains) {
    for (std::size_t j = 0; j < kChains; ++j) sum[j] += weight[i + j] * (a[i + j] * b[i + j]);
  }
  for (; i < weight.size(); ++i) sum[0] += weight[i] * (a[i] * b[i]);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

TwiceWeighted twice_weighted_product(std::span<const double> weight, std::span<const double> a,
                                     std::span<const double> b) {
  std::array<double, kChains> once{}, twice{};
  const auto add = [&](std::size_t i, std::size_t chain) {
    const double term = weight[i] * (a[i] * b[i]);
    once[chain] += term;
    twice[chain] += weight[i] * term;
  };
  std::size_t i = 0;
  for (; i + kChains <= weight.size(); i += kChains) {
    for (std::size_t j = 0; j < kChains; ++j) add(i + j, j);
  }
  for (; i < weight.size(); ++i) add(i, 0);
  return {(once[0] + once[1]) + (once[2] + once[3]), (twice[0] + twice[1]) + (twice[2] + twice[3])};
}

double weighted_squares(std::span<const double> model, std::span<const double> target,
                        std::span<const double> weight, std::span<const double> slopes,
                        std::span<double> gradient) {
  const double* rows = slopes.data();
  switch (gradient.size()) {
    case 1: sum_slopes<1>(model, target, weight, rows, gradient); break;
    case 2: sum_slopes<2>(model, target, weight, rows, gradient); break;
    case 3: sum_slopes<3>(model, target, weight, rows, gradient); break;
    case 4: sum_slopes<4>(model, target, weight, rows, gradient); break;
    default: sum_all_slopes(model, target, weight, rows, gradient); break;
  }
  return weighted_squares(model, target, weight);
}

}  // namespace plastica::calibrate
