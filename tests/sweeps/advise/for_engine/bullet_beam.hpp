#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "calibrate/engine/engine_text.hpp"

namespace plastica::testing {

/// What acts in a step: world axes.
struct BulletStep {
  std::array<double, 3> gravity{};  ///< [m/s^2]
  std::array<double, 3> force{};    ///< [N]
  std::array<double, 3> moment{};   ///< [N m]
  std::array<double, 3> turned{};   ///< the ground, about the axes of the first joint [rad]
};

/// After a step.
struct BulletState {
  std::vector<double> coordinates;  ///< of the links
  std::array<double, 3> tip{};      ///< the outer end of the last segment [m]
};

/// A beam in Bullet itself: the header that is written for it is compiled with a program that runs
/// it (bullet_driver.cpp), in double precision.
class BulletBeam {
 public:
  explicit BulletBeam(const calibrate::EngineBeam& beam)
      : beam_(beam), folder_(::testing::TempDir() + unique_name()) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "beam.hpp")
        << calibrate::engine_text(beam, calibrate::EngineFormat::Bullet);
    run(fmt::format("{} -include {} -o {}", PLASTICA_BULLET_COMPILE, quoted(folder_ / "beam.hpp"),
                    quoted(folder_ / "driver")) +
        " " PLASTICA_BULLET_LIBRARIES);
  }
  ~BulletBeam() { std::filesystem::remove_all(folder_); }
  BulletBeam(const BulletBeam&) = delete;
  BulletBeam& operator=(const BulletBeam&) = delete;

  /// @param segment  that the force acts on
  /// @param along    its axis from the inner end [m]
  std::vector<BulletState> states(const std::vector<BulletStep>& steps, std::size_t segment,
                                  double along) const {
    {
      std::ofstream rows(folder_ / "rows");
      for (const BulletStep& step : steps) {
        rows << fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", fmt::join(step.gravity, " "),
                            fmt::join(step.force, " "), fmt::join(step.moment, " "),
                            fmt::join(step.turned, " "));
      }
    }
    const std::size_t last = beam_.segments.size() - 1;
    run(fmt::format("{} {} 0 0 {:.17g} 0 0 {:.17g} < {} > {}", quoted(folder_ / "driver"),
                    link_of(segment), along - center_of(segment),
                    length_of_chord(last) - center_of(last), quoted(folder_ / "rows"),
                    quoted(folder_ / "states")));
    std::ifstream file(folder_ / "states");
    std::vector<BulletState> states(steps.size());
    for (BulletState& state : states) {
      state.coordinates.resize(link_of(last) + 1);
      for (double& value : state.coordinates) file >> value;
      for (double& value : state.tip) file >> value;
    }
    EXPECT_TRUE(file) << "the program printed fewer states than steps";
    return states;
  }

 private:
  static std::string unique_name() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    return fmt::format("bullet_{}_{}_{}", test->test_suite_name(), test->name(), ++count);
  }
  static std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }
  static void run(const std::string& command) {
    ASSERT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT(concurrency-mt-unsafe)
  }

  double length_of_chord(std::size_t segment) const {
    const calibrate::EngineSegment& one = beam_.segments[segment];
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      square += (one.end[k] - one.start[k]) * (one.end[k] - one.start[k]);
    }
    return std::sqrt(square);
  }
  double center_of(std::size_t segment) const {
    return beam_.segments[segment].balance * length_of_chord(segment);
  }
  /// The last link of a segment: each freedom is one.
  std::size_t link_of(std::size_t segment) const {
    std::size_t links = 0;
    for (const calibrate::EngineJoint& joint : beam_.joints) {
      if (joint.child > segment) continue;
      std::size_t free = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!joint.holds[k]) ++free;
        if (joint.rotation[k] != calibrate::JointHold::Rigid) ++free;
      }
      links += std::max<std::size_t>(free, 1);
    }
    return links - 1;
  }

  calibrate::EngineBeam beam_;
  std::filesystem::path folder_;
};

}  // namespace plastica::testing
