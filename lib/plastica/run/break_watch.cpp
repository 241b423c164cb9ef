#include "plastica/run/break_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/law/break_criterion.hpp"
#include "plastica/model/hardening_kind.hpp"

namespace plastica {
namespace {

constexpr std::size_t kFibre = 3;  // of the strains that have limits
constexpr std::array<BreakCause, 3> kCauses{BreakCause::BendingX, BreakCause::BendingY,
                                            BreakCause::Torsion};

/// How large a strain is against its limit.
double over_limit(double strain, double limit) { return std::isinf(limit) ? 0.0 : strain / limit; }

JointFlow times(double factor, JointFlow angles) {
  for (double& angle : angles) angle *= factor;
  return angles;
}

bool has_limit(const Material& material) {
  return material.break_strain || material.break_shear_strain;
}

}  // namespace

bool has_break_limits(const Scene& scene) {
  return has_limit(scene.material) || scene.break_limit_x || scene.break_limit_y ||
         scene.break_limit_z || std::ranges::any_of(scene.regions, [](const Region& region) {
           return has_limit(region.material);
         });
}

Localization localization_of(const Scene& scene) {
  const Hardening& hardening = scene.material.hardening;
  switch (hardening_kind(hardening.law).growth(hardening)) {
    case HardeningGrowth::None: break;
    case HardeningGrowth::Saturates: return Localization::Saturating;
    case HardeningGrowth::Goes: return Localization::Distributed;
  }
  return scene.yield_model == YieldModel::Fibre ? Localization::Saturating
                                                : Localization::Concentrated;
}

BreakWatch::BreakWatch(const Scene& scene, std::vector<chain::JointModel> joints)
    : joints_(std::move(joints)),
      localization_(localization_of(scene)),
      report_(scene.formulas == Formulas::Report),
      accumulated_(scene.break_measure == BreakMeasure::Accumulated) {
  for (const chain::JointModel& joint : joints_) {
    hinge_.push_back(chain::hinge_lengths(scene, joint));
    for (std::size_t k = 0; k < same_hinges_.size(); ++k) {
      same_hinges_[k] = same_hinges_[k] && hinge_.back()[k] == hinge_.front()[k];
    }
  }
  for (Sliding& sliding : sliding_) sliding.covered.resize(joints_.size());
  for (chain::JointModel& joint : joints_) {
    joint.length[kStretch] = joint.own_length();
    for (const double limit : joint.limit) active_ = active_ || std::isfinite(limit);
  }
}

double BreakWatch::Window::covers(const chain::JointModel& joint) const {
  return (std::min(high, joint.end) - std::max(low, joint.begin)) / (joint.end - joint.begin);
}

BreakWatch::Window BreakWatch::window_of(std::size_t joint, std::size_t axis) const {
  const double beam = joints_.back().end;
  const double middle = 0.5 * (joints_[joint].begin + joints_[joint].end);
  const double length = hinge_[joint][axis];
  const double low = std::max(0.0, std::min(middle - 0.5 * length, beam - length));
  return {low, low + length};
}

BreakWatch::Hinge BreakWatch::spread(const JointFlow& flow, std::size_t joint) const {
  Hinge theta;
  const auto over = [&](std::size_t k, std::size_t axis) {
    return flow[k] * (strained_length(joint, axis) / joints_[joint].length[k]);
  };
  for (std::size_t k = 0; k < 3; ++k) theta.angle[k] = over(k, k);
  for (std::size_t axis = 0; axis < 2; ++axis) theta.stretch[axis] = over(kStretch, axis);
  return theta;
}

BreakWatch::Hinge BreakWatch::hinge_of(const std::vector<JointFlow>& angles, std::size_t joint) {
  const std::array<double, 3>& hinge = hinge_[joint];
  if (hinge[0] == 0.0 || localization_ == Localization::Distributed) {
    return spread(angles[joint], joint);
  }
  const chain::JointModel& at = joints_[joint];
  Hinge theta;
  JointFlow sum{};       // over the last window
  double summed = -1.0;  // its length
  for (std::size_t k = 0; k < 3; ++k) {
    if (!at.resists[k]) continue;
    if (at.length[k] < hinge[k]) {
      if (hinge[k] != summed) {
        sum = over_window(angles, joint, k);
        summed = hinge[k];
      }
      theta.angle[k] = sum[k];
    } else {
      theta.angle[k] = localization_ == Localization::Concentrated
                           ? concentrated(angles, joint, k, hinge[k])
                           : angles[joint][k] * (hinge[k] / at.length[k]);
    }
  }
  // A free end has no joint, and its window holds its neighbours'.
  if (!any_stretch_ || at.joint == chain::JointModel::kNone) return theta;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    theta.stretch[axis] = stretch_over(angles, joint, axis);
  }
  return theta;
}

