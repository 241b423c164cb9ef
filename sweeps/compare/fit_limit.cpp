#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/extrapolation.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kLowOrder = 0.3;
constexpr double kHighOrder = theory::kHighestOrder + theory::kBeyondHighestOrder;
constexpr double kSafety = 1.25;

using Matrix = std::vector<std::vector<double>>;

/// Least squares of rows*x = right by Householder's reflections, which keep the digits that normal
/// equations lose. Fills in the triangle R.
std::optional<std::vector<double>> solve(Matrix rows, std::vector<double> right, Matrix& triangle) {
  const std::size_t n = rows.size();
  const std::size_t m = rows.front().size();
  for (std::size_t c = 0; c < m; ++c) {
    double norm = 0.0;
    for (std::size_t r = c; r < n; ++r) norm = std::hypot(norm, rows[r][c]);
    if (!(norm > 0.0)) return std::nullopt;
    const double alpha = rows[c][c] > 0.0 ? -norm : norm;
    std::vector<double> v(n, 0.0);
    for (std::size_t r = c; r < n; ++r) v[r] = rows[r][c];
    v[c] -= alpha;
    double vv = 0.0;
    for (std::size_t r = c; r < n; ++r) vv += v[r] * v[r];
    const auto reflect = [&](const auto& get) {
      double dot = 0.0;
      for (std::size_t r = c; r < n; ++r) dot += v[r] * get(r);
      for (std::size_t r = c; r < n; ++r) get(r) -= 2.0 * dot / vv * v[r];
    };
    for (std::size_t k = c; k < m; ++k) {
      reflect([&](std::size_t r) -> double& { return rows[r][k]; });
    }
    reflect([&](std::size_t r) -> double& { return right[r]; });
  }
  std::vector<double> x(m);
  triangle.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(m));
  for (std::size_t c = m; c-- > 0;) {
    if (std::abs(triangle[c][c]) < 1e-13 * std::abs(triangle[0][0])) return std::nullopt;
    double sum = right[c];
    for (std::size_t k = c + 1; k < m; ++k) sum -= triangle[c][k] * x[k];
    x[c] = sum / triangle[c][c];
  }
  return x;
}

/// The values of a fit, with sizes over the finest of each axis.
struct FitData {
  std::size_t axes = 0;
  std::vector<double> ratio{};  ///< h/H (n x n_axes)
  std::vector<double> value{};
  std::vector<double> weight{};

  double at(std::size_t i, std::size_t k) const { return ratio[i * axes + k]; }
};

FitData data_of(std::span<const double> sizes, std::size_t axes, std::span<const double> values) {
  FitData data{axes, {sizes.begin(), sizes.end()}, {values.begin(), values.end()}, {}};
  for (std::size_t k = 0; k < axes; ++k) {
    double finest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < values.size(); ++i) finest = std::min(finest, data.at(i, k));
    for (std::size_t i = 0; i < values.size(); ++i) data.ratio[i * axes + k] /= finest;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < axes; ++k) sum += data.at(i, k);
    data.weight.push_back(static_cast<double>(axes) / sum);
  }
  return data;
}

struct Linear {
  std::vector<double> x{};                                    ///< f_0, then a_k
  double residual = std::numeric_limits<double>::infinity();  ///< sum of weighted squares
};

Linear linear_fit(const FitData& data, const std::vector<double>& order) {
  Matrix rows(data.value.size(), std::vector<double>(data.axes + 1));
  std::vector<double> right(data.value.size());
  // About the first value, so that no digit of the differences is lost.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i][0] = data.weight[i];
    for (std::size_t k = 0; k < data.axes; ++k) {
      rows[i][k + 1] = data.weight[i] * std::pow(data.at(i, k), order[k]);
    }
    right[i] = data.weight[i] * (data.value[i] - data.value[0]);
  }
  Matrix triangle;
  const auto x = solve(rows, right, triangle);
  if (!x) return {};
  Linear out{*x, 0.0};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double off = -right[i];
    for (std::size_t c = 0; c < x->size(); ++c) off += rows[i][c] * (*x)[c];
    out.residual += off * off;
  }
  out.x[0] += data.value[0];
  return out;
}

/// The orders of the least residual, by steps along each that shrink.
std::vector<double> best_orders(const FitData& data) {
  std::vector<double> best(data.axes, 1.5);
  double least = linear_fit(data, best).residual;
  for (double step = 1.0; step > 1e-11;) {
    bool moved = false;
    for (std::size_t k = 0; k < data.axes; ++k) {
      for (const double by : {step, -step}) {
        std::vector<double> tried = best;
        tried[k] = std::clamp(tried[k] + by, kLowOrder, kHighOrder);
        const double residual = linear_fit(data, tried).residual;
        if (!(residual < least)) continue;
        best = std::move(tried);
        least = residual;
        moved = true;
      }
    }
    if (!moved) step *= 0.5;
  }
  return best;
}

