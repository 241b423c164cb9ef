#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/simulate.hpp"
#include "plastica/solve/motion_step.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/tolerance.hpp"

/// Every scheme of solve/scheme.hpp, held to what it claims; and claims that are too good, which
/// must be caught.
namespace plastica {
namespace {

using solve::EnergyBehaviour;
using solve::SchemeClaims;
using std::numbers::pi;

constexpr std::size_t kSchemeSegments = 3;

/// A soft elastic bar of 1 m, 20 mm x 30 mm, clamped or free.
Scene bar(bool clamped) {
  Scene scene;
  scene.material.youngs_modulus = 2e8;
  scene.material.density = 1200.0;
  scene.section.width = 0.02;
  scene.section.height = 0.03;
  scene.beam.segments = static_cast<int>(kSchemeSegments);
  if (clamped) scene.supports.push_back({});
  return scene;
}

/// The bar of a level in motion, a step at a time.
template <class L>
class Swing {
 public:
  using Law = law::ElasticSection<double>;
  using SpinOf = std::function<std::array<double, 3>(double)>;

  /// @param spin_of  spin of a segment at time 0, in world axes, by its middle's place 0 … 1
  Swing(Scheme scheme, double rho_infinity, bool clamped, const SpinOf& spin_of)
      : solved_(bar(clamped), material_values(bar(clamped).material), view_),
        options_{.scheme = scheme, .rho_infinity = rho_infinity},
        step_(solved_.build.chain, *solved_.joints, view_.section_axes(), options_, solved_.work) {
    auto& work = solved_.work;
    const auto& chain = solved_.build.chain;
    chain::place<false>(chain, work.q, 0.0, work.placement);
    if (!clamped) {
      work.q.open[0] = true;
      work.q.pose[0] = {work.placement.position[0], work.placement.frame[0]};
    }
    std::vector<solve::SegmentMotion<L>> motion(kSchemeSegments);
    typename L::Point velocity{};  // of the segment's inner end
    for (std::size_t i = 0; i < kSchemeSegments; ++i) {
      const auto& frame = work.placement.frame[i];
      const auto w = spin_of((static_cast<double>(i) + 0.5) / kSchemeSegments);
      const auto spin = view_.spin({{w[0], w[1], w[2]}});
      motion[i].velocity = velocity + L::spun(spin, L::rotate(frame, chain.inertias[i].center));
      motion[i].spin = transposed_times(L::axes(frame), spin);
      velocity += L::spun(spin, L::rotate(frame, chain.segments[i].arm));
    }
    EXPECT_TRUE(step_.start(motion));
  }

  void take(double h) {
    EXPECT_TRUE(step_.attempt(h));
    most_solves_ = std::max(most_solves_, step_.iterations());
    step_.accept();
  }

  double energy() const {
    double sum = step_.kinetic();
    for (const double stored : solved_.joints->elastic_energy()) sum += stored;
    return sum;
  }
  /// Appends where the joints and the tip are.
  void note_places(std::vector<double>& places) const {
    for (const auto& position : step_.begin().position) {
      places.insert(places.end(), position.at.begin(), position.at.end());
    }
    const auto tip = solved_.tip();
    places.insert(places.end(), tip.at.begin(), tip.at.end());
  }
  struct Momenta {
    typename L::Point linear{};
    typename L::Spin angular{};
    double size = 0.0;          ///< sum of |p|
    double angular_size = 0.0;  ///< sum of |r x p|
  };
  Momenta momenta() const {
    Momenta sum;
    for (std::size_t i = 0; i < kSchemeSegments; ++i) {
      const auto& inertia = solved_.build.chain.inertias[i];
      const auto& motion = step_.motions()[i];
      const auto p = inertia.mass * motion.velocity;
      const auto turning = L::moment(step_.begin().point(i, inertia.center), p);
      sum.linear += p;
      sum.angular +=
          turning + solve::angular_momentum(inertia, step_.begin().frame[i], motion.spin);
      sum.size += size_of(p);
      sum.angular_size += size_of(turning);
    }
    return sum;
  }
  int most_solves() const { return most_solves_; }