double BreakWatch::stretch_over(const std::vector<JointFlow>& angles, std::size_t joint,
                                std::size_t axis) {
  const double hinge = hinge_[joint][axis];
  const double length = joints_[joint].length[kStretch];
  if (length < hinge) return over_window(angles, joint, axis)[kStretch];
  return localization_ == Localization::Concentrated ? concentrated(angles, joint, kStretch, hinge)
                                                     : angles[joint][kStretch] * (hinge / length);
}

JointFlow BreakWatch::lone_window(const std::vector<JointFlow>& angles, std::size_t joint,
                                  std::size_t axis) const {
  const Window window = window_of(joint, axis);
  const auto first = std::upper_bound(
      joints_.begin(), joints_.end(), window.low,
      [](double low, const chain::JointModel& watched) { return low < watched.end; });
  JointFlow sum{};
  for (auto at = first; at != joints_.end() && at->begin < window.high; ++at) {
    const auto j = static_cast<std::size_t>(at - joints_.begin());
    const double fraction = std::clamp(window.covers(*at), 0.0, 1.0);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += fraction * angles[j][k];
  }
  return sum;
}

JointFlow BreakWatch::windowed(const std::vector<JointFlow>& angles, std::size_t joint,
                               std::size_t axis) {
  const Window window = window_of(joint, axis);
  auto& [covered, first, end] = sliding_[axis];
  while (first + 1 < joints_.size() && joints_[first].end <= window.low) ++first;
  end = std::max(end, first + 1);
  while (end < joints_.size() && joints_[end].begin < window.high) ++end;
  // All but the first and the last are covered whole.
  const std::size_t last = end - 1;
  JointFlow sum = covered.over(first + 1, std::max(first + 1, last));
  const auto add = [&](std::size_t j) {
    const JointFlow part = times(window.covers(joints_[j]), angles[j]);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
  };
  add(first);
  if (last > first) add(last);
  return sum;
}

double BreakWatch::concentrated(const std::vector<JointFlow>& angles, std::size_t joint,
                                std::size_t k, double hinge) const {
  const double length = joints_[joint].length[k];
  const double own = angles[joint][k];
  double shared = 0.0;
  const auto look_at = [&](std::size_t neighbour) {
    const double rotation = angles[neighbour][k] * length / joints_[neighbour].length[k];
    if (rotation * own > 0.0) shared = std::max(shared, std::fabs(rotation));
  };
  if (joint > 0) look_at(joint - 1);
  if (joint + 1 < joints_.size()) look_at(joint + 1);
  shared = std::copysign(std::min(shared, std::fabs(own)), own);
  return shared * hinge / length + (own - shared);
}

