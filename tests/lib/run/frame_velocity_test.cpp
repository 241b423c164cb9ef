#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Velocities of segments in the frames that a motion keeps.
namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;
using testing::motion_options;
using testing::tolerance;

using Vector = std::array<double, 3>;

constexpr std::array kComponents{Component::X, Component::Y, Component::Z};
constexpr std::array kGeneralSchemes{Scheme::LinearlyImplicitEuler,
                                     Scheme::LinearlyImplicitMidpoint, Scheme::GeneralizedAlpha,
                                     Scheme::EnergyMomentum};

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Rodrigues' formula.
Vector rotated(const Vector& by, const Vector& v) {
  const double angle = std::hypot(by[0], by[1], by[2]);
  if (angle == 0.0) return v;
  const Vector axis = sum({}, 1.0 / angle, by);
  const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  const Vector across = sum(sum({}, std::cos(angle), v), std::sin(angle), cross(axis, v));
  return sum(across, (1.0 - std::cos(angle)) * along, axis);
}

/// Row `index` of a frame that has `rows` of them.
Vector three(const std::vector<double>& values, std::size_t rows, std::size_t frame,
             std::size_t index) {
  const std::size_t at = 3 * (frame * rows + index);
  return {values.at(at), values.at(at + 1), values.at(at + 2)};
}

/// How a point of a straight beam's segment moves: v + omega x r.
/// @param part  of the segment's length [1]
Vector velocity_within(const Response& response, std::size_t frame, std::size_t segment,
                       double part, double length) {
  const ChainHistory& chain = response.chain;
  const std::size_t n = chain.joints - 1;
  const Vector arm = rotated(three(chain.rotation, n, frame, segment), {0.0, 0.0, part * length});
  return sum(three(chain.velocity, n, frame, segment), 1.0,
             cross(three(chain.spin, n, frame, segment), arm));
}

/// Adds probes of x, y and z. @return the first
std::size_t add_probes(Scene& scene, ProbeQuantity quantity, const Place& at) {
  for (const Component component : kComponents) add_probe(scene, quantity, at, component);
  return scene.probes.size() - kComponents.size();
}

void expect_near(const Response& response, std::size_t probe, std::size_t sample,
                 const Vector& value, double off) {
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(response.probes[probe + k][sample], value[k], off)
        << "probe " << probe + k << ", sample " << sample;
  }
}

/// Compares all frames of a motion with probes at nodes and within segments.
/// @param off  of a velocity, over the largest one [1]
void expect_those_of_probes(Scene scene, SolverOptions options, double off) {
  const auto n = static_cast<std::size_t>(scene.beam.segments);
  const double length = scene.beam.length / static_cast<double>(n);
  const bool stretches = options.translation == JointTranslation::Elastic;
  std::vector<std::size_t> at_node, within, spin;
  for (std::size_t i = 0; i <= n; ++i) {
    at_node.push_back(add_probes(scene, ProbeQuantity::Velocity, Place{0.0, static_cast<int>(i)}));
    if (i == n) break;
    const Place inside{(static_cast<double>(i) + 0.3) / static_cast<double>(n), {}};
    within.push_back(add_probes(scene, ProbeQuantity::Velocity, inside));
    // Between the parts over which the angles of its joints are spread.
    const Place middle{(static_cast<double>(i) + 0.5) / static_cast<double>(n), {}};
    spin.push_back(add_probes(scene, ProbeQuantity::Spin, middle));
  }
  options.frames = 0;
  const Response response = simulate(scene, options);
  ASSERT_TRUE(usable(response.status)) << name_of(response.status);
  ASSERT_EQ(response.chain.frame_sample.size(), response.samples);
  double fastest = 0.0;
  for (const double v : response.chain.velocity) fastest = std::max(fastest, std::fabs(v));
  EXPECT_GT(fastest, 0.1);
  const auto is_cut = [&](std::size_t joint, double time) {
    return std::ranges::any_of(response.chain.events, [&](const ChainBreak& event) {
      return event.time <= time && std::ranges::any_of(event.joints, [&](const BrokenJoint& one) {
               return one.cut && one.joint == static_cast<int>(joint);
             });
    });
  };
  for (std::size_t f = 0; f < response.samples; ++f) {
    // The start is the point itself.
    expect_near(response, at_node[0], f, three(response.chain.velocity, n, f, 0), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      Vector end = velocity_within(response, f, i, 1.0, length);
      if (stretches && i + 1 < n && !is_cut(i + 1, response.chain.time[f])) {
        // Both segments end apart. The node is between, as what gives way before it is to all: the
        // joints next to the ends give way for the ends' halves, too.
        const double part = i == 0 ? 2.0 / 3.0 : i + 2 == n ? 1.0 / 3.0 : 0.5;
        end = sum(sum({}, 1.0 - part, end), part, three(response.chain.velocity, n, f, i + 1));
      }
      expect_near(response, at_node[i + 1], f, end, tolerance(off * fastest));
      expect_near(response, within[i], f, velocity_within(response, f, i, 0.3, length),
                  tolerance(off * fastest));
      if (i == 0 || i + 1 == n) continue;  // all of an outer segment is of its joint
      expect_near(response, spin[i], f, three(response.chain.spin, n, f, i),
                  tolerance(off * fastest / length));
    }
  }
}

