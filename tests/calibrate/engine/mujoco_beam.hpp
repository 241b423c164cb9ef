#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "calibrate/engine/engine_text.hpp"
#include "plastica/io/scene_file.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"

namespace plastica::testing {

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

  /// How far the body of a support is from where it was put, at most [m].
  double support_drift() const {
    double drift = 0.0;
    for (const HeldBody& support : supports_) {
      const Pose now = pose_of(support.body);
      for (std::size_t k = 0; k < 3; ++k) {
        drift = std::max(drift, std::fabs(now[k] - support.pose[k]));
      }
    }
    return drift;
  }

  /// How far the last body is from the first [m].
  double reach() const {
    const Pose first = pose_of(1);
    const Pose last = pose_of(model_->nbody - 1);
    return std::hypot(last[0] - first[0], last[1] - first[1], last[2] - first[2]);
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

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double length_of(const Point& a) { return distance(a, {}); }

/// 1 m of 20 mm x 30 mm steel; nothing yields below some 750 N at the tip.
inline Scene bar(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.section.height = 0.03;
  return scene;
}

/// The beams of all shipped scenes that an export takes; hinges are refused.
inline std::vector<calibrate::EngineBeam> shipped_beams() {
  std::vector<calibrate::EngineBeam> beams;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const plastica::Setup setup = io::read_scene_file(entry.path()).setup;
    const bool hinged = std::ranges::any_of(setup.scene.supports, [](const Support& support) {
      return support.kind == SupportKind::Hinge;
    });
    if (setup.scene.is_coupon() || hinged) continue;
    beams.push_back(calibrate::engine_beam(setup.scene, setup.solver));
  }
  return beams;
}

}  // namespace plastica::testing
