#include "plastica/law/closest_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "tests/lib/law/gauge_of.hpp"

namespace plastica::law {
namespace {

using testing::Shaker;

/// One of each kind of yield surface, and rectangles from square to flat.
std::vector<GaugeForm> forms() {
  std::vector<GaugeForm> found;
  for (const testing::SurfaceCase& surface : testing::surface_cases()) {
    found.push_back(testing::gauge_form_of(surface));
  }
  for (const double height : {0.1, 0.04, 0.01}) {
    found.push_back(gauge_form({.width = 0.1, .height = height}, YieldModel::Interaction,
                               YieldCap::FirstYield, Formulas::Mechanics));
  }
  return found;
}

/// A target in the orthant, beyond the surface.
struct Trial {
  SectionForce<double> compliance, target;
  double overshoot;
};

enum class Nasty { No, NearAxis, NearTorsion, NearKink };

/// @param components  bits of the components that there are
/// @param size        phi of the target
template <class Gauge>
Trial random_trial(Shaker& shake, const Gauge& gauge, unsigned components, Nasty nasty,
                   double size) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * (0.5 + 0.4999 * shake());
  };
  if (Gauge::kRound) components &= ~2U;
  if (components == 0) components = 1;
  Trial trial;
  const auto main = static_cast<std::size_t>(between(0.0, 4.0));
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    trial.compliance[i] = std::pow(10.0, between(-0.7, 0.7));
    if ((components >> i & 1U) == 0) continue;
    double part = 1.0;
    if (nasty == Nasty::NearAxis && i != main) part = std::pow(10.0, between(-9.0, -1.0));
    if (nasty == Nasty::NearTorsion && i != kTorsion) part = std::pow(10.0, between(-9.0, -0.5));
    if (nasty == Nasty::NearKink) part = shake() > 0.0 ? 1.0 : std::pow(10.0, between(-8.0, -2.0));
    trial.target[i] = part * between(0.02, 1.0);
  }
  if (Gauge::kRound) trial.compliance[kBendingY] = trial.compliance[kBendingX];
  trial.target = (1.0 / orthant_gauge(gauge, trial.target)) * trial.target;
  if (nasty == Nasty::NearKink) {
    // Along some of the normals nearby: the closest point is near where their facets meet.
    SectionForce<double> direction;
    for (std::size_t k = 0; k < Gauge::kFacets; ++k) {
      const auto f = gauge.facet(k, trial.target);
      if (k > 0 && (f.value < 0.45 || shake() > 0.0)) continue;
      direction += between(0.1, 1.0) * f.gradient;
    }
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      direction[i] *= trial.target[i] > 0.0 ? trial.compliance[i] : 0.0;
    }
    const double beyond = orthant_gauge(gauge, direction);
    if (beyond > 0.0) trial.target += ((size - 1.0) / beyond) * direction;
  } else {
    trial.target = size * trial.target;
  }
  trial.overshoot = orthant_gauge(gauge, trial.target) - 1.0;
  return trial;
}

template <class Gauge>
detail::ClosestPoint<Gauge> closest(const Gauge& gauge, const Trial& trial) {
  return {gauge, trial.compliance, trial.target, trial.overshoot, true};
}

/// Calls `use(gauge, trial)` for many trials: each surface, all components that there can be, just
/// beyond and far, ordinary and nasty.
template <class Use>
void for_each_trial(int count, const std::vector<double>& sizes, const Use& use) {
  Shaker shake(21);
  for (const GaugeForm& form : forms()) {
    with_gauge<double>(form, [&](const auto& gauge) {
      for (const double size : sizes) {
        for (const Nasty nasty :
             {Nasty::No, Nasty::NearAxis, Nasty::NearTorsion, Nasty::NearKink}) {
          for (unsigned components = 3; components < 16; ++components) {
            for (int i = 0; i < count; ++i) {
              use(gauge, random_trial(shake, gauge, components, nasty, size));
            }
          }
        }
      }
    });
  }
}

using Direction = std::array<long double, kSectionAxes>;