constexpr double kRounding = 1e-12;

TEST(FrameVelocities, AreThoseOfProbesInEveryScheme) {
  for (const Scheme scheme : kGeneralSchemes) {
    SCOPED_TRACE(static_cast<int>(scheme));
    for (const bool in_space : {false, true}) {
      expect_those_of_probes(testing::flying_scene(4, in_space), motion_options(scheme, 1e-3, 20),
                             kRounding);
    }
    expect_those_of_probes(testing::struck_scene(5, 20.0), motion_options(scheme, 1e-4, 30),
                           kRounding);
  }
  for (const Scheme scheme : {Scheme::ArticulatedEuler, Scheme::ArticulatedMidpoint}) {
    SCOPED_TRACE(static_cast<int>(scheme));
    expect_those_of_probes(testing::struck_scene(5, 2.0, YieldModel::Elastic),
                           motion_options(scheme, 1e-5, 30), kRounding);
  }
}

TEST(FrameVelocities, AreThoseOfProbesWhereJointsStretchAndShear) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    SCOPED_TRACE(static_cast<int>(scheme));
    SolverOptions options = motion_options(scheme, 2e-6, 30);
    options.translation = JointTranslation::Elastic;
    expect_those_of_probes(testing::struck_scene(4, 2.0, YieldModel::Elastic), options, kRounding);
  }
}

TEST(FrameVelocities, AreThoseOfProbesWithFloat) {
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 30);
  options.precision = Precision::Float;
  // A few units of the rounding of float, 6e-8, of a probe's sums.
  expect_those_of_probes(testing::struck_scene(5, 20.0), options, 1e-6);
}

TEST(FrameVelocities, AreThoseOfTheSampleAtAnImpact) {
  for (const Scheme scheme : kGeneralSchemes) {
    SCOPED_TRACE(static_cast<int>(scheme));
    Scene scene = testing::struck_scene(6, 5.0, YieldModel::Elastic);
    Support pillar{.at = Place::end(), .kind = SupportKind::Pillar};
    pillar.gap = 0.003;
    pillar.restitution = 0.5;
    scene.supports.push_back(pillar);
    const SolverOptions options = motion_options(scheme, 1e-4, 30);
    expect_those_of_probes(scene, options, kRounding);
    EXPECT_GT(testing::last_energy(simulate(scene, options)).impact, 0.0) << "it strikes";
  }
}

TEST(FrameVelocities, AreThoseOfEachFragment) {
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 60);
  options.frames = 0;
  const Scene scene = testing::breaking_scene(6, 60.0);
  EXPECT_EQ(simulate(scene, options).status, Status::Broken);
  expect_those_of_probes(scene, options, kRounding);
}

