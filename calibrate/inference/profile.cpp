#include "calibrate/inference/profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace plastica::calibrate {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The profile's point where this is wanted, searched from `x`; none where there are no residuals.
using PointAt = std::function<std::optional<ProfilePoint>(double wanted, std::vector<double> x)>;

/// Scans outwards on one side. Distances are those of the wanted value from the best one.
class ProfileScan {
 public:
  /// @param room  largest distance there is
  ProfileScan(PointAt point_at, const ProfileStart& best, bool up, double room,
              const ProfileOptions& options)
      : point_at_(std::move(point_at)),
        best_(best),
        sign_(up ? 1.0 : -1.0),
        room_(room),
        options_(options),
        threshold_(std::sqrt(options.rise)) {
    inside_.value = best.value;
    inside_.x = best.x;
    before_ = inside_;
  }

  ProfileSide run() {
    side_.end = best_.value;
    if (!(room_ > 0.0)) {
      side_.why = ProfileEnd::Bound;
      return std::move(side_);
    }
    double distance = std::min(0.5 * best_.step, room_);
    for (int i = 0; i < options_.points && !ended_; ++i) distance = step_to(distance);
    if (!ended_) end(outside_ ? ProfileEnd::Crossed : ProfileEnd::Open);
    std::ranges::sort(side_.points, {}, &ProfilePoint::value);
    return std::move(side_);
  }

 private:
  struct Place {
    double distance = 0.0;
    double root = 0.0;   ///< of the rise of the cost
    double value = 0.0;  ///< that is reached
    std::vector<double> x;
  };

  /// @return the distance to go to next
  double step_to(double distance) {
    std::optional<ProfilePoint> point = point_at_(best_.value + sign_ * distance, guess(distance));
    if (!point) {
      nothing_from_ = distance;
      if (distance - inside_.distance < kClose * distance) end(ProfileEnd::NoCurves);
      return 0.5 * (inside_.distance + distance);
    }
    Place place;
    place.distance = distance;
    place.root = std::sqrt(std::max(point->cost - best_.cost, 0.0));
    place.value = point->value;
    place.x = point->x;
    side_.points.push_back(std::move(*point));
    const bool met = std::abs(place.root - threshold_) <= options_.tolerance * threshold_;
    const bool is_outside = place.root >= threshold_;
    moves_again_ = outside_ && is_outside == was_outside_;
    was_outside_ = is_outside;
    if (is_outside) {
      outside_ = std::move(place);
    } else {
      const bool stuck = std::abs(place.value - inside_.value) <
                         kClose * std::abs(place.distance - inside_.distance);
      before_ = std::exchange(inside_, std::move(place));
      if (stuck) end(ProfileEnd::Open);
    }
    if (met) {
      end(ProfileEnd::Crossed);
    } else if (!outside_ && inside_.distance >= room_) {
      end(ProfileEnd::Bound);
    }
    return next();
  }

  /// Where the others may be: on the straight line through the last two points.
  std::vector<double> guess(double distance) const {
    std::vector<double> x = inside_.x;
    const double run = inside_.distance - before_.distance;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (outside_) {
        const double fraction =
            (distance - inside_.distance) / (outside_->distance - inside_.distance);
        x[i] += fraction * (outside_->x[i] - inside_.x[i]);
      } else if (run > 0.0) {
        x[i] += (distance - inside_.distance) / run * (inside_.x[i] - before_.x[i]);
      } else if (i < best_.along.size() && std::isfinite(best_.along[i])) {
        x[i] += sign_ * distance * best_.along[i];
      }
    }
    return x;
  }

  double next() const {
    if (outside_) {
      const double width = outside_->distance - inside_.distance;
      const double fraction = (threshold_ - inside_.root) / (outside_->root - inside_.root);
      // Before a wall the line between both ends would creep: then half.
      return inside_.distance + (moves_again_ ? 0.5 : std::clamp(fraction, 0.05, 0.95)) * width;
    }
    const double slope = (inside_.root - before_.root) / (inside_.distance - before_.distance);
    const double last = inside_.distance;
    double to = slope > 0.0 ? last + (threshold_ - inside_.root) / slope : kInfinite;
    // A little further, so that the end is bracketed.
    to = std::clamp(last + 1.02 * (to - last), 1.2 * last, 4.0 * last);
    if (nothing_from_ < kInfinite) to = std::min(to, 0.5 * (last + nothing_from_));
    return std::min(to, room_);
  }

  void end(ProfileEnd why) {
    ended_ = true;
    side_.why = why;
    side_.end = inside_.value;
    if (why != ProfileEnd::Crossed) return;
    const Place& other = outside_ ? *outside_ : before_;
    const double fraction = (threshold_ - inside_.root) / (other.root - inside_.root);
    if (std::isfinite(fraction)) side_.end += fraction * (other.value - inside_.value);
  }

  /// Fraction of a distance below which two of them are the same.
  static constexpr double kClose = 1e-3;

  PointAt point_at_;
  const ProfileStart& best_;
  double sign_;
  double room_;
  const ProfileOptions& options_;
  double threshold_;
  Place inside_, before_;  ///< the furthest point below the threshold, and the one before it
  std::optional<Place> outside_;
  bool was_outside_ = false;  ///< the last point
  bool moves_again_ = false;  ///< it was on the side of the one before, and both sides are known
  double nothing_from_ = kInfinite;
  bool ended_ = false;
  ProfileSide side_;
};

