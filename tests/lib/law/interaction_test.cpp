#include "plastica/law/interaction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/law/per_axis.hpp"
#include "tests/lib/law/gauge_of.hpp"

namespace plastica::law {
namespace {

using testing::form_of;
using testing::gauge_form_of;
using testing::Shaker;
using testing::steel;
using testing::strain_of;
using testing::surface_cases;
using testing::SurfaceCase;
using testing::values_of;
using testing::yield_strain;

constexpr HardeningLaw kLaws[] = {HardeningLaw::Ideal, HardeningLaw::Linear,
                                  HardeningLaw::VoceChaboche, HardeningLaw::Multilinear};

/// Calls `test(law, yield strains, name, per-axis law)` for each surface and hardening.
template <class S, class Test>
void for_each_section(const Test& test) {
  for (const HardeningLaw hardening : kLaws) {
    for (const SurfaceCase& surface : surface_cases()) {
      const Material material = steel(hardening);
      const SectionForm form = form_of(surface.section, material, surface.cap);
      with_gauge<S>(gauge_form_of(surface), [&](const auto& gauge) {
        with_law_type<S>(hardening, [&]<class Law>(std::type_identity<Law>) {
          test(interaction_section<Law>(form, gauge, values_of<S>(material)),
               yield_strain(form, material),
               surface.name + ", law " + std::to_string(static_cast<int>(hardening)),
               per_axis_section<Law>(form, values_of<S>(material)));
        });
      });
    }
  }
}

/// f: gauge of force over caps less the back stresses, over the radius, less one.
template <class Section>
double overshoot(const Section& law, const typename Section::State& state,
                 const SectionForce<double>& force) {
  SectionForce<double> z;
  for (std::size_t i = 0; i < 4; ++i) {
    z[i] = force[i] / law.cap[i];
    for (const auto& back : state.back) z[i] -= back[i];
  }
  return gauge_value(law.gauge, z) / law.rule.radius(state.equivalent, 0.0).value - 1.0;
}

/// A step of a random path: small and large, some components of it zero or nearly so.
SectionStrain<double> random_step(Shaker& shake, const std::array<double, 4>& yield) {
  SectionStrain<double> step;
  const double size = std::pow(10.0, shake());
  for (std::size_t i = 0; i < 4; ++i) {
    const double kind = shake();
    const double part = kind > 0.7 ? 0.0 : kind < -0.8 ? 1e-7 : 1.0;
    step[i] = size * part * shake() * yield[i];
  }
  return step;
}

TEST(InteractionSection, EndsOnItsSurfaceWithTheStrainSplitExactly) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    typename std::remove_cvref_t<decltype(law)>::State state;
    SectionStrain<double> strain;
    Shaker shake(11);
    for (int i = 0; i < 100; ++i) {
      strain += random_step(shake, yield);
      const auto now = respond(law, state, state, strain);
      ASSERT_LE(overshoot(law, state, now.force), 1e-12) << name << i;
      for (std::size_t k = 0; k < 4; ++k) {
        const double elastic = law.stiffness[k] * (strain[k] - state.plastic[k]);
        ASSERT_NEAR(now.force[k], elastic, 1e-11 * law.cap[k]) << name << i;
      }
      ASSERT_GE(now.plastic_work, 0.0) << name << i;
    }
  });
}

TEST(InteractionSection, ReturnsFromTrialForcesOfAnySize) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    Shaker shake(12);
    for (const double size : {1.0 + 1e-9, 1.5, 1e2, 1e4}) {
      for (int i = 0; i < 10; ++i) {
        typename std::remove_cvref_t<decltype(law)>::State state;
        SectionStrain<double> strain;
        SectionForce<double> trial;
        for (std::size_t k = 0; k < 4; ++k) trial[k] = shake();
        const double phi = gauge_value(law.gauge, trial);
        for (std::size_t k = 0; k < 4; ++k) strain[k] = size * trial[k] / phi * yield[k];
        const auto now = respond(law, state, state, strain);
        ASSERT_NEAR(overshoot(law, state, now.force), 0.0, 1e-12) << name << size;
      }
    }
  });
}