 private:
  chain::View<L> view_{};
  testing::SolvedChain<L, false, Law> solved_;
  solve::MotionOptions options_;
  solve::MotionStep<L, false> step_;
  int most_solves_ = 0;
};

/// What a scheme does.
struct Measured {
  double order = 0.0;             ///< in the time step, of all places over the swing
  int most_solves = 0;            ///< factorizations in a step of the smooth swing
  double energy_order = 0.0;      ///< of the energy's drift
  double energy_drift = 0.0;      ///< with coarse steps, over the energy
  double high_energy_left = 0.0;  ///< of energy with steps that nothing can follow
  double momentum_drift = 0.0;    ///< of both momenta, over the sums of their sizes
  double missed_start = 0.0;      ///< after a swing and its way back [m]
};

/// Bends the clamped bar smoothly, to slopes of half a radian; in space it twists, too.
std::array<double, 3> smooth_spin(double place) {
  const double shape = std::sin(0.5 * pi * place);
  return {6.0 * shape, 4.0 * shape, 3.0 * shape};
}
std::array<double, 3> tumbling_spin(double place) {
  const double shape = std::cos(pi * place);
  return {2.0 + 6.0 * shape, 1.0 + 4.0 * shape, 1.0 + 3.0 * shape};
}

constexpr double kSwing = 0.4;  ///< [s], more than half a period

struct Run {
  std::vector<double> places{};  ///< at ten times
  double energy_drift = 0.0;
  int most_solves = 0;
};

template <class L>
Run run_swing(Scheme scheme, double rho_infinity, int steps) {
  Swing<L> swing(scheme, rho_infinity, true, smooth_spin);
  const double energy = swing.energy();
  Run run;
  for (int k = 1; k <= steps; ++k) {
    swing.take(kSwing / steps);
    run.energy_drift = std::max(run.energy_drift, std::abs(swing.energy() / energy - 1.0));
    if (k % (steps / 10) == 0) swing.note_places(run.places);
  }
  run.most_solves = swing.most_solves();
  return run;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Energy left of a little swing after a hundred steps that all of its frequencies outrun.
template <class L>
double high_energy_left(Scheme scheme, double rho_infinity) {
  Scene scene = bar(true);
  scene.gravity = {0.0, -9.81, 0.0};
  const double lowest = unloaded_frequencies(prepare(scene, {.level = Level::Planar}), 1)[0];
  const double step = 3.0 / (2.0 * pi * lowest);
  Swing<L> swing(scheme, rho_infinity, true, [](double place) {
    return std::array<double, 3>{1e-4 * std::cos(pi * (kSchemeSegments * place - 0.5)), 0.0, 0.0};
  });
  const double energy = swing.energy();
  for (int k = 0; k < 100; ++k) swing.take(step);
  return swing.energy() / energy;
}

template <class L>
Measured measure(Scheme scheme, double rho_infinity) {
  Measured measured;
  const auto run = [&](int steps) { return run_swing<L>(scheme, rho_infinity, steps); };
  const Run coarse = run(1600);
  const Run middle = run(3200);
  const Run fine = run(6400);
  measured.order =
      std::log2(distance(coarse.places, middle.places) / distance(middle.places, fine.places));
  measured.energy_order = std::log2(coarse.energy_drift / middle.energy_drift);
  measured.energy_drift = run(100).energy_drift;
  measured.most_solves = coarse.most_solves;
  measured.high_energy_left = high_energy_left<L>(scheme, rho_infinity);

  Swing<L> flight(scheme, rho_infinity, false, tumbling_spin);
  const auto before = flight.momenta();
  for (int k = 0; k < 400; ++k) {
    flight.take(1e-3);
    const auto now = flight.momenta();
    measured.momentum_drift =
        std::max({measured.momentum_drift, size_of(now.linear - before.linear) / before.size,
                  size_of(now.angular - before.angular) / before.angular_size});
  }

  Swing<L> there(scheme, rho_infinity, true, smooth_spin);
  std::vector<double> start, end;
  there.note_places(start);
  for (int k = 0; k < 100; ++k) there.take(2e-3);
  for (int k = 0; k < 100; ++k) there.take(-2e-3);
  there.note_places(end);
  measured.missed_start = distance(start, end);
  return measured;
}

/// The claims that what was measured does not bear out, by their names.
std::vector<std::string> broken_claims(const SchemeClaims& claims, const Measured& measured) {
  std::vector<std::string> broken;
  const auto claim = [&](const char* name, bool holds) {
    if (!holds) broken.emplace_back(name);
  };
  claim("order", measured.order >= claims.order - testing::tolerance(0.05));
  switch (claims.energy) {
    case EnergyBehaviour::Loses: claim("energy", measured.high_energy_left < 0.5); break;
    case EnergyBehaviour::Wanders:
      claim("energy", measured.high_energy_left > 0.99 &&
                          measured.energy_order >= claims.order - testing::tolerance(0.2));
      break;
    case EnergyBehaviour::Conserves:
      claim("energy",
            measured.high_energy_left > 0.99 && measured.energy_drift <= testing::tolerance(1e-8));
      break;
  }
  claim("momentum", !claims.momentum || measured.momentum_drift <= testing::tolerance(1e-10));
  claim("reversible", !claims.reversible || measured.missed_start <= testing::tolerance(1e-8));
  claim("one_solve", !claims.one_solve || measured.most_solves == 1);
  return broken;
}

struct SchemeCase {
  const char* name;
  Scheme scheme;
  double rho_infinity;
};

class MotionSchemes : public ::testing::TestWithParam<SchemeCase> {
 protected:
  static SchemeClaims claims() {
    return solve::claims_of(GetParam().scheme, GetParam().rho_infinity);
  }
  template <class L>
  static Measured measured() {
    return measure<L>(GetParam().scheme, GetParam().rho_infinity);
  }
};

TEST_P(MotionSchemes, KeepTheirClaimsInAPlane) {
  EXPECT_EQ(broken_claims(claims(), measured<chain::Planar<double>>()), std::vector<std::string>{});
}

TEST_P(MotionSchemes, KeepTheirClaimsInSpace) {
  EXPECT_EQ(broken_claims(claims(), measured<chain::Spatial<double>>()),
            std::vector<std::string>{});
}

/// Each claim in turn replaced by one that is better than the scheme, or another.
TEST_P(MotionSchemes, AreCaughtAtFalseClaims) {
  const SchemeClaims truth = claims();
  const Measured done = measured<chain::Spatial<double>>();
  const auto caught = [&](const auto& boast_of) {
    SchemeClaims boast = truth;
    boast_of(boast);
    return broken_claims(boast, done);
  };
  const auto only = [](const char* name) { return std::vector<std::string>{name}; };
  // An energy that wanders does so by the order that is claimed: its claim falls, too.
  EXPECT_EQ(caught([](SchemeClaims& boast) { ++boast.order; }).front(), "order");
  for (const EnergyBehaviour energy :
       {EnergyBehaviour::Loses, EnergyBehaviour::Wanders, EnergyBehaviour::Conserves}) {
    if (energy == truth.energy) continue;
    EXPECT_EQ(caught([&](SchemeClaims& boast) { boast.energy = energy; }), only("energy"));
  }
  if (!truth.momentum) {
    EXPECT_EQ(caught([](SchemeClaims& boast) { boast.momentum = true; }), only("momentum"));
  }
  if (!truth.reversible) {
    EXPECT_EQ(caught([](SchemeClaims& boast) { boast.reversible = true; }), only("reversible"));
  }
  if (!truth.one_solve) {
    EXPECT_EQ(caught([](SchemeClaims& boast) { boast.one_solve = true; }), only("one_solve"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, MotionSchemes,
    ::testing::Values(SchemeCase{"LinearlyImplicitEuler", Scheme::LinearlyImplicitEuler, 0.8},
                      SchemeCase{"LinearlyImplicitMidpoint", Scheme::LinearlyImplicitMidpoint, 0.8},
                      SchemeCase{"GeneralizedAlpha00", Scheme::GeneralizedAlpha, 0.0},
                      SchemeCase{"GeneralizedAlpha08", Scheme::GeneralizedAlpha, 0.8},
                      SchemeCase{"GeneralizedAlpha10", Scheme::GeneralizedAlpha, 1.0},
                      SchemeCase{"EnergyMomentum", Scheme::EnergyMomentum, 0.8}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace plastica
