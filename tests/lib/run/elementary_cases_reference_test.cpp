#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/theory/beam_cases.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Wendelius' validation proposal 2: elementary bending cases, by running each as a chain.
namespace plastica {
namespace {

using theory::BeamCase;
using theory::BeamEnds;
using theory::BeamLoad;

/// Loads so small that rotations are linear: a rotation changes a result by its square.
constexpr double kSize = 1e-4;

Scene framed(BeamEnds ends, int segments) {
  Scene scene = testing::chain_scene(segments);
  const auto start = ends == BeamEnds::PinnedPinned ? SupportKind::Pin : SupportKind::Clamp;
  scene.supports.push_back({.at = Place::start(), .kind = start});
  if (ends == BeamEnds::ClampedClamped) {
    scene.supports.push_back({.at = Place::end(),
                              .kind = SupportKind::Clamp,
                              .hold = HeldFreedoms{true, true, false, true, true, true}});
  } else if (ends != BeamEnds::ClampedFree) {
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  }
  return scene;
}

Scene chain_of(const BeamCase& beam, int segments) {
  Scene scene = framed(beam.ends, segments);
  const BeamLoad& q = beam.load;
  if (q.distributed != 0.0) {
    scene.loads.push_back(
        {.at = Place::start(), .to = Place::end(), .force = {0.0, q.distributed, 0.0}});
  } else {
    // A moment about -x turns z towards y.
    scene.loads.push_back({.at = Place{q.position, {}},
                           .force = {0.0, q.force, 0.0},
                           .moment = {-q.moment, 0.0, 0.0}});
  }
  return scene;
}

/// Largest difference of the chain's nodes from the closed form, over its largest deflection.
double shape_error(const BeamCase& beam, int segments) {
  const Scene scene = chain_of(beam, segments);
  const Response response = testing::completed(scene, {.steps = 1});
  const std::vector<double> ends = segment_ends(scene);
  double off = 0.0, largest = 0.0;
  for (int k = 0; k <= segments; ++k) {
    const double x = ends[static_cast<std::size_t>(k)];
    const double exact = theory::beam_deflection(beam, x);
    const auto at = testing::last_position(response, static_cast<std::size_t>(k));
    off = std::max(off, std::abs(at[1] - exact));
    largest = std::max(largest, std::abs(exact));
  }
  return off / largest;
}

struct Case {
  std::string name;
  BeamCase beam;
};

/// Point loads in the middle act on a node; if the number of segments is odd, the segments of both
/// halves differ.
std::vector<Case> cases() {
  const double EI = testing::bending_stiffness_of(testing::chain_scene(1));
  const double size = kSize * EI;
  const BeamLoad end_force{.position = 1.0, .force = size};
  const BeamLoad middle_force{.position = 0.5, .force = size};
  const BeamLoad end_moment{.position = 1.0, .moment = size};
  const BeamLoad middle_moment{.position = 0.5, .moment = size};
  const BeamLoad even{.distributed = size};
  const auto make = [&](const char* name, BeamEnds ends, const BeamLoad& load) {
    return Case{name, {.ends = ends, .length = 1.0, .bending_stiffness = EI, .load = load}};
  };
  return {make("cantilever, end force", BeamEnds::ClampedFree, end_force),
          make("cantilever, middle force", BeamEnds::ClampedFree, middle_force),
          make("cantilever, end moment", BeamEnds::ClampedFree, end_moment),
          make("cantilever, even load", BeamEnds::ClampedFree, even),
          make("simple, middle force", BeamEnds::PinnedPinned, middle_force),
          make("simple, end moment", BeamEnds::PinnedPinned, end_moment),
          make("simple, middle moment", BeamEnds::PinnedPinned, middle_moment),
          make("simple, even load", BeamEnds::PinnedPinned, even),
          make("propped, middle force", BeamEnds::ClampedPinned, middle_force),
          make("propped, end moment", BeamEnds::ClampedPinned, end_moment),
          make("propped, even load", BeamEnds::ClampedPinned, even),
          make("fixed, middle force", BeamEnds::ClampedClamped, middle_force),
          make("fixed, middle moment", BeamEnds::ClampedClamped, middle_moment),
          make("fixed, even load", BeamEnds::ClampedClamped, even)};
}

/// The order that is seen at least: under a moment at an end the end's half, strained half a
/// segment off, adds a term of third order.
double least_order(const BeamCase& beam) {
  return beam.load.moment != 0.0 && beam.load.position == 1.0 ? 1.9 : 1.95;
}

TEST(ElementaryCasesRun, ConvergeToTheClosedFormWithOrderTwo) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const double coarse = shape_error(c.beam, 31);
    const double fine = shape_error(c.beam, 93);  // three times as many, odd again
    // The curve of a moment in the middle of a fixed beam has four bends: sixteen times the error.
    EXPECT_LE(fine, testing::tolerance(0.002));
    if (coarse > 1e-9) {
      EXPECT_GE(std::log(coarse / fine) / std::log(3.0), least_order(c.beam));
    }
  }
}

TEST(ElementaryCasesRun, KeepTheOrderWithPointLoadsOnAJoint) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const double coarse = shape_error(c.beam, 32);
    const double fine = shape_error(c.beam, 64);
    if (coarse > 1e-9) {
      EXPECT_GE(std::log2(coarse / fine), least_order(c.beam));
    }
  }
}

TEST(ElementaryCasesRun, GiveTheReactionsAndMomentsOfTheClosedForm) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    constexpr int kSegments = 93;
    const Scene scene = chain_of(c.beam, kSegments);
    const Response response = testing::completed(scene, {.steps = 1});
    const std::vector<double> ends = segment_ends(scene);
    const theory::BeamReactions exact = theory::beam_reactions(c.beam);
    const auto reaction = [&](std::size_t support, std::size_t k) {
      const ChainHistory& chain = response.chain;
      return chain.reaction.at(((response.samples - 1) * chain.supports + support) * 6 + k);
    };
    const double near = testing::tolerance(5e-4 * kSize * c.beam.bending_stiffness);
    EXPECT_NEAR(reaction(0, 1), exact.start_force, near);
    EXPECT_NEAR(-reaction(0, 3), exact.start_moment, near);
    if (response.chain.supports > 1) {
      EXPECT_NEAR(reaction(1, 1), exact.end_force, near);
      EXPECT_NEAR(-reaction(1, 3), exact.end_moment, near);
    }
    for (int k = 1; k < kSegments; ++k) {
      const std::size_t at =
          ((response.samples - 1) * response.chain.joints + static_cast<std::size_t>(k)) * 3;
      const double x = ends[static_cast<std::size_t>(k)];
      // Where a moment acts the joint has the mean of both sides.
      if (c.beam.load.moment != 0.0 && x == c.beam.load.position) continue;
      EXPECT_NEAR(std::abs(response.chain.moment.at(at)), std::abs(theory::beam_moment(c.beam, x)),
                  near)
          << k;
    }
  }
}

}  // namespace
}  // namespace plastica
