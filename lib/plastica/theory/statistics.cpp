#include "plastica/theory/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <unsupported/Eigen/SpecialFunctions>

#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

/// From so many degrees of freedom on, and for tails with z^2 below this fraction of them, the
/// expansion about the normal quantile is as good as bisection, and far faster.
constexpr double kManyDegrees = 200.0;
constexpr double kShortTail = 0.11;
/// From so many on Student's t is normal to 1e-5.
constexpr double kNormalDegrees = 1e4;

/// Continued fraction of the incomplete beta function (Abramowitz & Stegun 26.5.8), evaluated from
/// the front by Lentz's method; converges fast for x < (a + 1)/(a + b + 2).
double beta_fraction(double x, double a, double b) {
  constexpr int kMaxTerms = 2000;
  constexpr double kTiny = 1e-300;
  const auto guarded = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double c = 1.0;
  double d = 1.0 / guarded(1.0 - (a + b) * x / (a + 1.0));
  double value = d;
  for (int m = 1; m <= kMaxTerms; ++m) {
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    double change = 1.0;
    for (const double term : {even, odd}) {
      d = 1.0 / guarded(1.0 + term * d);
      c = guarded(1.0 + term / c);
      change = c * d;
      value *= change;
    }
    if (std::abs(change - 1.0) < 4.0 * std::numeric_limits<double>::epsilon()) break;
  }
  return value;
}

/// Regularized incomplete beta function I_x(a, b); `y` is 1 - x without cancellation.
double incomplete_beta(double x, double y, double a, double b) {
  if (x <= 0.0) return 0.0;
  if (y <= 0.0) return 1.0;
  // Thread-safe: all arguments are positive, so lgamma's sign, a global, is of no interest, but
  // glibc writes it all the same; lgamma_r does not.
  int sign = 0;
  const double log_beta = lgamma_r(a, &sign) + lgamma_r(b, &sign) - lgamma_r(a + b, &sign);
  const double front = std::exp(a * std::log(x) + b * std::log(y) - log_beta);
  if (x < (a + 1.0) / (a + b + 2.0)) return front * beta_fraction(x, a, b) / a;
  return 1.0 - front * beta_fraction(y, b, a) / b;
}

/// Probability beyond t >= 0.
double student_t_tail(double t, double nu) {
  const double square = t * t;
  return 0.5 * incomplete_beta(nu / (nu + square), square / (nu + square), nu / 2.0, 0.5);
}

