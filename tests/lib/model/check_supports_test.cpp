#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using testing::curve;
using testing::error_of;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

void add_support(Scene& scene, Place at, SupportKind kind) { scene.supports.push_back({at, kind}); }

TEST(CheckSupports, RefusePlacesOffTheBeam) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {1.2, {}}, SupportKind::Roller);
            }),
            "support[2].at = 1.2: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.0, -1}, SupportKind::Roller);
            }),
            "support[2].at = { segment = -1 }: must be a segment from 1 to 8, or 0 for the start");
}

TEST(CheckSupports, MoveAnInclinedRollerAlongItsNormal) {
  const auto moved = [](const std::array<double, 3>& displacement) {
    return error_of([&](Scene& s) {
      Support roller{.at = Place::end(), .kind = SupportKind::InclinedRoller};
      roller.normal = {0.0, 0.6, 0.8};
      roller.translation = displacement;
      s.supports.push_back(roller);
    });
  };
  EXPECT_EQ(moved({0.0, 0.004, -0.003}),
            "support[2].translation = 0.005: goes across the normal, along which alone the support "
            "holds");
  EXPECT_EQ(moved({0.0, 0.004, 0.0}), "no error");
}

TEST(CheckSupports, HoldRotationsAtSegmentEndsAlone) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segment_fractions.assign(8, 0.125);
              add_support(s, {0.3, {}}, SupportKind::Clamp);
            }),
            "support[2].at = 0.3: a clamp that holds rotation (rx) must be at a segment's end; the "
            "nearest are 0.25 and 0.375");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segment_fractions.assign(8, 0.125);
              add_support(s, {0.3, {}}, SupportKind::Pin);
            }),
            "support[2].at = 0.3: a pin that holds rotation (rz) must be at a segment's end; the "
            "nearest are 0.25 and 0.375");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segment_fractions.assign(8, 0.125);
              add_support(s, {0.3, {}}, SupportKind::Roller);
            }),
            "no error");
  // A segment ends at a support unless the scene sets the lengths.
  EXPECT_EQ(error_of([](Scene& s) { add_support(s, {0.3, {}}, SupportKind::Clamp); }), "no error");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.375, {}}, SupportKind::Clamp);
            }),
            "no error");
}

TEST(CheckSupports, HoldOrSpringOrPushButOneOfThese) {
  const auto elastic = [](std::array<double, 3> stiffness, std::optional<HeldFreedoms> hold = {}) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Elastic);
      s.supports[1].stiffness = stiffness;
      s.supports[1].hold = hold;
    });
  };
  EXPECT_EQ(elastic({0.0, 1e3, 0.0}), "no error");
  EXPECT_EQ(elastic({0.0, -1e3, 0.0}), "support[2].stiffness = -1000: must be at least 0");
  EXPECT_EQ(elastic({}), "support[2]: an elastic support needs stiffness or rotational_stiffness");
  EXPECT_EQ(elastic({0.0, 1e3, 0.0}, HeldFreedoms{false, true}),
            "support[2].hold = y: has a spring, too");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].rotational_stiffness[0] = 1.0; }),
            "support[1].rotational_stiffness: belongs to kind = \"elastic\"");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].hold = HeldFreedoms{}; }),
            "support[1].hold = []: must hold something");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].gap = 0.1; }),
            "support[1].gap = 0.1: belongs to kind = \"pillar\"");
}

TEST(CheckSupports, ArePillarsOnlyIfTheyPush) {
  const auto pillar = [](const std::function<void(Support&)>& spoil) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Pillar);
      spoil(s.supports[1]);
    });
  };
  EXPECT_EQ(pillar([](Support&) {}), "no error");
  EXPECT_EQ(pillar([](Support& p) { p.gap = -0.1; }), "support[2].gap = -0.1: must be at least 0");
  EXPECT_EQ(pillar([](Support& p) {
              p.normal = {0.0, 2.0, 0.0};
            }),
            "support[2].normal = 2: is the vector's size and must be 1");
  EXPECT_EQ(pillar([](Support& p) { p.hold = HeldFreedoms{true}; }),
            "support[2].hold: a pillar only pushes; what holds is another support");
  EXPECT_EQ(pillar([](Support& p) { p.translation[1] = 0.1; }), "no error");
  EXPECT_EQ(pillar([](Support& p) { p.translation[0] = 0.1; }),
            "support[2].translation = 0.1: moves x, which the support does not hold");
}

TEST(CheckSupports, MoveWhatTheyHold) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, Place::end(), SupportKind::Roller);
              s.supports[1].rotation[0] = 0.2;
            }),
            "support[2].rotation = 0.2: moves rx, which the support does not hold");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, Place::end(), SupportKind::Elastic);
              s.supports[1].stiffness[1] = 1e3;
              s.supports[1].translation[1] = 0.1;
            }),
            "no error");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].translation[0] = kNoNumber; }),
            "support[1].translation = nan: must be finite");
  EXPECT_EQ(error_of([](Scene& s) {
              s.supports[0].translation[1] = 0.1;
              s.supports[0].history = {{0.0, 2.0, 2.0}, {0.0, 1.0, 0.0}};
            }),
            "support[1].history.time = 2: must rise from one to the next");
}