/// Exactly on an axis of a surface with a corner there, a small other component meets nothing.
TEST(InteractionSection, IsNotSingularAcrossABendingThatFlows) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    typename std::remove_cvref_t<decltype(law)>::State state;
    const auto now = respond(law, state, state, {{3.0 * yield[0], 0.0, 0.0, 0.0}});
    for (std::size_t k = 1; k < 4; ++k) {
      EXPECT_GE(now.tangent(k, k), 0.9e-5 * law.stiffness[k]) << name << k;
      EXPECT_EQ(now.force[k], 0.0) << name << k;
    }
    const auto beside = respond(law, state, state, {{3.0 * yield[0], 1e-9 * yield[1], 0.0, 0.0}});
    EXPECT_LE(std::fabs(beside.force[1]), 1e-9 * law.cap[1]) << name;
  });
}

/// The closest point is the one from which no admissible force is further along the cut.
TEST(InteractionSection, FlowsToTheClosestPointInElasticEnergy) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    if (law.rule.kBacks != 0) return;
    Shaker shake(13);
    for (int i = 0; i < 50; ++i) {
      typename std::remove_cvref_t<decltype(law)>::State state;
      const SectionStrain<double> strain = 5.0 * random_step(shake, yield);
      const auto now = respond(law, state, state, strain);
      for (int j = 0; j < 50; ++j) {
        SectionForce<double> other = random_step(shake, {1.0, 1.0, 1.0, 1.0});
        const double phi = gauge_value(law.gauge, other);
        if (!(phi > 0.0)) continue;
        double gain = 0.0;
        double work = 1e-300;
        for (std::size_t k = 0; k < 4; ++k) {
          gain += state.plastic[k] * (law.cap[k] * other[k] / phi - now.force[k]);
          work += std::fabs(state.plastic[k] * now.force[k]);
        }
        ASSERT_LE(gain / work, 1e-9) << name;
      }
    }
  });
}

TEST(InteractionSection, IsTheUniaxialLawForOneComponent) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name,
                              const auto& per_axis) {
    for (std::size_t k = 0; k < 4; ++k) {
      typename std::remove_cvref_t<decltype(law)>::State state;
      typename std::remove_cvref_t<decltype(per_axis)>::State alone;
      for (const double size : {0.5, 3.0, 2.0, -4.0, 10.0, 9.5, -100.0}) {
        SectionStrain<double> strain;
        strain[k] = size * yield[k];
        const auto now = respond(law, state, state, strain);
        const auto expected = respond(per_axis, alone, alone, strain);
        const double energy = law.cap[k] * yield[k];
        EXPECT_NEAR(now.force[k], expected.force[k], 1e-11 * law.cap[k]) << name << k;
        EXPECT_NEAR(now.tangent(k, k), expected.tangent(k, k), 1e-12 * law.stiffness[k]) << name;
        EXPECT_NEAR(now.plastic_work, expected.plastic_work, 1e-10 * energy) << name;
        EXPECT_NEAR(now.elastic_energy, expected.elastic_energy, 1e-10 * energy) << name;
        EXPECT_NEAR(state.plastic[k], alone.axis[k].plastic / per_axis.lever[k], 1e-11 * yield[k]);
        EXPECT_NEAR(state.accumulated[k], alone.axis[k].accumulated / per_axis.lever[k],
                    1e-10 * yield[k]);
        for (std::size_t other = 0; other < 4; ++other) {
          if (other == k) continue;
          EXPECT_EQ(now.force[other], 0.0) << name;
          EXPECT_EQ(state.plastic[other], 0.0) << name;
        }
      }
    }
  });
}

