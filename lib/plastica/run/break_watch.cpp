#include "plastica/run/break_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/law/break_criterion.hpp"

namespace plastica {
namespace {

constexpr std::size_t kBoth = 3;
constexpr std::array<BreakCause, 4> kCauses{BreakCause::BendingX, BreakCause::BendingY,
                                            BreakCause::Torsion, BreakCause::Biaxial};

/// How large a strain is against its limit.
double use_of(double strain, double limit) { return std::isinf(limit) ? 0.0 : strain / limit; }

}  // namespace

BreakWatch::BreakWatch(const Scene& scene, std::vector<WatchedJoint> joints, bool gathers)
    : joints_(std::move(joints)),
      gathers_(gathers),
      report_(scene.formulas == Formulas::Report),
      accumulated_(scene.break_measure == BreakMeasure::Accumulated) {
  const bool round =
      scene.section.shape == SectionShape::Circle || scene.section.shape == SectionShape::RoundTube;
  const double depth = round ? 2.0 * scene.section.radius : scene.section.height;
  hinge_length_ = scene.hinge_length.value_or(report_ ? 0.0 : depth);
  for (const WatchedJoint& joint : joints_) {
    for (const double limit : joint.limit) active_ = active_ || std::isfinite(limit);
  }
}

JointAngles BreakWatch::windowed(const std::vector<JointAngles>& angles, std::size_t joint) const {
  const WatchedJoint& at = joints_[joint];
  if (hinge_length_ == 0.0 || (at.length >= hinge_length_ && gathers_)) return angles[joint];
  JointAngles sum{};
  if (at.length >= hinge_length_) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] = angles[joint][k] * hinge_length_ / at.length;
    return sum;
  }
  const double middle = 0.5 * (at.begin + at.end);
  const double low = middle - 0.5 * hinge_length_;
  const double high = middle + 0.5 * hinge_length_;
  const auto add = [&](std::size_t j) {
    const WatchedJoint& other = joints_[j];
    const double covered = std::min(high, other.end) - std::max(low, other.begin);
    if (covered <= 0.0) return false;
    const double share = covered / (other.end - other.begin);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += share * angles[j][k];
    return true;
  };
  add(joint);
  for (std::size_t j = joint; j-- > 0 && add(j);) {
  }
  for (std::size_t j = joint + 1; j < joints_.size() && add(j); ++j) {
  }
  return sum;
}

std::array<double, 4> BreakWatch::strains(const std::vector<JointAngles>& angles,
                                          std::size_t joint) const {
  const WatchedJoint& at = joints_[joint];
  const JointAngles theta = windowed(angles, joint);
  const double length = hinge_length_ == 0.0 ? at.length : hinge_length_;
  std::array<double, 4> strain{};
  if (report_) {
    const auto bending = [&](double angle, double depth) {
      // Never an accumulated angle in the sine.
      return accumulated_ ? law::permanent_bending_strain(angle, depth, length)
                          : law::report_bending_strain(angle, depth, length);
    };
    strain[0] = bending(theta[0], at.height);
    strain[1] = bending(theta[1], at.width);
    strain[2] = law::report_torsion_strain(theta[2], std::max(at.width, at.height), length);
    return strain;
  }
  strain[0] = law::permanent_bending_strain(theta[0], at.height, length);
  strain[1] = law::permanent_bending_strain(theta[1], at.width, length);
  strain[2] = law::permanent_torsion_strain(theta[2], at.shear_lever, length);
  strain[kBoth] =
      at.round ? law::permanent_biaxial_strain_circle(theta[0], theta[1], 0.5 * at.height, length)
               : law::permanent_biaxial_strain_rectangle(theta[0], theta[1], at.width, at.height,
                                                         length);
  return strain;
}

double BreakWatch::excess(const std::vector<JointAngles>& angles) const {
  double largest = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto strain = strains(angles, j);
    for (std::size_t k = 0; k < 4; ++k) {
      largest = std::max(largest, use_of(strain[k], joints_[j].limit[k]));
    }
  }
  return largest - 1.0;
}

double BreakWatch::strain(const std::vector<JointAngles>& angles, std::size_t joint) const {
  const auto strain = strains(angles, joint);
  const auto& limit = joints_[joint].limit;
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    const double use = use_of(strain[k], limit[k]);
    const double before = use_of(strain[nearest], limit[nearest]);
    if (use > before || (use == before && strain[k] > strain[nearest])) nearest = k;
  }
  return strain[nearest];
}

std::vector<BrokenJoint> BreakWatch::broken(const std::vector<JointAngles>& angles) const {
  std::vector<BrokenJoint> joints;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto strain = strains(angles, j);
    const auto& limit = joints_[j].limit;
    std::size_t worst = 0;
    for (std::size_t k = 1; k < 4; ++k) {
      if (use_of(strain[k], limit[k]) > use_of(strain[worst], limit[worst])) worst = k;
    }
    if (use_of(strain[worst], limit[worst]) <= 1.0) continue;
    BrokenJoint broken;
    broken.joint = static_cast<int>(j);
    broken.cause = kCauses[worst];
    broken.strain = strain[worst];
    broken.limit = limit[worst];
    broken.angle = angles[j];
    joints.push_back(broken);
  }
  return joints;
}

}  // namespace plastica