BreakWatch::Strains BreakWatch::strains_of(const Hinge& theta, std::size_t joint) const {
  const chain::JointModel& at = joints_[joint];
  const auto length = [&](std::size_t axis) { return strained_length(joint, axis); };
  Strains all;
  std::array<double, 4>& strain = all.of;
  if (report_) {
    const auto bending = [&](std::size_t axis, double depth) {
      // Never an accumulated angle in the sine.
      return accumulated_ ? law::permanent_bending_strain(theta.angle[axis], depth, length(axis))
                          : law::report_bending_strain(theta.angle[axis], depth, length(axis));
    };
    strain[0] = bending(0, at.height);
    strain[1] = bending(1, at.width);
    strain[2] =
        law::report_torsion_strain(theta.angle[2], std::max(at.width, at.height), length(2));
    return all;
  }
  strain[0] = law::permanent_bending_strain(theta.angle[0], at.height, length(0));
  strain[1] = law::permanent_bending_strain(theta.angle[1], at.width, length(1));
  strain[2] = law::permanent_torsion_strain(theta.angle[2], at.lever[law::kTorsion], length(2));
  // By what each axis bends; of a trifle where none does.
  constexpr double kTrifle = 1e-6;
  const std::array<double, 2> stretch{law::permanent_stretch_strain(theta.stretch[0], length(0)),
                                      law::permanent_stretch_strain(theta.stretch[1], length(1))};
  const double bends = strain[0] + strain[1] + kTrifle;
  all.stretch =
      ((strain[0] + 0.5 * kTrifle) * stretch[0] + (strain[1] + 0.5 * kTrifle) * stretch[1]) / bends;
  // Of curvatures, each over the length of its own plane.
  const double by_x = theta.angle[0] / length(0), by_y = theta.angle[1] / length(1);
  const double both =
      at.round ? law::permanent_biaxial_strain_circle(by_x, by_y, 0.5 * at.height, 1.0)
               : law::permanent_biaxial_strain_rectangle(by_x, by_y, at.width, at.height, 1.0);
  strain[kFibre] = both + all.stretch;
  return all;
}

BreakCause BreakWatch::cause_of(const Strains& strain, std::size_t joint, std::size_t worst) const {
  if (worst == 2) return kCauses[worst];
  const double bending = worst == kFibre ? strain.of[kFibre] - strain.stretch : strain.of[worst];
  if (strain.stretch > bending) return BreakCause::Stretch;
  if (worst != kFibre) return kCauses[worst];
  // About one axis alone, up to rounding.
  constexpr double kHardly = 1e-9;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    const bool has_limit = std::isfinite(joints_[joint].limit[axis]);
    if (has_limit && strain.of[axis] >= (1.0 - kHardly) * bending) return kCauses[axis];
  }
  return BreakCause::Biaxial;
}

void BreakWatch::begin(const std::vector<JointFlow>& angles) {
  for (Sliding& sliding : sliding_) {
    sliding.covered.begin(angles);
    sliding.first = sliding.end = 0;
  }
  any_stretch_ =
      std::ranges::any_of(angles, [](const JointFlow& flow) { return flow[kStretch] != 0.0; });
}

template <class Use>
void BreakWatch::for_each_joint(const std::vector<JointFlow>& angles, const Use& use) {
  begin(angles);
  for (std::size_t j = 0; j < joints_.size(); ++j) use(j, strains_of(hinge_of(angles, j), j));
}

double BreakWatch::excess(const std::vector<JointFlow>& angles, const std::vector<bool>& left_out) {
  double largest = 0.0;
  for_each_joint(angles, [&](std::size_t j, const Strains& strain) {
    if (!left_out.empty() && left_out[j]) return;
    if (use_of(strain, j).of <= largest) return;
    largest = std::max(largest, own_use_of(strain, angles[j], j).of);
  });
  return largest - 1.0;
}

BreakWatch::LimitUse BreakWatch::use_of(const Strains& strain, std::size_t joint) const {
  LimitUse use;
  for (std::size_t k = 0; k < strain.of.size(); ++k) {
    const double of = over_limit(held(strain, k), joints_[joint].limit[k]);
    if (of > use.of) use = {of, k};
  }
  return use;
}

BreakWatch::LimitUse BreakWatch::own_use_of(const Strains& strain, const JointFlow& flow,
                                            std::size_t joint) const {
  const Strains own = own_strains(flow, joint);
  LimitUse use;
  for (std::size_t k = 0; k < strain.of.size(); ++k) {
    double counts = held(strain, k);
    if (has_window_of(joint, k)) counts = std::min(counts, held(own, k) / kOwnPart);
    const double of = over_limit(counts, joints_[joint].limit[k]);
    if (of > use.of) use = {of, k};
  }
  return use;
}