LeastSquaresOptions search_options(const ProfileStart& best, const ProfileOptions& options) {
  LeastSquaresOptions how;
  how.max_evaluations = options.evaluations;
  how.x_tolerance = 1e-7;
  // What is left to gain is nothing beside the rise.
  how.cost_tolerance = 1e-7 * options.rise / (best.cost + options.rise);
  return how;
}

/// The problem of all coordinates but one.
LeastSquaresProblem without(const LeastSquaresProblem& problem, std::size_t held, double at) {
  LeastSquaresProblem others;
  others.residuals = problem.residuals;
  others.has_companions = problem.has_companions;
  for (std::size_t i = 0; i < problem.lower.size(); ++i) {
    if (i == held) continue;
    others.lower.push_back(problem.lower[i]);
    others.upper.push_back(problem.upper[i]);
  }
  others.evaluate = [&problem, held, at](std::span<const double> points,
                                         std::span<double> residuals, std::span<bool> found) {
    const std::size_t n = problem.lower.size();
    std::vector<double> whole;
    whole.reserve(found.size() * n);
    for (std::size_t p = 0; p < found.size(); ++p) {
      const std::span<const double> from = points.subspan(p * (n - 1), n - 1);
      for (std::size_t i = 0, next = 0; i < n; ++i) whole.push_back(i == held ? at : from[next++]);
    }
    problem.evaluate(whole, residuals, found);
  };
  return others;
}

}  // namespace

std::string_view name_of(ProfileEnd end) {
  switch (end) {
    case ProfileEnd::Crossed: return "crossed";
    case ProfileEnd::Bound: return "bound";
    case ProfileEnd::Open: return "open";
    case ProfileEnd::NoCurves: return "no-curves";
  }
  return "";
}

ProfileSide profile_coordinate(const LeastSquaresProblem& problem, const ProfileStart& best,
                               std::size_t coordinate, bool up, const ProfileOptions& options) {
  const double lower = problem.lower[coordinate], upper = problem.upper[coordinate];
  const LeastSquaresOptions how = search_options(best, options);
  const PointAt point_at = [&](double wanted, std::vector<double> x) {
    const double at = std::clamp(wanted, lower, upper);
    LeastSquaresProblem others = without(problem, coordinate, at);
    x.erase(x.begin() + static_cast<std::ptrdiff_t>(coordinate));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = std::clamp(x[i], others.lower[i], others.upper[i]);
    }
    others.start = std::move(x);
    LeastSquares found = minimize_squares(others, how);
    std::optional<ProfilePoint> point;
    if (found.outcome == LeastSquaresOutcome::NoStart) return point;
    found.x.insert(found.x.begin() + static_cast<std::ptrdiff_t>(coordinate), at);
    point = ProfilePoint{at, found.cost, std::move(found.x)};
    return point;
  };
  const double room = up ? upper - best.value : best.value - lower;
  return ProfileScan(point_at, best, up, room, options).run();
}

ProfileSide profile_function(const LeastSquaresProblem& problem, const ProfileStart& best, bool up,
                             const ProfileOptions& options) {
  const LeastSquaresOptions how = search_options(best, options);
  // Of the residual that leads to the wanted value: a third of the standard error, so that a point
  // gets nine tenths of the way and the squares stay well scaled.
  const double width = best.step / (3.0 * std::sqrt(options.rise));
  const std::size_t m = problem.residuals;
  const PointAt point_at = [&](double wanted, std::vector<double> x) {
    LeastSquaresProblem constrained = problem;
    constrained.evaluate = [&](std::span<const double> points, std::span<double> residuals,
                               std::span<bool> found) {
      problem.evaluate(points, residuals, found);
      for (std::size_t p = 0; p < found.size(); ++p) {
        double& last = residuals[p * m + m - 1];
        found[p] = found[p] && std::isfinite(last);
        last = (last - wanted) / width;
      }
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = std::clamp(x[i], problem.lower[i], problem.upper[i]);
    }
    constrained.start = std::move(x);
    const LeastSquares found = minimize_squares(constrained, how);
    std::optional<ProfilePoint> point;
    if (found.outcome == LeastSquaresOutcome::NoStart) return point;
    const double residual = found.residual.back();
    point = ProfilePoint{wanted + width * residual, found.cost - residual * residual, found.x};
    return point;
  };
  return ProfileScan(point_at, best, up, kInfinite, options).run();
}

}  // namespace plastica::calibrate