/// Differences cross a kink of the surface now and then; the tangent is then that of one side.
TEST(InteractionSection, HasTheTangentOfItsForce) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    using State = typename std::remove_cvref_t<decltype(law)>::State;
    State state;
    SectionStrain<double> strain;
    Shaker shake(14);
    int wrong = 0;
    int plastic = 0;
    for (int i = 0; i < 100; ++i) {
      const double size = i % 3 == 0 ? 2.0 : 0.3;
      for (std::size_t k = 0; k < 4; ++k) strain[k] += size * shake() * yield[k];
      const State before = state;
      const auto now = respond(law, before, state, strain);
      plastic += now.plastic_work > 0.0 ? 1 : 0;
      double error = 0.0;
      for (std::size_t j = 0; j < 4; ++j) {
        const double h = 1e-6 * yield[j];
        SectionStrain<double> more = strain;
        SectionStrain<double> less = strain;
        more[j] += h;
        less[j] -= h;
        State unused;
        const auto a = respond(law, before, unused, more).force;
        const auto b = respond(law, before, unused, less).force;
        for (std::size_t k = 0; k < 4; ++k) {
          const double difference = (a[k] - b[k]) / (2.0 * h) * yield[j] / law.cap[k];
          error =
              std::max(error, std::fabs(difference - now.tangent(k, j) * yield[j] / law.cap[k]));
        }
      }
      wrong += error > 1e-4 ? 1 : 0;
    }
    EXPECT_GT(plastic, 50) << name;
    EXPECT_LE(wrong, 2) << name;
  });
}

TEST(InteractionSection, UnloadsElastically) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    typename std::remove_cvref_t<decltype(law)>::State state;
    const SectionStrain<double> strain{{3.0 * yield[0], yield[1], -2.0 * yield[2], 0.5 * yield[3]}};
    const auto loaded = respond(law, state, state, strain);
    const auto before = state;
    const auto now = respond(law, before, state, 0.9999 * strain);
    EXPECT_EQ(now.plastic_work, 0.0) << name;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(state.plastic[k], before.plastic[k]);
      EXPECT_NEAR(now.tangent(k, k), law.stiffness[k], 1e-14 * law.stiffness[k]);
      EXPECT_NEAR(now.force[k], loaded.force[k] - 1e-4 * law.stiffness[k] * strain[k],
                  1e-10 * law.cap[k]);
    }
    // And the same strain again is the same state.
    typename std::remove_cvref_t<decltype(law)>::State again;
    const auto repeated = respond(law, before, again, strain);
    EXPECT_EQ(repeated.plastic_work, 0.0) << name;
  });
}

TEST(InteractionSection, AccountsForTheWorkDoneOnIt) {
  for_each_section<double>([](const auto& law, const auto& yield, const auto& name, const auto&) {
    typename std::remove_cvref_t<decltype(law)>::State state;
    SectionStrain<double> strain;
    SectionForce<double> force;
    double external = 0.0;
    double plastic = 0.0;
    double elastic = 0.0;
    for (int i = 1; i <= 400; ++i) {
      const double s = 3.0 * std::sin(0.02 * i);
      const SectionStrain<double> next{
          {s * yield[0], 0.5 * s * yield[1], -0.7 * s * s * yield[2], 0.2 * s * yield[3]}};
      const auto now = respond(law, state, state, next);
      external += 0.5 * dot(force + now.force, next - strain);
      plastic += now.plastic_work;
      elastic = now.elastic_energy;
      strain = next;
      force = now.force;
    }
    // Trapezoids of 0.06 yield strains.
    EXPECT_NEAR(elastic + plastic, external, 5e-3 * external) << name;
    EXPECT_GT(plastic, elastic) << name;
  });
}

/// The end of a path of a few steps through yield.
template <class S, class Section>
SectionForce<S> force_after(const Section& law, const std::array<double, 4>& yield,
                            double scale = 1.0) {
  typename Section::State state;
  SectionForce<S> force;
  Shaker shake(15);
  for (int i = 0; i < 6; ++i) {
    std::array<double, 4> strain{};
    for (std::size_t k = 0; k < 4; ++k) strain[k] = scale * 3.0 * yield[k] * shake();
    force = respond(law, state, state, strain_of<S>(strain)).force;
  }
  return force;
}