TEST(CheckSupports, ShareAPlaceIfEachTakesFreedomsOfItsOwn) {
  EXPECT_EQ(
      error_of([](Scene& s) {
        add_support(s, {0.0, 0}, SupportKind::Roller);
      }),
      "support[2].at = start: support[1] holds the start, too: one support takes all that is held "
      "there");
  EXPECT_EQ(error_of([](Scene& s) {
              s.supports[0].hold = HeldFreedoms{false, false, true, true, true, true};
              add_support(s, Place::start(), SupportKind::Pillar);
            }),
            "no error");
  const auto at_the_end = [](HeldFreedoms first, HeldFreedoms second) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Roller);
      add_support(s, {0.0, 8}, SupportKind::Roller);
      s.supports[1].hold = first;
      s.supports[2].hold = second;
    });
  };
  EXPECT_EQ(at_the_end({false, true}, {true}), "no error");
  EXPECT_EQ(at_the_end({false, true}, {true, true}),
            "support[3].at = { segment = 8 }: support[2] holds y at the same place");
  const auto pillars = [](double second) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Pillar);
      add_support(s, Place::end(), SupportKind::Pillar);
      s.supports[2].normal[1] = second;
    });
  };
  EXPECT_EQ(pillars(-1.0), "no error");
  EXPECT_EQ(pillars(1.0), "support[3].at = end: support[2] holds y at the same place");
}

/// Supports that leave the beam a freedom.
std::string free_by(std::vector<Support> supports, std::array<double, 3> force) {
  return error_of([&](Scene& s) {
    s.supports = std::move(supports);
    s.loads[0].force = force;
  });
}

std::string free_to(const std::string& motion, const std::string& level) {
  return "support: the supports together leave the beam free to " + motion + " (level " + level +
         ")";
}

TEST(FreeMotion, IsNamedInThePlane) {
  const std::array<double, 3> down{0.0, -1.0, 0.0};
  const Support pin{Place::start(), SupportKind::Pin};
  const Support roller{Place::end(), SupportKind::Roller};
  EXPECT_EQ(free_by({pin, roller}, down), "no error");
  EXPECT_EQ(free_by({pin}, down), free_to("rotate about x", "planar"));
  EXPECT_EQ(free_by({roller}, down), free_to("move along z", "planar"));
  EXPECT_EQ(free_by({{Place::start(), SupportKind::Roller}, roller}, down),
            free_to("move along z", "planar"));
  EXPECT_EQ(
      free_by({{Place::start(), SupportKind::Pillar}, {Place::end(), SupportKind::Pillar}}, down),
      free_to("move along z", "planar"));
  EXPECT_EQ(free_by({{Place::start(), SupportKind::Guide}}, down),
            free_to("move along y", "planar"));
  EXPECT_EQ(free_by({pin}, {1.0, 0.0, 0.0}), free_to("rotate about y", "planar"));
}

TEST(FreeMotion, IsNamedInSpaceAndInTwist) {
  const Support pin{Place::start(), SupportKind::Pin};
  const Support roller{Place::end(), SupportKind::Roller};
  const std::array<double, 3> skew{1.0, 1.0, 0.0};
  EXPECT_EQ(free_by({pin, roller}, skew), "no error");
  Support no_fork = pin;
  no_fork.hold = HeldFreedoms{true, true, true};
  EXPECT_EQ(free_by({no_fork, roller}, skew), free_to("rotate about z", "spatial"));
  Support one_way = roller;
  one_way.hold = HeldFreedoms{false, true};
  EXPECT_EQ(free_by({pin, one_way}, skew), free_to("rotate about y", "spatial"));
  EXPECT_EQ(error_of([&](Scene& s) {
              s.supports = {no_fork};
              s.loads[0].force = {};
              s.loads[0].moment = {0.0, 0.0, 1.0};
            }),
            free_to("rotate about z", "twist"));
}

TEST(FreeMotion, KnowsSpringsAndTheShapeOfTheBeam) {
  const std::array<double, 3> down{0.0, -1.0, 0.0};
  Support spring{Place::end(), SupportKind::Elastic};
  spring.stiffness = {0.0, 1.0, 0.0};
  const Support pin{Place::start(), SupportKind::Pin};
  EXPECT_EQ(free_by({pin, spring}, down), "no error");
  spring.stiffness = {0.0, 0.0, 1.0};
  EXPECT_EQ(free_by({pin, spring}, down), free_to("rotate about x", "planar"));
  // The same spring along z holds a beam that rises to its side.
  EXPECT_EQ(error_of([&](Scene& s) {
              s.supports = {pin, spring};
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.6, 0.8}});
            }),
            "no error");
}

}  // namespace
}  // namespace plastica
