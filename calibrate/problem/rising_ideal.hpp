#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The misfit of the usual case in closed form; not installed.
namespace plastica::calibrate {

/// The sum of squares of an ideal-plastic coupon whose strain only rises, without following it.
///
/// From rest along strains e_i that never fall, its stress is min(K e_i, Y), as long as the first
/// strain is not below -Y/K. With k the first sample where K e_i > Y,
///   sum w_i r_i^2 = sum_{i<k} w_i (K e_i - s_i)^2 + sum_{i>=k} w_i (Y - s_i)^2
///                 = R_k + A_k (K - K_k)^2 + M_k + W_k (Y - Y_k)^2,
/// where K_k is the slope through the origin that fits the samples before k best, R_k what it
/// leaves and A_k = sum w_i e_i^2; Y_k is the mean of the stresses from k on, M_k what it leaves
/// and W_k the sum of their weights. All are found once, by recursions whose terms are not
/// negative, so that nothing cancels (Plackett 1950, Biometrika 37, 149; Welford 1962,
/// Technometrics 4, 419): an evaluation takes a search for k in place of all samples.
class RisingIdeal {
 public:
  /// @param strain  of the drive (n or more): the samples, then what follows them
  /// @param stress, weight  of the samples (n); weights are at least 0
  /// @return empty where the strain falls anywhere, or a number is not finite
  static std::optional<RisingIdeal> of(std::span<const double> strain,
                                       std::span<const double> stress,
                                       std::span<const double> weight);

  /// The sum, and its derivatives: those by K and by Y of J^T J do not mix.
  struct Sum {
    double squares = 0.0;
    double by_stiffness = 0.0;
    double by_yield = 0.0;
    double stiffness_normal = 0.0;  ///< A_k
    double yield_normal = 0.0;      ///< W_k
  };
  /// @param stiffness, yield  K and Y, above 0
  /// @return empty where the first strain yields in compression
  std::optional<Sum> sum(double stiffness, double yield) const;

  /// The permanent strain at the end of the drive, and its derivatives.
  struct Permanent {
    double strain = 0.0;
    double by_stiffness = 0.0;
    double by_yield = 0.0;
  };
  Permanent permanent(double stiffness, double yield) const;

 private:
  /// Of the samples before one, or from it on.
  struct Term {
    double weight = 0.0;    ///< A or W
    double best = 0.0;      ///< K_k or Y_k
    double residual = 0.0;  ///< R or M
  };

  std::vector<double> strain_;  // of the samples (n)
  std::vector<Term> elastic_;   // before sample k (n + 1)
  std::vector<Term> plateau_;   // from sample k on (n + 1)
  double last_ = 0.0;           // strain of the drive
};

}  // namespace plastica::calibrate
