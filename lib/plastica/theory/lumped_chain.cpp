#include "plastica/theory/lumped_chain.hpp"

#include <cmath>
#include <numbers>

#include "plastica/base/domain.hpp"
#include "plastica/theory/bending.hpp"

namespace plastica::theory {

std::vector<ChainJoint> chain_joints(ChainConvention convention, int count) {
  require_domain(count >= 2, "count >= 2");
  const bool at_clamp =
      convention == ChainConvention::FullJoint || convention == ChainConvention::HalfJoint;
  const double h = 1.0 / count;
  std::vector<ChainJoint> joints;
  if (convention == ChainConvention::HalfEnds) {
    for (int i = 0; i < count; ++i) joints.push_back({(count - i - 0.5) * h, h});
    return joints;
  }
  for (int i = at_clamp ? 0 : 1; i < count; ++i) joints.push_back({(count - i) * h, h});
  if (convention == ChainConvention::HalfJoint) joints.front().length = 0.5 * h;
  if (convention == ChainConvention::ThreeHalvesEnds) {
    joints.front().length += 0.5 * h;
    joints.back().length += 0.5 * h;
  }
  return joints;
}

double tip_force_ratio(ChainConvention convention, int count) {
  require_domain(count >= 2, "count >= 2");
  const double n = count;
  switch (convention) {
    case ChainConvention::Clamp: return (n - 1.0) * (2.0 * n - 1.0) / (2.0 * n * n);
    case ChainConvention::FullJoint: return (n + 1.0) * (2.0 * n + 1.0) / (2.0 * n * n);
    case ChainConvention::HalfJoint: return 1.0 + 1.0 / (2.0 * n * n);
    case ChainConvention::HalfEnds: return 1.0 - 1.0 / (4.0 * n * n);
    case ChainConvention::ThreeHalvesEnds: break;
  }
  return 1.0 - (2.5 - 3.0 / n) / (n * n);
}

double self_weight_ratio(ChainConvention convention, int count) {
  require_domain(count >= 2, "count >= 2");
  const double n = count;
  switch (convention) {
    case ChainConvention::Clamp: return (1.0 - 1.0 / n) * (1.0 - 1.0 / n);
    case ChainConvention::FullJoint: return (1.0 + 1.0 / n) * (1.0 + 1.0 / n);
    case ChainConvention::HalfJoint: return 1.0 + 1.0 / (n * n);
    case ChainConvention::HalfEnds: return 1.0 - 1.0 / (2.0 * n * n);
    case ChainConvention::ThreeHalvesEnds: break;
  }
  return 1.0 - (5.0 - 6.0 / n) / (n * n);
}

double tip_moment_ratio(ChainConvention convention, int count) {
  require_domain(count >= 2, "count >= 2");
  switch (convention) {
    case ChainConvention::Clamp: return 1.0 - 1.0 / count;
    case ChainConvention::FullJoint: return 1.0 + 1.0 / count;
    case ChainConvention::HalfJoint:
    case ChainConvention::HalfEnds:
    case ChainConvention::ThreeHalvesEnds: break;
  }
  return 1.0;
}

double pinned_chain_frequency_ratio(int count, int mode) {
  require_domain(mode >= 1 && mode < count, "mode >= 1 && mode < count");
  const double x = std::numbers::pi * mode / count;
  const double s = std::sin(0.5 * x);
  return 4.0 * s * s / (x * x) / std::sqrt(1.0 - 2.0 / 3.0 * s * s);
}

double buckling_load(int count, double bending_stiffness, double length) {
  require_domain(count >= 1, "count >= 1");
  const double s = 2.0 * count * std::sin(0.25 * std::numbers::pi / count) / length;
  return s * s * bending_stiffness;
}

double elastoplastic_tip_ratio(ChainConvention convention, int count, double load_ratio) {
  require_domain(load_ratio >= 0.0 && load_ratio < 1.5, "load_ratio >= 0.0 && load_ratio < 1.5");
  double sum = 0.0;
  for (const ChainJoint& joint : chain_joints(convention, count)) {
    sum += joint.length * joint.lever * curvature_ratio_rectangle(load_ratio * joint.lever);
  }
  return 3.0 * sum;
}

HingeBreak hinge_break(double break_strain, double depth, double hinge_length,
                       double plastic_moment, double lever) {
  const double angle = 2.0 * break_strain * hinge_length / depth;
  return {.angle = angle, .tip_travel = lever * angle, .energy = plastic_moment * angle};
}

}  // namespace plastica::theory