/// Standard error of f_0: residual variance times the first diagonal entry of (J^T J)^-1, with the
/// derivatives by the orders in J.
double error_of_limit(const FitData& data, const std::vector<double>& order, const Linear& fit) {
  const std::size_t numbers = 1 + 2 * data.axes;
  Matrix rows(data.value.size(), std::vector<double>(numbers));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i][numbers - 1] = data.weight[i];  // f_0 last: its entry is that of R alone
    for (std::size_t k = 0; k < data.axes; ++k) {
      const double power = std::pow(data.at(i, k), order[k]);
      rows[i][2 * k] = data.weight[i] * power;
      rows[i][2 * k + 1] = data.weight[i] * fit.x[k + 1] * power * std::log(data.at(i, k));
    }
  }
  Matrix triangle;
  const auto freedom = static_cast<double>(data.value.size() - numbers);
  if (!solve(rows, std::vector<double>(rows.size(), 0.0), triangle)) return std::nan("");
  return std::sqrt(fit.residual / freedom) / std::abs(triangle[numbers - 1][numbers - 1]);
}

/// f_0 with a term of order 1 and one of order 2 along each axis: linear, so that nothing is
/// searched, and right where errors of both orders cancel. None where the values do not tell.
std::optional<double> limit_of_both_orders(const FitData& data) {
  FitData doubled{2 * data.axes, {}, data.value, data.weight};
  std::vector<double> order;
  for (std::size_t k = 0; k < data.axes; ++k)
    order.insert(order.end(), {1.0, theory::kHighestOrder});
  for (std::size_t i = 0; i < data.value.size(); ++i) {
    for (std::size_t k = 0; k < data.axes; ++k)
      doubled.ratio.insert(doubled.ratio.end(), 2, data.at(i, k));
  }
  const Linear fit = linear_fit(doubled, order);
  if (fit.x.empty()) return std::nullopt;
  return fit.x[0];
}

std::optional<Limit> fit_all(std::span<const double> sizes, std::size_t axes,
                             std::span<const double> values) {
  if (values.size() <= 1 + 2 * axes) return std::nullopt;
  const FitData data = data_of(sizes, axes, values);
  const std::vector<double> order = best_orders(data);
  for (const double p : order) {
    if (p <= kLowOrder || p >= kHighOrder) return std::nullopt;
  }
  const Linear fit = linear_fit(data, order);
  if (fit.x.empty()) return std::nullopt;
  const double error = error_of_limit(data, order, fit);
  if (!std::isfinite(error)) return std::nullopt;
  Limit limit{fit.x[0], 3.0 * error, {fit.x.begin() + 1, fit.x.end()}, order};
  if (const auto other = limit_of_both_orders(data)) {
    limit.uncertainty = std::max(limit.uncertainty, kSafety * std::abs(*other - limit.value));
  }
  return limit;
}

/// The values whose sizes are among the finest of each axis.
std::pair<std::vector<double>, std::vector<double>> without_coarsest(
    std::span<const double> sizes, std::size_t axes, std::span<const double> values) {
  std::vector<double> coarsest(axes, 0.0);
  for (std::size_t j = 0; j < sizes.size(); ++j) {
    coarsest[j % axes] = std::max(coarsest[j % axes], sizes[j]);
  }
  std::pair<std::vector<double>, std::vector<double>> kept;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto row = sizes.subspan(i * axes, axes);
    bool fine = true;
    for (std::size_t k = 0; k < axes; ++k) fine = fine && !same_size(row[k], coarsest[k]);
    if (!fine) continue;
    kept.first.insert(kept.first.end(), row.begin(), row.end());
    kept.second.push_back(values[i]);
  }
  return kept;
}

/// Whether values that differ in an axis alone are one, but for rounding.
bool moves_nothing(std::span<const double> sizes, std::size_t axes, std::size_t axis,
                   std::span<const double> values) {
  constexpr double kRounding = 1e-13;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      bool alone = true;
      for (std::size_t k = 0; k < axes; ++k) {
        alone = alone && (k == axis || same_size(sizes[i * axes + k], sizes[j * axes + k]));
      }
      const double room = kRounding * std::max(std::abs(values[i]), std::abs(values[j]));
      if (alone && std::abs(values[i] - values[j]) > room) return false;
    }
  }
  return true;
}

std::optional<Limit> fit_finest(std::span<const double> sizes, std::size_t axes,
                                std::span<const double> values) {
  auto all = fit_all(sizes, axes, values);
  const auto [fine_sizes, fine_values] = without_coarsest(sizes, axes, values);
  auto fine = fit_all(fine_sizes, axes, fine_values);
  if (!fine) return all;
  if (all) fine->uncertainty = std::max(fine->uncertainty, std::abs(fine->value - all->value));
  return fine;
}

}  // namespace

std::optional<Limit> fit_limit(std::span<const double> sizes, std::size_t axes,
                               std::span<const double> values) {
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < axes; ++k) {
    if (!moves_nothing(sizes, axes, k, values)) moving.push_back(k);
  }
  if (moving.empty() && !values.empty()) {
    return Limit{values.front(), 0.0, std::vector<double>(axes), std::vector<double>(axes)};
  }
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const std::size_t k : moving) kept.push_back(sizes[i * axes + k]);
  }
  auto limit = fit_finest(kept, moving.size(), values);
  if (!limit) return std::nullopt;
  Limit out{limit->value, limit->uncertainty, std::vector<double>(axes), std::vector<double>(axes)};
  for (std::size_t m = 0; m < moving.size(); ++m) {
    out.constant[moving[m]] = limit->constant[m];
    out.order[moving[m]] = limit->order[m];
  }
  return out;
}

}  // namespace plastica::sweeps