void BreakWatch::mark_hinges(const std::vector<JointFlow>& angles,
                             std::vector<BrokenJoint>& joints) const {
  std::vector<double> own;
  for (const BrokenJoint& joint : joints) {
    const auto j = static_cast<std::size_t>(joint.joint);
    own.push_back(use_of(own_strains(angles[j], j), j).of);
  }
  for (std::size_t a = 0; a < joints.size(); ++a) {
    const auto joint = static_cast<std::size_t>(joints[a].joint);
    const auto of = [&](std::size_t b) -> const chain::JointModel& {
      return joints_[static_cast<std::size_t>(joints[b].joint)];
    };
    const auto is_less = [&](std::size_t b) { return own[a] < (1.0 - kBreakTolerance) * own[b]; };
    joints[a].cut = true;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      if (hinge_[joint][0] == 0.0 || !has_window(joint, axis)) continue;
      const Window window = window_of(joint, axis);
      for (std::size_t b = a; b > 0 && of(b - 1).end > window.low; --b) {
        if (is_less(b - 1)) joints[a].cut = false;
      }
      for (std::size_t b = a + 1; b < joints.size() && of(b).begin < window.high; ++b) {
        if (is_less(b)) joints[a].cut = false;
      }
    }
  }
}

double BreakWatch::nearest_limit(const Strains& strains, std::size_t joint) const {
  const auto& limit = joints_[joint].limit;
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < strains.of.size(); ++k) {
    const double own = held(strains, k), of_nearest = held(strains, nearest);
    const double use = over_limit(own, limit[k]);
    const double before = over_limit(of_nearest, limit[nearest]);
    if (use > before || (use == before && own > of_nearest)) nearest = k;
  }
  return held(strains, nearest);
}

const std::vector<double>& BreakWatch::strains(NodeStrains& of) {
  if (!of.is_known_) {
    for_each_joint(measured(of), [&](std::size_t j, const Strains& all) {
      of.strain_[j] = nearest_limit(all, j);
    });
    of.is_known_ = true;
  }
  return of.strain_;
}

double BreakWatch::largest_strain(NodeStrains& of) {
  const std::vector<double>& all = strains(of);
  return *std::max_element(all.begin(), all.end());
}

std::array<double, 4> BreakWatch::strains_at(const std::vector<JointFlow>& angles,
                                             std::size_t joint) {
  begin(angles);
  Hinge theta;
  for (std::size_t j = 0; j <= joint; ++j) theta = hinge_of(angles, j);
  std::array<double, 4> strain = strains_of(theta, joint).of;
  if (report_) strain[kFibre] = std::max(strain[0], strain[1]);
  for (std::size_t k = 0; k < 3; ++k) strain[k] = std::copysign(strain[k], theta.angle[k]);
  return strain;
}

double BreakWatch::lone_strain(const JointFlow& angle, std::size_t joint) const {
  Hinge theta = spread(angle, joint);
  if (hinge_[joint][0] != 0.0 && localization_ != Localization::Distributed) {
    for (std::size_t k = 0; k < theta.angle.size(); ++k) {
      if (has_window(joint, k)) {
        theta.angle[k] = window_of(joint, k).covers(joints_[joint]) * angle[k];
      } else if (localization_ == Localization::Concentrated) {
        theta.angle[k] = angle[k];
      }
    }
  }
  return nearest_limit(strains_of(theta, joint), joint);
}

std::vector<BrokenJoint> BreakWatch::broken(const std::vector<JointFlow>& angles) {
  std::vector<BrokenJoint> joints;
  if (excess(angles) <= 0.0) return joints;
  for_each_joint(angles, [&](std::size_t j, const Strains& strain) {
    if (use_of(strain, j).of <= 1.0 - kBreakTolerance) return;
    const LimitUse use = own_use_of(strain, angles[j], j);
    if (use.of <= 1.0 - kBreakTolerance) return;
    BrokenJoint broken;
    broken.joint = static_cast<int>(j);
    broken.cause = cause_of(strain, j, use.worst);
    broken.strain = held(strain, use.worst);
    broken.limit = joints_[j].limit[use.worst];
    std::copy_n(angles[j].begin(), broken.angle.size(), broken.angle.begin());
    joints.push_back(broken);
  });
  mark_hinges(angles, joints);
  return joints;
}

}  // namespace plastica