/// What the cone of at most four of the directions leaves of `r`, squared in the metric of c.
long double left_of(const Direction& r, const std::vector<Direction>& cone,
                    const SectionForce<double>& c) {
  const auto product = [&](const Direction& a, const Direction& b) {
    long double sum = 0.0L;
    for (std::size_t i = 0; i < kSectionAxes; ++i) sum += a[i] * c[i] * b[i];
    return sum;
  };
  long double least = product(r, r);
  // The least of all subsets of which each has non-negative weights.
  const auto go = [&](const auto& self, std::size_t from,
                      std::vector<std::size_t>& chosen) -> void {
    if (!chosen.empty()) {
      const std::size_t n = chosen.size();
      std::vector<std::vector<long double>> a(n, std::vector<long double>(n + 1));
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) a[i][j] = product(cone[chosen[i]], cone[chosen[j]]);
        a[i][n] = product(cone[chosen[i]], r);
      }
      bool independent = true;
      for (std::size_t i = 0; i < n && independent; ++i) {
        const long double whole = product(cone[chosen[i]], cone[chosen[i]]);
        independent = a[i][i] > 1e-17L * whole;
        for (std::size_t j = 0; j < n && independent; ++j) {
          if (j == i) continue;
          const long double part = a[j][i] / a[i][i];
          for (std::size_t k = i; k <= n; ++k) a[j][k] -= part * a[i][k];
        }
      }
      if (!independent) return;
      Direction rest = r;
      bool inside = true;
      for (std::size_t i = 0; i < n; ++i) {
        const long double weight = a[i][n] / a[i][i];
        inside = inside && weight >= 0.0L;
        for (std::size_t k = 0; k < kSectionAxes; ++k) rest[k] -= weight * cone[chosen[i]][k];
      }
      if (inside) least = std::min(least, product(rest, rest));
    }
    if (chosen.size() == kSectionAxes) return;
    for (std::size_t k = from; k < cone.size(); ++k) {
      chosen.push_back(k);
      self(self, k + 1, chosen);
      chosen.pop_back();
    }
  };
  std::vector<std::size_t> chosen;
  go(go, 0, chosen);
  return least;
}

/// How far a point on the surface may be from the closest one, in the root of twice the energy, by
/// Karush, Kuhn and Tucker: with W (y - u) in the cone of the normals but for e, u is the closest
/// point of y - C e; and projections bring no two targets further apart.
template <class Gauge>
double distance_bound(const Gauge& gauge, const Trial& trial, const SectionForce<double>& u) {
  Direction r{};
  std::vector<Direction> cone;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    if (!(trial.target[i] > 0.0)) continue;  // all are even in it
    r[i] = (static_cast<long double>(trial.target[i]) - u[i]) / trial.compliance[i];
    if (i != kTorsion && u[i] < 1e-13) {
      Direction bound{};
      bound[i] = -1.0L;
      cone.push_back(bound);
    }
  }
  for (std::size_t k = 0; k < Gauge::kFacets; ++k) {
    const auto f = gauge.facet(k, u);
    if (f.value < 0.5 - 1e-12) continue;
    Direction normal{};
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (trial.target[i] > 0.0) normal[i] = f.gradient[i];
    }
    if (std::find(cone.begin(), cone.end(), normal) == cone.end()) cone.push_back(normal);
  }
  return static_cast<double>(std::sqrt(left_of(r, cone, trial.compliance)));
}

TEST(ClosestPoint, HasTheConditionsOfKarushKuhnAndTuckerWhateverTheTarget) {
  int trials = 0;
  for_each_trial(4, {1.0 + 1e-6, 1.05, 4.0, 100.0}, [&](const auto& gauge, const Trial& trial) {
    ++trials;
    const SectionForce<double> point = closest(gauge, trial).result().point;
    ASSERT_NEAR(orthant_gauge(gauge, point), 1.0, 1e-12);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      ASSERT_GE(point[i], 0.0);
      ASSERT_TRUE(trial.target[i] > 0.0 || point[i] == 0.0);
    }
    const double distance = distance_bound(gauge, trial, point);
    // The energy is off by half of its square.
    ASSERT_LE(0.5 * distance * distance, 1e-12) << trial.overshoot;
  });
  EXPECT_GT(trials, 8000);
}

TEST(ClosestPoint, NeedsFewSteps) {
  for_each_trial(4, {1.0 + 1e-6, 1.05, 4.0, 100.0, 1e4},
                 [&](const auto& gauge, const Trial& trial) {
                   const auto found = closest(gauge, trial);
                   ASSERT_TRUE(found.converged()) << trial.overshoot;
                   ASSERT_LE(found.steps(), 40) << trial.overshoot;
                 });
}

/// Differences cross an edge of the surface now and then.
TEST(ClosestPoint, HasTheSlopeOfItsPoint) {
  int trials = 0;
  int wrong = 0;
  for_each_trial(1, {1.05, 1.5, 4.0}, [&](const auto& gauge, const Trial& trial) {
    const auto slope = closest(gauge, trial).result().slope;
    double error = 0.0;
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      if (!(trial.target[j] > 1e-4)) continue;
      const auto at = [&](double step) {
        Trial moved = trial;
        moved.target[j] += step;
        moved.overshoot = orthant_gauge(gauge, moved.target) - 1.0;
        return closest(gauge, moved).result().point;
      };
      const auto difference = (1.0 / 2e-6) * (at(1e-6) - at(-1e-6));
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        if (!(trial.target[i] > 1e-4)) continue;
        error = std::max(error, std::fabs(difference[i] - slope(i, j)));
      }
    }
    ++trials;
    wrong += error > 1e-4 ? 1 : 0;
  });
  EXPECT_GT(trials, 1000);
  EXPECT_LE(wrong, trials / 50);
}

