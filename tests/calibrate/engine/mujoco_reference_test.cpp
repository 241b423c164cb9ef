#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "calibrate/engine/engine_text.hpp"
#include "plastica/io/scene_file.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"

namespace plastica::testing {
namespace {

using Point = std::array<double, 3>;

/// A beam in MuJoCo, read from what is exported for it.
class MujocoBeam {
 public:
  explicit MujocoBeam(const calibrate::EngineBeam& beam) {
    const std::string path = ::testing::TempDir() + "plastica_beam_" +
                             ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                             ".xml";
    std::ofstream(path) << calibrate::engine_text(beam, calibrate::EngineFormat::Mjcf);
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML(path.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    std::filesystem::remove(path);
    if (!model_) throw std::runtime_error(error.data());
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
    for (int i = 0; i < model_->nbody; ++i) {
      const std::string name = mj_id2name(model_.get(), mjOBJ_BODY, i);
      if (name.starts_with("support_")) supports_.push_back({i, pose_of(i)});
    }
  }

  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }

  int body(const std::string& name) {
    const int id = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
    if (id < 0) throw std::runtime_error(name);
    return id;
  }

  /// Where a point of a body is, given along its z axis.
  Point point(int body, double along) {
    Point at;
    for (int k = 0; k < 3; ++k) {
      at[static_cast<std::size_t>(k)] =
          data_->xpos[3 * body + k] + along * data_->xmat[9 * body + 3 * k + 2];
    }
    return at;
  }

  /// Newton's method on the balance of springs, supports and a dead load at a point.
  Point deflect(int body, double along, const Point& force) {
    const Point before = point(body, along);
    const int n = model_->nv;
    const int held = 6 * static_cast<int>(supports_.size());
    Eigen::VectorXd reaction = Eigen::VectorXd::Zero(held);
    const double size = std::hypot(force[0], force[1]);
    double left = size;
    for (int iteration = 0; iteration < 50 && left > 1e-9 * size; ++iteration) {
      const Eigen::VectorXd balance = residual(body, along, force, reaction);
      left = balance.norm();
      Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(n + held, n + held);
      tangent.topRightCorner(n, held) = support_jacobian().transpose();
      for (int i = 0; i < n; ++i) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, i);
        move(unit, 1e-6);
        const Eigen::VectorXd up = residual(body, along, force, reaction);
        move(unit, -2e-6);
        tangent.col(i) = (up - residual(body, along, force, reaction)) / 2e-6;
        move(unit, 1e-6);
      }
      const Eigen::VectorXd step = tangent.fullPivLu().solve(balance);
      move(step, -1.0);
      reaction -= step.tail(held);
    }
    EXPECT_LE(left, 1e-9 * size);
    mj_forward(model_.get(), data_.get());
    const Point after = point(body, along);
    return {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
  }

  /// Steps in time under a dead load.
  void step(int steps, int body, double along, const Point& force) {
    const Point none{};
    for (int i = 0; i < steps; ++i) {
      mju_zero(data_->qfrc_applied, model_->nv);
      const Point at = point(body, along);
      mj_applyFT(model_.get(), data_.get(), force.data(), none.data(), at.data(), body,
                 data_->qfrc_applied);
      mj_step(model_.get(), data_.get());
    }
    mj_forward(model_.get(), data_.get());
    for (const int bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
      EXPECT_EQ(data_->warning[bad].number, 0);
    }
  }

 private:
  using Pose = std::array<double, 7>;  ///< position, quaternion

  /// The body of a support, which is welded to the world.
  struct HeldBody {
    int body;
    Pose pose;
  };

  void move(const Eigen::VectorXd& step, double size) {
    mj_integratePos(model_.get(), data_->qpos, step.data(), size);
  }

  Pose pose_of(int body) const {
    Pose pose;
    std::copy_n(data_->xpos + 3 * body, 3, pose.begin());
    std::copy_n(data_->xquat + 4 * body, 4, pose.begin() + 3);
    return pose;
  }

  /// Of the poses of all supports, by the generalized coordinates.
  Eigen::MatrixXd support_jacobian() {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Rows jacobian(6 * static_cast<int>(supports_.size()), model_->nv);
    for (std::size_t s = 0; s < supports_.size(); ++s) {
      double* rows = jacobian.data() + 6 * static_cast<int>(s) * model_->nv;
      mj_jacBody(model_.get(), data_.get(), rows, rows + 3 * model_->nv, supports_[s].body);
    }
    return jacobian;
  }