/// t >= 0 with the given probability beyond it. Bisection on log t, which the monotone tail cannot
/// mislead, until the bracket is as narrow as rounding lets it be.
double student_t_tail_quantile(double tail, double nu) {
  double low = 1.0;
  while (student_t_tail(low, nu) < tail) low /= 2.0;
  double high = 2.0 * low;
  while (student_t_tail(high, nu) > tail) {
    low = high;
    high *= 2.0;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (student_t_tail(middle, nu) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Abramowitz & Stegun 26.7.5 up to 1/nu^4.
double expanded_quantile(double z, double nu) {
  const double z2 = z * z;
  const double g1 = (z2 + 1.0) / 4.0;
  const double g2 = ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double g3 = (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  const double g4 = ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / 92160.0;
  return z * (1.0 + (g1 + (g2 + (g3 + g4 / nu) / nu) / nu) / nu);
}

/// A distribution function on even steps, averaged over `reach` steps to both sides; beyond its
/// ends it is 0 and 1.
std::vector<double> averaged(const std::vector<double>& below, double reach) {
  const std::size_t n = below.size();
  std::vector<double> integral(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    integral[i] = integral[i - 1] + 0.5 * (below[i - 1] + below[i]);
  }
  const auto last = static_cast<double>(n - 1);
  const auto at = [&](double x) {
    if (x <= 0.0) return 0.0;
    if (x >= last) return integral.back() + (x - last);
    const auto k = static_cast<std::size_t>(x);
    const double fraction = x - static_cast<double>(k);
    const double slope = below[k] + 0.5 * fraction * (below[k + 1] - below[k]);
    return integral[k] + fraction * slope;
  };
  std::vector<double> mean(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = static_cast<double>(i);
    mean[i] = (at(x + reach) - at(x - reach)) / (2.0 * reach);
  }
  return mean;
}

/// Student's t, normal from kNormalDegrees on.
class StudentT {
 public:
  explicit StudentT(double nu) : nu_(nu), normal_(nu > kNormalDegrees) {
    if (normal_) return;
    int sign = 0;
    log_front_ = lgamma_r(0.5 * (nu + 1.0), &sign) - lgamma_r(0.5 * nu, &sign) -
                 0.5 * std::log(nu * std::numbers::pi);
  }

  /// Probability beyond t.
  double tail(double t) const {
    if (normal_) return normal_cdf(-t);
    const double beyond = student_t_tail(std::abs(t), nu_);
    return t < 0.0 ? 1.0 - beyond : beyond;
  }

  /// The integral of the tail from t on, nu > 1: its slope is -tail, since that of the density f is
  /// -(nu + 1) t f/(nu + t^2).
  double beyond(double t, double tail) const {
    if (normal_) {
      return std::exp(-0.5 * t * t) * std::numbers::inv_sqrtpi / std::numbers::sqrt2 - t * tail;
    }
    const double density = std::exp(log_front_ - 0.5 * (nu_ + 1.0) * std::log1p(t * t / nu_));
    return (nu_ + t * t) / (nu_ - 1.0) * density - t * tail;
  }

 private:
  double nu_;
  bool normal_;
  double log_front_ = 0.0;
};

/// The half interval of one uniform error beside t, nu > 1. The probability of a value beyond q is
/// s (B((q - h)/s) - B((q + h)/s))/2h with B as `beyond`: convex in q, so that Newton's steps come
/// to the root from one side.
/// @param alone  that of t by itself
double half_interval_of_both(double confidence, double scale, const StudentT& student, double half,
                             double alone) {
  // What one of both is beside the other does not matter then: its part is of second order.
  constexpr double kNothing = 1e-7;
  if (alone <= kNothing * half) return confidence * half;
  if (half <= kNothing * alone) return alone;
  const double wanted = 0.5 - 0.5 * confidence;
  double q = std::hypot(alone, confidence * half);
  for (int i = 0; i < 60; ++i) {
    const double near = (q - half) / scale, far = (q + half) / scale;
    const double tail_near = student.tail(near), tail_far = student.tail(far);
    const double beyond =
        scale / (2.0 * half) * (student.beyond(near, tail_near) - student.beyond(far, tail_far));
    const double step = (beyond - wanted) * 2.0 * half / (tail_near - tail_far);
    q += step;
    if (std::abs(step) <= 1e-12 * q) break;
  }
  return q;
}

}  // namespace

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double p) {
  require_domain(p > 0.0 && p < 1.0, "p > 0.0 && p < 1.0");
  if (p == 0.5) return 0.0;
  if (p > 0.5) return -normal_quantile(1.0 - p);
  // Newton on log(cdf) = log(p). The log is concave and rising, and cdf(x) <= exp(-x^2/2)/2 puts
  // the start left of the root, so the steps rise to it and never overshoot.
  double x = -std::sqrt(-2.0 * std::log(2.0 * p));
  for (int i = 0; i < 60; ++i) {
    const double cdf = normal_cdf(x);
    const double density = std::exp(-0.5 * x * x) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
    const double step = std::log(p / cdf) * cdf / density;
    x += step;
    if (std::abs(step) <= 1e-15 * std::abs(x)) break;
  }
  return x;
}

double student_t_cdf(double t, double degrees_of_freedom) {
  require_domain(degrees_of_freedom > 0.0, "degrees_of_freedom > 0.0");
  const double tail = student_t_tail(std::abs(t), degrees_of_freedom);
  return t > 0.0 ? 1.0 - tail : tail;
}

double student_t_quantile(double p, double degrees_of_freedom) {
  require_domain(p > 0.0 && p < 1.0 && degrees_of_freedom > 0.0,
                 "p > 0.0 && p < 1.0 && degrees_of_freedom > 0.0");
  if (p == 0.5) return 0.0;
  const double z = normal_quantile(p);
  if (degrees_of_freedom > kManyDegrees && z * z < kShortTail * degrees_of_freedom) {
    return expanded_quantile(z, degrees_of_freedom);
  }
  const double t = student_t_tail_quantile(std::min(p, 1.0 - p), degrees_of_freedom);
  return p < 0.5 ? -t : t;
}

double chi_squared_cdf(double x, double degrees_of_freedom) {
  require_domain(degrees_of_freedom > 0.0, "degrees_of_freedom > 0.0");
  if (std::isinf(x)) return x > 0.0 ? 1.0 : 0.0;
  return x > 0.0 ? Eigen::numext::igamma(0.5 * degrees_of_freedom, 0.5 * x) : 0.0;
}

double chi_squared_quantile(double p, double degrees_of_freedom) {
  require_domain(p > 0.0 && p < 1.0, "p > 0.0 && p < 1.0");
  double low = degrees_of_freedom;
  while (chi_squared_cdf(low, degrees_of_freedom) > p) low /= 2.0;
  double high = 2.0 * low;
  while (chi_squared_cdf(high, degrees_of_freedom) < p) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_squared_cdf(middle, degrees_of_freedom) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double half_interval(double confidence, double scale, double degrees_of_freedom,
                     std::span<const double> halves) {
  require_domain(confidence > 0.0 && confidence < 1.0 && scale >= 0.0,
                 "confidence > 0.0 && confidence < 1.0 && scale >= 0.0");
  const double alone =
      scale > 0.0 ? scale * student_t_quantile(0.5 + 0.5 * confidence, degrees_of_freedom) : 0.0;
  double sum = 0.0;
  for (const double h : halves) sum += h;
  if (!(sum > 0.0)) return alone;
  // Towards one degree the closed form is a difference of large numbers.
  constexpr double kFewDegrees = 1.1;
  if (halves.size() == 1 && degrees_of_freedom > kFewDegrees) {
    return half_interval_of_both(confidence, scale, StudentT(degrees_of_freedom), sum, alone);
  }
  // q lies below alone + sum; its probability is made of values up to a sum beyond.
  const double end = alone + 2.0 * sum;
  constexpr int kSide = 4000;
  const double step = end / kSide;
  std::vector<double> below(2 * kSide + 1);
  for (int i = -kSide; i <= kSide; ++i) {
    const double x = i * step;
    double& p = below[static_cast<std::size_t>(i + kSide)];
    if (scale > 0.0) {
      const bool normal = degrees_of_freedom > kNormalDegrees;
      p = normal ? normal_cdf(x / scale) : student_t_cdf(x / scale, degrees_of_freedom);
    } else {
      p = i < 0 ? 0.0 : (i > 0 ? 1.0 : 0.5);
    }
  }
  for (const double h : halves) {
    if (h > 0.0) below = averaged(below, h / step);
  }
  const double wanted = 0.5 + 0.5 * confidence;
  const auto above = std::lower_bound(below.begin() + kSide, below.end(), wanted);
  const auto k = std::min(static_cast<int>(above - below.begin()), 2 * kSide);
  const double low = below[static_cast<std::size_t>(k - 1)];
  const double high = below[static_cast<std::size_t>(k)];
  const double fraction = high > low ? (wanted - low) / (high - low) : 0.0;
  return (k - 1 - kSide + fraction) * step;
}

}  // namespace plastica::theory