TEST(ClosestPoint, GivesDualNumbersItsSlope) {
  using D = Dual<double, 1>;
  Shaker shake(22);
  for (const GaugeForm& form : forms()) {
    with_gauge<double>(form, [&](const auto& gauge) {
      with_gauge<D>(form, [&]<class Lifted>(const Lifted& lifted) {
        if constexpr (Lifted::kFacets == std::remove_cvref_t<decltype(gauge)>::kFacets &&
                      Lifted::kRound == std::remove_cvref_t<decltype(gauge)>::kRound) {
          for (int trials = 0; trials < 30; ++trials) {
            const Trial trial = random_trial(shake, gauge, 15, Nasty::No, 1.0 + 0.02 * trials);
            if (!(trial.overshoot > 0.0)) continue;
            const auto slope = closest(gauge, trial).result().slope;
            for (std::size_t j = 0; j < kSectionAxes; ++j) {
              if (!(trial.target[j] > 0.0)) continue;
              SectionForce<D> compliance, target;
              for (std::size_t i = 0; i < kSectionAxes; ++i) {
                compliance[i] = D(trial.compliance[i]);
                target[i] = i == j ? D::parameter(trial.target[i], 0) : D(trial.target[i]);
              }
              const D overshoot(trial.overshoot);
              const auto point = detail::ClosestPoint<Lifted>(lifted, compliance, target, overshoot,
                                                              overshoot > D(0.0))
                                     .result()
                                     .point;
              for (std::size_t i = 0; i < kSectionAxes; ++i) {
                EXPECT_NEAR(point[i].derivative(0), slope(i, j), 1e-9);
              }
            }
          }
        }
      });
    });
  }
}

TEST(ClosestPoint, GivesALaneTheBitsOfALoneDouble) {
  using Lanes = Pack<double, 8>;
  Shaker shake(23);
  for (const GaugeForm& form : forms()) {
    with_gauge<double>(form, [&](const auto& gauge) {
      with_gauge<Lanes>(form, [&]<class Wide>(const Wide& lanes) {
        if constexpr (Wide::kFacets == std::remove_cvref_t<decltype(gauge)>::kFacets &&
                      Wide::kRound == std::remove_cvref_t<decltype(gauge)>::kRound) {
          for (int group = 0; group < 20; ++group) {
            std::array<Trial, 8> trials;
            SectionForce<Lanes> compliance, target;
            Lanes overshoot;
            for (int lane = 0; lane < 8; ++lane) {
              const unsigned components = lane < 5 ? 15U : static_cast<unsigned>(lane) + 6U;
              Trial& trial = trials[static_cast<std::size_t>(lane)];
              trial = random_trial(shake, gauge, components, static_cast<Nasty>(lane % 4),
                                   lane % 2 == 0 ? 1.05
                                   : lane == 3   ? 100.0
                                                 : 4.0);
              for (std::size_t i = 0; i < kSectionAxes; ++i) {
                compliance[i].set(lane, trial.compliance[i]);
                target[i].set(lane, trial.target[i]);
              }
              overshoot.set(lane, trial.overshoot);
            }
            const mask_t<Lanes> all = overshoot > constant<Lanes>(0);
            const Projection<Lanes> found =
                detail::ClosestPoint<Wide>(lanes, compliance, target, overshoot, all).result();
            for (int lane = 0; lane < 8; ++lane) {
              const Projection<double> expected =
                  closest(gauge, trials[static_cast<std::size_t>(lane)]).result();
              for (std::size_t i = 0; i < kSectionAxes; ++i) {
                ASSERT_EQ(found.point[i][lane], expected.point[i]);
                for (std::size_t j = 0; j < kSectionAxes; ++j) {
                  ASSERT_EQ(found.slope(i, j)[lane], expected.slope(i, j));
                }
              }
            }
          }
        }
      });
    });
  }
}

TEST(ClosestPoint, IsFoundInSingleNumbers) {
  Shaker shake(24);
  for (const GaugeForm& form : forms()) {
    with_gauge<double>(form, [&](const auto& gauge) {
      with_gauge<float>(form, [&]<class Single>(const Single& single) {
        if constexpr (Single::kFacets == std::remove_cvref_t<decltype(gauge)>::kFacets &&
                      Single::kRound == std::remove_cvref_t<decltype(gauge)>::kRound) {
          for (int trials = 0; trials < 200; ++trials) {
            const Trial trial = random_trial(shake, gauge, 15, static_cast<Nasty>(trials % 4),
                                             trials % 3 == 0 ? 4.0 : 1.5);
            SectionForce<float> compliance, target;
            for (std::size_t i = 0; i < kSectionAxes; ++i) {
              compliance[i] = static_cast<float>(trial.compliance[i]);
              target[i] = static_cast<float>(trial.target[i]);
            }
            const float overshoot = orthant_gauge(single, target) - 1.0F;
            const auto found =
                detail::ClosestPoint<Single>(single, compliance, target, overshoot, true).result();
            const auto expected = closest(gauge, trial).result();
            for (std::size_t i = 0; i < kSectionAxes; ++i) {
              EXPECT_NEAR(found.point[i], expected.point[i], 1e-3);
            }
          }
        }
      });
    });
  }
}

}  // namespace
}  // namespace plastica::law