/// A rigid beam that flies and turns about its centre: v + omega x r, to the end.
TEST(FrameVelocities, OfARigidFlightAreExact) {
  for (const bool in_space : {false, true}) {
    Scene scene = testing::chain_scene(5);
    scene.material.density = 7850.0;
    scene.section.height = 0.03;
    InitialMotion all;
    all.about = {0.5, {}};
    all.velocity = {in_space ? 0.2 : 0.0, 0.3, 0.1};
    all.spin = {4.0, 0.0, 0.0};  // a principal axis: nothing bends
    scene.initial_motions = {all};
    SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-3, 100);
    options.frames = 20;
    const Response response = completed(scene, options);
    const ChainHistory& chain = response.chain;
    ASSERT_EQ(chain.velocity.size(), 21U * 5U * 3U);
    for (std::size_t f = 0; f < chain.frame_sample.size(); ++f) {
      const Vector center = sum({0.0, 0.0, 0.5}, chain.time[chain.frame_sample[f]], all.velocity);
      for (std::size_t i = 0; i < 5; ++i) {
        const Vector arm = sum(three(chain.position, 6, f, i), -1.0, center);
        const Vector exact = sum(all.velocity, 1.0, cross(all.spin, arm));
        const Vector velocity = three(chain.velocity, 5, f, i);
        const Vector spin = three(chain.spin, 5, f, i);
        for (std::size_t k = 0; k < 3; ++k) {
          // Newton's iterations leave 1e-11 of a step's moments.
          EXPECT_NEAR(velocity[k], exact[k], tolerance(1e-9)) << f << ' ' << i << ' ' << k;
          EXPECT_NEAR(spin[k], all.spin[k], tolerance(1e-8)) << f << ' ' << i << ' ' << k;
        }
      }
    }
  }
}

/// A rod that its clamp carries along its axis, without turning it.
Scene carried_rod(const History& history) {
  Scene scene = testing::cantilever_scene(2);
  scene.material.density = 7850.0;
  scene.supports[0].translation = {0.0, 0.0, 0.05};
  scene.supports[0].history = history;
  return scene;
}

TEST(FrameVelocities, OfWhatAClampCarriesAreItsOwn) {
  // 0.05 m in 20 ms, and then it stands.
  const Scene scene = carried_rod({{0.0, 0.02, 0.04}, {0.0, 1.0, 1.0}});
  for (const Scheme scheme : kGeneralSchemes) {
    SolverOptions options = motion_options(scheme, 1e-3, 40);
    options.frames = 0;
    const Response response = completed(scene, options);
    const ChainHistory& chain = response.chain;
    for (std::size_t f = 1; f < response.samples; ++f) {
      if (f == 20) continue;  // the corner, where a probe says which side counts
      for (std::size_t i = 0; i < 2; ++i) {
        const Vector velocity = three(chain.velocity, 2, f, i);
        const Vector spin = three(chain.spin, 2, f, i);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(velocity[k], k == 2 && f < 20 ? 2.5 : 0.0, tolerance(1e-9))
              << static_cast<int>(scheme) << ' ' << f << ' ' << i << ' ' << k;
          EXPECT_NEAR(spin[k], 0.0, tolerance(1e-9));
        }
      }
    }
    expect_those_of_probes(scene, options, kRounding);
  }
}

/// The largest error of a smooth clamp's speed, over its largest: 0.05 m 6 s (1 - s)/0.3 s.
double error_of_smooth_clamp(Scheme scheme, int steps) {
  SolverOptions options = motion_options(scheme, 0.2 / steps, steps);
  options.frames = 0;
  const Response response = completed(carried_rod(History::smooth_step(0.0, 0.3)), options);
  double largest = 0.0;
  for (std::size_t f = 0; f < response.samples; ++f) {
    const double s = response.chain.time[f] / 0.3;
    const double off = three(response.chain.velocity, 2, f, 0)[2] - s * (1.0 - s);
    largest = std::max(largest, std::fabs(off) / 0.25);
  }
  return largest;
}

TEST(FrameVelocities, FollowASmoothClamp) {
  for (const Scheme scheme : {Scheme::LinearlyImplicitMidpoint, Scheme::EnergyMomentum}) {
    // They take the clamp's own speed, a little before the sample's time.
    EXPECT_LT(error_of_smooth_clamp(scheme, 50), tolerance(1e-9)) << static_cast<int>(scheme);
  }
  const double coarse = error_of_smooth_clamp(Scheme::GeneralizedAlpha, 50);
  EXPECT_LT(coarse, tolerance(1e-3));
  EXPECT_NEAR(std::log2(coarse / error_of_smooth_clamp(Scheme::GeneralizedAlpha, 100)), 2.0,
              tolerance(0.1));
}