  /// Generalized forces of springs, a dead load and reactions; then how far supports have moved.
  Eigen::VectorXd residual(int body, double along, const Point& force,
                           const Eigen::VectorXd& reaction) {
    mj_forward(model_.get(), data_.get());
    Eigen::VectorXd out = Eigen::VectorXd::Zero(model_->nv + reaction.size());
    const Point at = point(body, along);
    const Point none{};
    mj_applyFT(model_.get(), data_.get(), force.data(), none.data(), at.data(), body, out.data());
    for (int i = 0; i < model_->nv; ++i) out[i] += data_->qfrc_passive[i];
    if (supports_.empty()) return out;
    out.head(model_->nv) += support_jacobian().transpose() * reaction;
    for (std::size_t s = 0; s < supports_.size(); ++s) {
      const Pose pose = pose_of(supports_[s].body);
      double* moved = out.data() + model_->nv + 6 * static_cast<int>(s);
      for (std::size_t k = 0; k < 3; ++k) moved[k] = pose[k] - supports_[s].pose[k];
      // The turn in the world's axes: q = turn * before.
      std::array<double, 4> back{};
      std::array<double, 4> turn{};
      mju_negQuat(back.data(), supports_[s].pose.data() + 3);
      mju_mulQuat(turn.data(), pose.data() + 3, back.data());
      mju_quat2Vel(moved + 3, turn.data(), 1.0);
    }
    return out;
  }

