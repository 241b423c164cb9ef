#include "calibrate/search/pass_kinks.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "calibrate/search/vector_of.hpp"
#include "calibrate/search/whitened.hpp"

namespace plastica::calibrate {
namespace {

/// A cost that is nothing but rounding, of residuals of order one.
constexpr double kNoiseFloor = 1e-24;
/// Up to how many parameters a simplex looks around for SLSQP, as far as this fraction of the root
/// of the cost.
constexpr std::size_t kFewParameters = 2;
constexpr double kSimplexSize = 0.1;
/// How far SLSQP may go, beyond all that the squares could gain: costs are of order one.
constexpr double kFar = 1e3;

class Descent {
 public:
  Descent(const Problem& problem, MinimizeOptions how, const StageListener& tell,
          const KinkOptions& kinks)
      : problem_(problem), how_(std::move(how)), tell_(tell), kinks_(kinks) {}

  Minimum run(Minimum from) {
    best_ = std::move(from);
    if (best_.x.empty() || !promises(best_.promised, best_.cost)) return std::move(best_);
    for (int round = 0; round < kinks_.rounds; ++round) {
      const double before = best_.cost;
      const bool better = improve("slsqp", kFar);
      const bool few = best_.x.size() <= kFewParameters;
      if (!better && !few) break;
      if (few && !improve("nelder-mead", kSimplexSize * std::sqrt(best_.cost))) break;
      if (before - best_.cost <= how_.cost_tolerance * before) break;
    }
    return std::move(best_);
  }

 private:
  bool promises(double decrease, double cost) const {
    return decrease > kinks_.worthwhile * cost + kNoiseFloor;
  }

  /// @return whether a stage of NLopt from the best point, where the slopes promise a decrease, has
  /// brought one
  bool improve(const char* algorithm, double reach) {
    const SquaresModel model = at_best();
    const Eigen::Map<const Eigen::VectorXd> x(best_.x.data(), model.gradient.size());
    if (!promises(promised_decrease(x, model, vector_of(problem_.lower), vector_of(problem_.upper)),
                  best_.cost)) {
      return false;
    }
    Whitened white(problem_, best_.x, model);
    if (white.empty()) return false;
    how_.algorithm = algorithm;
    Minimum end = minimize(white.problem(reach), how_);
    tell_(algorithm, end);
    best_.evaluations += end.evaluations;
    if (end.x.empty() || !(end.cost < best_.cost)) return false;
    best_.x = white.point(end.x);
    best_.cost = end.cost;
    best_.outcome = std::move(end.outcome);
    return true;
  }

  SquaresModel at_best() const {
    const std::size_t n = best_.x.size();
    SquaresModel model;
    model.gradient.resize(static_cast<Eigen::Index>(n));
    model.normal.resize(model.gradient.size(), model.gradient.size());
    model.cost =
        problem_.squares(best_.x, {model.gradient.data(), n}, {model.normal.data(), n * n});
    return model;
  }

  const Problem& problem_;
  MinimizeOptions how_;
  const StageListener& tell_;
  const KinkOptions& kinks_;
  Minimum best_;
};

}  // namespace

Minimum pass_kinks(const Problem& problem, Minimum from, const MinimizeOptions& how,
                   const StageListener& tell, const KinkOptions& kinks) {
  return Descent(problem, how, tell, kinks).run(std::move(from));
}

}  // namespace plastica::calibrate
