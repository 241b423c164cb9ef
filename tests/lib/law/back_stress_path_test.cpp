#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "plastica/law/interaction.hpp"
#include "tests/lib/law/gauge_of.hpp"

// Back stresses of a surface whose flow turns: they recover in all directions, dX = C n dp - gamma
// X dp, not only along the flow.

namespace plastica::law {
namespace {

using testing::form_of;
using testing::gauge_at;
using testing::gauge_form_of;
using testing::steel;
using testing::SurfaceCase;
using testing::values_of;
using testing::yield_strain;

/// The rates of interaction.hpp and voce_chaboche.hpp, followed in as many explicit steps as it
/// takes: the normal by differences, no projection and no exponentials.
template <class Law>
class Followed {
 public:
  Followed(const Law& law, const GaugeForm& gauge) : law_(law), gauge_(gauge) {}

  void go(const SectionStrain<double>& step) {
    SectionForce<double> moved;
    for (std::size_t i = 0; i < 4; ++i) {
      strain_[i] += step[i];
      moved[i] = law_.per_strain[i] * step[i];
    }
    const SectionForce<double> at = relative();
    const double radius = law_.rule.radius(p_, 0.0).value;
    if (gauge_at(gauge_, at) < radius) return;
    const SectionForce<double> normal = normal_at(at);
    double elastic_area = 0.0, plastic_area = 0.0, into = 0.0, square = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      elastic_area += law_.elastic[i] * at[i] * at[i] / (radius * radius);
      plastic_area += law_.area[i] * at[i] * at[i] / (radius * radius);
      into += normal[i] * moved[i];
      square += normal[i] * normal[i] / law_.elastic[i];
    }
    double hardens = plastic_area, fades = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      hardens += elastic_area * law_.rule.back_modulus[k];
      fades += law_.rule.back_rate[k] * dot(normal, back_[k]);
    }
    const double dp = into / (square * hardens - fades + law_.rule.radius(p_, 0.0).slope);
    if (!(dp > 0.0)) return;
    for (std::size_t i = 0; i < 4; ++i) {
      const double along = normal[i] / law_.elastic[i];
      plastic_[i] += law_.per_force[i] * along * plastic_area * dp;
      for (std::size_t k = 0; k < 3; ++k) {
        back_[k][i] += (along * elastic_area * law_.rule.back_modulus[k] -
                        law_.rule.back_rate[k] * back_[k][i]) *
                       dp;
      }
    }
    p_ += dp;
  }
  SectionForce<double> over_caps() const {
    SectionForce<double> z;
    for (std::size_t i = 0; i < 4; ++i) z[i] = law_.per_strain[i] * (strain_[i] - plastic_[i]);
    return z;
  }

 private:
  SectionForce<double> relative() const {
    SectionForce<double> z = over_caps();
    for (const auto& back : back_) z = z - back;
    return z;
  }
  SectionForce<double> normal_at(const SectionForce<double>& at) const {
    constexpr double kStep = 1e-6;
    SectionForce<double> normal;
    for (std::size_t i = 0; i < 4; ++i) {
      SectionForce<double> up = at, down = at;
      up[i] += kStep;
      down[i] -= kStep;
      normal[i] = (gauge_at(gauge_, up) - gauge_at(gauge_, down)) / (2.0 * kStep);
    }
    return normal;
  }

  const Law& law_;
  GaugeForm gauge_;
  SectionStrain<double> strain_{}, plastic_{};
  std::array<SectionForce<double>, 3> back_{};
  double p_ = 0.0;
};

/// The largest difference of forces over caps on a path of straight parts.
/// @param steps  of each part; 100 explicit ones for each
double largest_difference(const SurfaceCase& surface,
                          const std::vector<SectionStrain<double>>& corners, int steps) {
  const Material material = steel(HardeningLaw::VoceChaboche);
  const SectionForm form = form_of(surface.section, material, surface.cap);
  const std::array<double, 4> yield = yield_strain(form, material);
  const GaugeForm gauge_form = gauge_form_of(surface);
  double largest = 0.0;
  with_gauge<double>(gauge_form, [&](const auto& gauge) {
    const auto law =
        interaction_section<VoceChaboche<double>>(form, gauge, values_of<double>(material));
    typename std::remove_cvref_t<decltype(law)>::State state;
    Followed followed(law, gauge_form);
    SectionStrain<double> from{};
    for (const SectionStrain<double>& corner : corners) {
      constexpr int kParts = 100;
      for (int i = 1; i <= steps; ++i) {
        SectionStrain<double> strain, part;
        for (std::size_t k = 0; k < 4; ++k) {
          const double step = (corner[k] - from[k]) * yield[k] / steps;
          strain[k] = from[k] * yield[k] + i * step;
          part[k] = step / kParts;
        }
        for (int n = 0; n < kParts; ++n) followed.go(part);
        const SectionResponse<double> now = respond(law, state, state, strain);
        const SectionForce<double> z = followed.over_caps();
        for (std::size_t k = 0; k < 4; ++k) {
          largest = std::max(largest, std::abs(now.force[k] / law.cap[k] - z[k]));
        }
      }
      from = corner;
    }
  });
  return largest;
}

TEST(BackStress, RecoversAcrossTheFlowToo) {
  const SurfaceCase tube{"tube", Section{.shape = SectionShape::RoundTube}, YieldModel::Interaction,
                         YieldCap::FullyPlastic};
  const SurfaceCase bar{"bar", Section{.shape = SectionShape::Circle}, YieldModel::Interaction,
                        YieldCap::FirstYield};
  // Pulled, then twisted; bent, then bent across, and twisted back.
  const std::vector<SectionStrain<double>> pulled{{{0, 0, 0, 3}}, {{0, 0, 8, 3}}};
  const std::vector<SectionStrain<double>> bent{{{3, 0, 0, 0}}, {{3, 9, 0, 0}}, {{3, 9, -6, 0}}};
  for (const SurfaceCase& surface : {tube, bar}) {
    for (const auto& path : {pulled, bent}) {
      const double coarse = largest_difference(surface, path, 200);
      const double fine = largest_difference(surface, path, 800);
      EXPECT_LT(fine, 2e-3) << surface.name << ", " << path.size();
      EXPECT_LT(fine, 0.4 * coarse) << surface.name << ": not of first order";
    }
  }
}

}  // namespace
}  // namespace plastica::law