  std::vector<HeldBody> supports_;
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data_{nullptr, mj_deleteData};
};

/// Deflection of our own beam at a place under a dead load there.
Point our_deflection(Scene scene, Place at, const Point& force) {
  scene.loads.push_back({.at = at, .force = force});
  for (const Component component : {Component::X, Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::Displacement, at, component);
  }
  const Response response = completed(scene);
  return {last_of(response, 0), last_of(response, 1), last_of(response, 2)};
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double length_of(const Point& a) { return distance(a, {}); }

/// 1 m of 20 mm x 30 mm steel; nothing yields below some 750 N at the tip.
Scene bar(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.section.height = 0.03;
  return scene;
}

/// How far MuJoCo's tip is from ours, over our deflection.
double tip_error(const Scene& scene, const Point& force) {
  MujocoBeam beam(beam_of(scene));
  const double last = scene.beam.length / scene.beam.segments;
  const int body = beam.body("segment_" + std::to_string(scene.beam.segments));
  const Point theirs = beam.deflect(body, last, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  ::testing::Test::RecordProperty("deflection_mm", std::to_string(1e3 * length_of(ours)));
  return distance(theirs, ours) / length_of(ours);
}

TEST(Mujoco, HasOurTipDeflectionInThePlane) {
  // One hinge of three turns: the same chain, to rounding.
  EXPECT_LT(tip_error(bar(32), {0.0, -400.0, 0.0}), 1e-8);
}

TEST(Mujoco, HasOurTipDeflectionInThePlaneWhereItBendsFar) {
  Scene scene = bar(32);
  scene.material.youngs_modulus = 2e9;
  EXPECT_LT(tip_error(scene, {0.0, -200.0, 0.0}), 1e-8);
}

TEST(Mujoco, HasOurTipDeflectionInSpaceWithinAPerCent) {
  // Three hinges in a row are a rotation vector up to products of their angles.
  const double error = tip_error(bar(32), {300.0, -400.0, 0.0});
  RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 1e-4);
}

TEST(Mujoco, HasOurDeflectionOfAnArc) {
  Scene scene = bar(32);
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.0;
  scene.beam.arc_towards = {1.0, 0.0, 0.0};
  // The chord of a segment is its z axis; 1.9e-6 is what is left of the hinges' products.
  const double chord = 2.0 * std::sin(0.5 / 32.0);
  const Point force{0.0, -1.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_32"), chord, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-5 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionBetweenTwoClamps) {
  Scene scene = bar(8);
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  const Point force{0.0, -4000.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_4"), 0.125, force);
  const Point ours = our_deflection(scene, {0.5, {}}, force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionOnARollerInsideOfASegment) {
  Scene scene = bar(8);
  scene.beam.segment_fractions.assign(8, 0.125);
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports.push_back({.at = {0.7, {}}, .kind = SupportKind::Roller});
  const Point force{0.0, -1000.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_8"), 0.125, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionOnBothSidesOfAClampInside) {
  Scene scene = bar(8);
  scene.supports[0].at = {0.5, {}};
  const Point force{0.0, -1000.0, 0.0};
  MujocoBeam beam(beam_of(scene));  // its start floats
  const Point theirs = beam.deflect(beam.body("segment_8"), 0.125, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, StepsASupportedBeamStably) {
  Scene scene = bar(8);
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = {{0.0}, {1.0}};  // from the beginning, as in MuJoCo
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  MujocoBeam beam(beam_of(scene));
  const int body = beam.body("segment_4");
  double lowest = 0.0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    beam.step(1, body, 0.125, {});
    lowest = std::min(lowest, beam.point(body, 0.125)[1]);
  }
  add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
  const Response ours = completed(scene, {.analysis = Analysis::Dynamics,
                                          .duration = kSteps * beam.model().opt.timestep,
                                          .steps = 1000,
                                          .scheme = Scheme::EnergyMomentum,
                                          .time_step = 2e-5});
  const double our_lowest = *std::min_element(ours.probes[0].begin(), ours.probes[0].end());
  EXPECT_NEAR(lowest, our_lowest, 0.01 * std::fabs(our_lowest));
}

TEST(Mujoco, StepsASteelBeamStably) {
  Scene scene = bar(32);
  scene.gravity = {0.0, -9.81, 0.0};
  MujocoBeam beam(beam_of(scene));
  EXPECT_EQ(beam.model().opt.timestep, 1e-3);
  const int body = beam.body("segment_32");
  beam.step(1500, body, 0.03125, {});
  // At rest under its weight: w L^4/8EI.
  const SectionProperties p = properties_of(scene);
  const double sag = 7850.0 * p.area * 9.81 / (8.0 * 200e9 * p.second_moment_x);
  EXPECT_NEAR(beam.point(body, 0.03125)[1], -sag, 0.01 * sag);
}

TEST(Mujoco, HoldsOurYieldMomentsAsNumbers) {
  const calibrate::EngineBeam numbers = beam_of(breakable_scene());
  MujocoBeam beam(numbers);
  const int id = mj_name2id(&beam.model(), mjOBJ_NUMERIC, "joint_0_x_yield_moment");
  ASSERT_GE(id, 0);
  EXPECT_EQ(beam.model().numeric_data[beam.model().numeric_adr[id]],
            numbers.joints[0].yield_moment[0]);
}

TEST(Mujoco, LoadsTheBeamOfEveryShippedScene) {
  int loaded = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename());
    const plastica::Setup setup = io::read_scene_file(entry.path()).setup;
    const bool hinged = std::ranges::any_of(setup.scene.supports, [](const Support& support) {
      return support.kind == SupportKind::Hinge;
    });
    if (setup.scene.is_coupon() || hinged) continue;  // hinges are refused: no export has them
    const calibrate::EngineBeam numbers = calibrate::engine_beam(setup.scene, setup.solver);
    if (numbers.segments.size() > 96) {  // too deep for MuJoCo 2, and said so
      const auto notes = calibrate::engine_notes(numbers, calibrate::EngineFormat::Mjcf);
      EXPECT_EQ(notes.back().substr(0, 8), "MuJoCo 2");
      continue;
    }
    MujocoBeam beam(numbers);
    const auto off_start = std::count_if(numbers.joints.begin(), numbers.joints.end(),
                                         [](const auto& joint) { return joint.off_start; });
    EXPECT_EQ(beam.model().nbody,
              1 + static_cast<int>(numbers.segments.size()) + static_cast<int>(off_start));
    ++loaded;
  }
  EXPECT_GE(loaded, 20);
}

}  // namespace
}  // namespace plastica::testing

#else

TEST(Mujoco, IsNotInstalled) {
  GTEST_SKIP()
      << "MuJoCo is not installed (apt-get install libmujoco-dev): what is exported for it "
         "was not loaded";
}

#endif
