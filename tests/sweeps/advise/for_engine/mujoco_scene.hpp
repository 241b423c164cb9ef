#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/model/scene.hpp"
#include "tests/calibrate/engine/mujoco_beam.hpp"

namespace plastica::testing {

/// A scene in MuJoCo itself: its exported beam, with the scene's loads as a program of MuJoCo's
/// user sets them before each step. Knows nothing of how advice does that.
class MujocoScene {
 public:
  MujocoScene(const Scene& scene, const calibrate::EngineBeam& beam)
      : scene_(scene), beam_(beam), mujoco_(beam) {
    double end = 0.0;
    for (const calibrate::EngineSegment& segment : beam.segments) {
      ends_.push_back(end += segment.length / scene.beam.length);
    }
  }

  mjData& data() { return mujoco_.data(); }
  mjModel& model() { return mujoco_.model(); }
  double time_step() const { return beam_.time_step; }

  void step() {
    mjModel* model = &mujoco_.model();
    mjData* data = &mujoco_.data();
    const double time = steps_ * beam_.time_step;
    for (std::size_t k = 0; k < 3; ++k) {
      model->opt.gravity[k] = scene_.gravity[k] * scene_.gravity_history.at(time);
    }
    for (const Support& support : scene_.supports) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (support.rotation[k] == 0.0) continue;
        const std::string name = "joint_0_" + std::string(1, "xyz"[k]);
        const int joint = mj_name2id(model, mjOBJ_JOINT, name.c_str());
        model->qpos_spring[model->jnt_qposadr[joint]] =
            support.rotation[k] * support.history.at(time);
      }
    }
    mj_step1(model, data);
    mju_zero(data->qfrc_applied, model->nv);
    for (const Load& load : scene_.loads) apply(load, time);
    mj_step2(model, data);
    ++steps_;
    for (const int bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
      EXPECT_EQ(data->warning[bad].number, 0);
    }
  }

  /// Where a place of the beam is now [m].
  Point place(double fraction) {
    mj_kinematics(&mujoco_.model(), &mujoco_.data());
    const auto [segment, along] = find(fraction);
    return mujoco_.point(body_of(segment), along);
  }

  /// What MuJoCo has of a probe now: displacement alone.
  double displacement(const Probe& probe) {
    const auto [segment, along] = find(probe.at.fraction);
    const calibrate::EngineSegment& numbers = beam_.segments[segment];
    const Point now = place(probe.at.fraction);
    Point moved;
    for (std::size_t k = 0; k < 3; ++k) {
      moved[k] = now[k] - numbers.start[k] - along * numbers.axes[2][k];
    }
    if (probe.component == Component::Size) return length_of(moved);
    return moved[static_cast<std::size_t>(probe.component)];
  }

  /// Displacements at each sample of a motion (n_probes x n_samples).
  std::vector<std::vector<double>> run(int samples, int steps_of_a_sample) {
    std::vector<std::vector<double>> histories(scene_.probes.size());
    for (int sample = 0; sample <= samples; ++sample) {
      for (std::size_t k = 0; k < scene_.probes.size(); ++k) {
        histories[k].push_back(displacement(scene_.probes[k]));
      }
      for (int i = 0; sample < samples && i < steps_of_a_sample; ++i) step();
    }
    return histories;
  }

 private:
  struct PlaceOnSegment {
    std::size_t segment;
    double along;  ///< its z axis [m]
  };

  PlaceOnSegment find(double fraction) const {
    std::size_t i = 0;
    while (i + 1 < ends_.size() && fraction > ends_[i] + 1e-12) ++i;
    const double begin = i == 0 ? 0.0 : ends_[i - 1];
    const calibrate::EngineSegment& segment = beam_.segments[i];
    const double chord = distance(segment.start, segment.end);
    return {i, chord * (fraction - begin) / (ends_[i] - begin)};
  }

  int body_of(std::size_t segment) {
    return mujoco_.body("segment_" + std::to_string(segment + 1));
  }

  void apply(const Load& load, double time) {
    if (!load.to) {
      apply_at(load, time, load.at.fraction, 1.0);
      return;
    }
    double begin = 0.0;
    for (const double end : ends_) {
      const double from = std::max(begin, load.at.fraction);
      const double to = std::min(end, load.to->fraction);
      if (to > from) apply_at(load, time, 0.5 * (from + to), (to - from) * scene_.beam.length);
      begin = end;
    }
  }

  void apply_at(const Load& load, double time, double fraction, double weight) {
    const auto [segment, along] = find(fraction);
    const int body = body_of(segment);
    const double factor = weight * load.history.at(time);
    Point force;
    Point moment;
    for (std::size_t k = 0; k < 3; ++k) {
      force[k] = factor * load.force[k];
      moment[k] = factor * load.moment[k];
    }
    if (load.follows) {
      // Given in world axes of the undeformed beam, whose segments are along z here.
      const double* turn = mujoco_.data().xmat + 9 * body;
      mju_rotVecMat(force.data(), Point(force).data(), turn);
      mju_rotVecMat(moment.data(), Point(moment).data(), turn);
    }
    const Point at = mujoco_.point(body, along);
    mj_applyFT(&mujoco_.model(), &mujoco_.data(), force.data(), moment.data(), at.data(), body,
               mujoco_.data().qfrc_applied);
  }

  const Scene& scene_;
  const calibrate::EngineBeam& beam_;
  MujocoBeam mujoco_;
  std::vector<double> ends_;
  int steps_ = 0;
};

}  // namespace plastica::testing