/// Differences of what the frames show over 2 h err by h^2 x'''/6: a quarter at half of h.
TEST(FrameVelocities, AreTheRatesOfWhatTheFramesShow) {
  Scene scene = testing::struck_scene(4, 2.0, YieldModel::Elastic);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  SolverOptions options = motion_options(Scheme::EnergyMomentum, 5e-5, 400);
  options.frames = 0;
  const Response response = completed(scene, options);
  const ChainHistory& chain = response.chain;
  const double length = 0.25;
  const auto error = [&](std::size_t h) {
    double velocities = 0.0, spins = 0.0;
    for (std::size_t f = 16; f + 16 < response.samples; ++f) {
      const double time = chain.time[f + h] - chain.time[f - h];
      for (std::size_t i = 0; i <= 4; ++i) {
        const Vector velocity =
            i < 4 ? three(chain.velocity, 4, f, i) : velocity_within(response, f, 3, 1.0, length);
        const Vector moved =
            sum(three(chain.position, 5, f + h, i), -1.0, three(chain.position, 5, f - h, i));
        for (std::size_t k = 0; k < 3; ++k) {
          velocities = std::max(velocities, std::fabs(moved[k] / time - velocity[k]));
        }
        if (i == 4) continue;
        const double turned =
            three(chain.rotation, 4, f + h, i)[0] - three(chain.rotation, 4, f - h, i)[0];
        spins = std::max(spins, std::fabs(turned / time - three(chain.spin, 4, f, i)[0]));
      }
    }
    return std::pair(velocities, spins);
  };
  const auto [coarse, coarse_spin] = error(16);
  const auto [fine, fine_spin] = error(8);
  EXPECT_LT(fine, 0.1);  // of 2 m/s
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, tolerance(0.1));
  EXPECT_NEAR(std::log2(coarse_spin / fine_spin), 2.0, tolerance(0.1));
}

TEST(FrameVelocities, AreNoneOfAPathAtRest) {
  Scene scene = testing::cantilever_scene(4);
  scene.loads.push_back({.at = Place::end(), .force = {0.0, -10.0, 0.0}});
  const Response response = completed(scene);
  EXPECT_FALSE(response.chain.rotation.empty());
  EXPECT_TRUE(response.chain.velocity.empty());
  EXPECT_TRUE(response.chain.spin.empty());
}

TEST(FrameVelocities, OfAMotionThatIsStoppedAreThoseOfItsLastSample) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::ArticulatedMidpoint}) {
    Scene scene = testing::struck_scene(5, 2.0, YieldModel::Elastic);
    add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
    const std::size_t probe = add_probes(scene, ProbeQuantity::Velocity, Place::start());
    const std::size_t spin = add_probes(scene, ProbeQuantity::Spin, {0.05, {}});
    SolverOptions options = motion_options(scheme, 1e-5, 40);
    options.frames = 2;
    const Model model = prepare(scene, options);
    Workspace workspace = make_workspace(model);
    workspace.on_progress = [](double time) { return time < 2.95e-4; };
    Response response = make_response(model);
    run(model, {}, workspace, response);
    ASSERT_EQ(response.status, Status::Interrupted);
    ASSERT_GT(response.samples, 21U);
    ASSERT_LT(response.samples, 41U);
    ASSERT_EQ(response.chain.frame_sample.at(2), response.samples - 1);
    for (const std::size_t f : {0U, 1U, 2U}) {
      const std::size_t sample = response.chain.frame_sample[f];
      expect_near(response, probe, sample, three(response.chain.velocity, 5, f, 0), 0.0);
      expect_near(response, spin, sample, three(response.chain.spin, 5, f, 0), 0.0);
    }
    EXPECT_NE(three(response.chain.spin, 5, 2, 4), three(response.chain.spin, 5, 1, 4));
  }
}

}  // namespace
}  // namespace plastica