TEST(InteractionSection, GivesALaneTheBitsOfALoneDouble) {
  using Lanes = Pack<double, 8>;
  for (const HardeningLaw hardening : kLaws) {
    for (const SurfaceCase& surface : surface_cases()) {
      const Material material = steel(hardening);
      const SectionForm form = form_of(surface.section, material, surface.cap);
      const auto yield = yield_strain(form, material);
      const auto run = [&]<class S>(std::type_identity<S>, const auto& use) {
        with_gauge<S>(gauge_form_of(surface), [&](const auto& gauge) {
          with_law_type<S>(hardening, [&]<class Law>(std::type_identity<Law>) {
            use(interaction_section<Law>(form, gauge, values_of<S>(material)));
          });
        });
      };
      // Lanes from elastic to far beyond yield, one of them along an axis.
      std::array<double, 8> size{0.1, 1.0, 0.5, 30.0, 2.0, 1e-3, 7.0, 1.0};
      run(std::type_identity<Lanes>{}, [&](const auto& law) {
        typename std::remove_cvref_t<decltype(law)>::State state;
        std::array<std::array<SectionStrain<double>, 8>, 4> path;
        std::array<SectionForce<Lanes>, 4> forces;
        Shaker shake(16);
        for (std::size_t i = 0; i < path.size(); ++i) {
          SectionStrain<Lanes> strain;
          for (int lane = 0; lane < 8; ++lane) {
            auto& of_lane = path[i][static_cast<std::size_t>(lane)];
            for (std::size_t k = 0; k < 4; ++k) {
              of_lane[k] = size[static_cast<std::size_t>(lane)] * 2.0 * yield[k] * shake();
              if (lane == 7 && k > 0) of_lane[k] = 0.0;
              strain[k].set(lane, of_lane[k]);
            }
          }
          forces[i] = respond(law, state, state, strain).force;
        }
        run(std::type_identity<double>{}, [&](const auto& lone) {
          for (std::size_t lane = 0; lane < 8; ++lane) {
            typename std::remove_cvref_t<decltype(lone)>::State alone;
            for (std::size_t i = 0; i < path.size(); ++i) {
              const auto now = respond(lone, alone, alone, path[i][lane]);
              for (std::size_t k = 0; k < 4; ++k) {
                ASSERT_EQ(forces[i][k][static_cast<int>(lane)], now.force[k])
                    << surface.name << lane;
              }
            }
          }
        });
      });
    }
  }
}

TEST(InteractionSection, TakesSingleNumbersAndDerivatives) {
  using D = Dual<double, 1>;
  constexpr auto kYield = static_cast<std::size_t>(MaterialField::YieldStress);
  for (const HardeningLaw hardening : kLaws) {
    for (const SurfaceCase& surface : surface_cases()) {
      const Material material = steel(hardening);
      const SectionForm form = form_of(surface.section, material, surface.cap);
      const auto yield = yield_strain(form, material);
      const std::string name = surface.name + std::to_string(static_cast<int>(hardening));
      const auto with = [&](double step) {
        SectionForce<double> force;
        MaterialValues<double> values = material_values(material);
        values[kYield] += step;
        with_gauge<double>(gauge_form_of(surface), [&](const auto& gauge) {
          with_law_type<double>(hardening, [&]<class Law>(std::type_identity<Law>) {
            force = force_after<double>(interaction_section<Law>(form, gauge, values), yield);
          });
        });
        return force;
      };
      const auto expected = with(0.0);
      const auto more = with(1e2);
      const auto less = with(-1e2);
      SectionForce<double> cap;
      for (std::size_t k = 0; k < 4; ++k) cap[k] = form.modulus[k] * 300e6;
      with_gauge<D>(gauge_form_of(surface), [&](const auto& gauge) {
        with_law_type<D>(hardening, [&]<class Law>(std::type_identity<Law>) {
          MaterialValues<D> values = values_of<D>(material);
          values[kYield] = D::parameter(values[kYield].value(), 0);
          const auto dual = force_after<D>(interaction_section<Law>(form, gauge, values), yield);
          for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(dual[k].value(), expected[k], 1e-10 * cap[k]) << name << k;
            const double slope = (more[k] - less[k]) / 2e2;
            EXPECT_NEAR(dual[k].derivative(0), slope, 1e-5 * cap[k] / 300e6) << name << k;
          }
        });
      });
      with_gauge<float>(gauge_form_of(surface), [&](const auto& gauge) {
        with_law_type<float>(hardening, [&]<class Law>(std::type_identity<Law>) {
          const auto single = force_after<float>(
              interaction_section<Law>(form, gauge, values_of<float>(material)), yield);
          for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(single[k], expected[k], 5e-3 * cap[k]) << name << k;
          }
        });
      });
    }
  }
}

}  // namespace
}  // namespace plastica::law
