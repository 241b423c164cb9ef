#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "plastica/chain/joint_numbers.hpp"
#include "plastica/model/section_kind.hpp"

/// What a joint is made of, in numbers that anyone may read: probes, the break watch, pictures,
/// exports and the kernels of lanes. Made once for each set of material numbers: a model runs with
/// many where some are its parameters.
namespace plastica::chain {

/// The joint at a node, where two segments meet or the beam ends. Components are those of its
/// section: bending about x, about y, torsion, and axial force (`law::Axis`).
struct JointModel {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  using Components = std::array<double, law::kSectionAxes>;

  std::size_t joint = kNone;  ///< its number among the chain's; none: an end that nothing holds
  std::size_t owner = 0;      ///< the region of the beam whose section and law it has
  std::size_t first = 0;      ///< the first component that turns on the level
  /// Bending about x, about y, torsion: whether the section resists it there. It does not in a pin,
  /// in a hinge, nor at an end that nothing holds.
  std::array<bool, 3> resists{};
  std::array<double, 3> spring{};  ///< beside it, of a rotational spring [N m/rad]
  bool has_halves = false;         ///< within the beam, where a half joint on each side does all
  double fraction = 0.0;           ///< where it is, of the beam's length [1]
  double begin = 0.0;              ///< the part of the axis that it stands for [m]
  double end = 0.0;
  Components length{};     ///< tributary, of the owner's section [m]
  Components lever{};      ///< strain of the extreme fibre over the section's: I/W, J/W_t [m], 1
  Components modulus{};    ///< force over the stress there: W_x, W_y, W_t [m^3], A [m^2]
  Components stiffness{};  ///< per length: EI_x, EI_y, GJ [N m^2], EA [N]
  Components cap{};        ///< at which it yields [N m], [N]; infinite: never
  /// Permanent strains of bending about x, about y, torsion and bending about both at which it
  /// breaks [1]; infinite: never.
  std::array<double, 4> limit{kNever, kNever, kNever, kNever};
  /// What the joint stretches and shears by under a force along its x, y, z [m/N]; 0: it does not.
  std::array<double, 3> shift_compliance{};
  /// Of a force along its x, y, z at its node, what acts on the segment beyond [1]: the part of its
  /// compliance that lies before the node.
  std::array<double, 3> fraction_of_force{0.5, 0.5, 0.5};
  std::array<double, 3> fraction_of_moment{0.5, 0.5, 0.5};  ///< likewise, about its x, y, z
  double width = 0.0;   ///< b [m]; of a round section its diameter
  double height = 0.0;  ///< h [m]
  bool round = false;

  /// Tributary length l of the first component [m].
  double own_length() const { return length[first]; }
  /// Strain of the extreme fibre, spread over the joint's length, per angle [1/rad]. Where the
  /// section resists nothing, what a rotational spring there carries strains it: 0 in a pin.
  double strain_per_angle(std::size_t axis) const {
    return resists[axis] || has_halves ? lever[axis] / length[axis]
                                       : lever[axis] * spring[axis] / stiffness[axis];
  }
  /// Elastic stress of the extreme fibre [Pa].
  double stress(std::size_t axis, double moment) const { return moment / modulus[axis]; }
  /// The largest over the section of strains or stresses of bending about x and about y.
  double bending_together(double by_x, double by_y) const {
    return round ? std::hypot(by_x, by_y) : std::fabs(by_x) + std::fabs(by_y);
  }
};

/// L_p of a joint for bending about x and y and for torsion: of the scene, or the depth of its
/// section in the plane of bending, in torsion the larger of both; 0 in Wendelius' formulas [m].
inline std::array<double, 3> hinge_lengths(const Scene& scene, const JointModel& joint) {
  const bool none = scene.formulas == Formulas::Report;
  const auto or_depth = [&](double depth) {
    return scene.hinge_length.value_or(none ? 0.0 : depth);
  };
  return {or_depth(joint.height), or_depth(joint.width),
          or_depth(std::max(joint.width, joint.height))};
}

/// `JointModel::limit` of the joints that a region owns.
inline std::array<double, 4> break_limits(const Scene& scene, const Material& material) {
  constexpr double kNever = JointModel::kNever;
  const double bending = material.break_strain.value_or(kNever);
  const bool report = scene.formulas == Formulas::Report;
  const double shear = report ? material.break_shear_strain.value_or(bending)
                              : resolved_break_shear_strain(material).value_or(kNever);
  std::array<double, 4> limit{scene.break_limit_x.value_or(bending),
                              scene.break_limit_y.value_or(bending),
                              scene.break_limit_z.value_or(shear), kNever};
  if (!report && !scene.break_limit_x && !scene.break_limit_y) limit[3] = bending;
  return limit;
}

/// What all joints that a region owns have in common.
inline JointModel joint_of_region(const Scene& scene, const BeamRegion& region,
                                  const MaterialValues<double>& material) {
  JointModel joint;
  const RegionNumbers<double> numbers = region_numbers(region, material);
  joint.stiffness = numbers.stiffness.at;
  joint.cap = numbers.yield.at;
  if (scene.yield_model == YieldModel::Elastic) joint.cap.fill(JointModel::kNever);
  joint.lever = region.form.lever;
  joint.modulus = region.form.modulus;
  joint.limit = break_limits(scene, region.material);
  joint.width = 2.0 * region.properties.outer_distance_y;
  joint.height = 2.0 * region.properties.outer_distance_x;
  joint.round = section_kind(region.section).round();
  return joint;
}

/// A chain's joints with one set of material numbers.
template <class L>
struct JointSet {
  std::vector<MaterialValues<typename L::Scalar>> materials;  ///< of the regions (regions)
  std::vector<SectionJoint<L>> numbers;                       ///< of all joints (joints)
  std::vector<JointModel> at_nodes;                           ///< (N + 1)
};

/// @param material  numbers of the scene's own; regions have theirs
template <class S>
std::vector<MaterialValues<S>> region_materials(const Layout& layout,
                                                const MaterialValues<double>& material) {
  std::vector<MaterialValues<S>> materials;
  for (const BeamRegion& region : layout.regions) {
    const auto values = materials.empty() ? material : material_values(region.material);
    auto& own = materials.emplace_back();
    for (std::size_t i = 0; i < kMaterialFields; ++i) own[i] = constant<S>(values[i]);
  }
  return materials;
}

/// `node_shares` without springs of one node after another; most have those of the last one.
class SharesOfNodes {
 public:
  explicit SharesOfNodes(const Layout& layout) : layout_(layout) {}

  const NodeShares& at(std::size_t node) {
    const JointPlan plan = joint_plan(layout_, node);
    const bool alike = known_ && !layout_.has_corners && plan.region_a == of_.region_a &&
                       plan.region_b == of_.region_b && plan.length == of_.length &&
                       plan.before == of_.before;
    if (!alike) shares_ = node_shares(layout_, plan, {});
    known_ = true;
    of_ = plan;
    return shares_;
  }

 private:
  const Layout& layout_;
  bool known_ = false;
  JointPlan of_;
  NodeShares shares_;
};

/// @param material  numbers of the scene's own; regions have theirs
template <class L>
JointSet<L> joint_set(const Scene& scene, const Layout& layout, const Build<L>& build,
                      const MaterialValues<double>& material, const View<L>& view) {
  const std::size_t n = layout.size();
  JointSet<L> set;
  set.materials = region_materials<typename L::Scalar>(layout, material);
  std::vector<JointModel> of_region;
  for (const BeamRegion& region : layout.regions) {
    const auto values = of_region.empty() ? material : material_values(region.material);
    of_region.push_back(joint_of_region(scene, region, values));
  }
  set.numbers = joint_numbers(build.joints, layout.regions, set.materials, view);
  set.at_nodes.reserve(n + 1);
  SharesOfNodes shares_of(layout);
  std::size_t at_end = JointModel::kNone;
  for (const GroundJoint<L>& ground : build.chain.ground_joints) {
    if (ground.node == n) at_end = ground.joint;
  }
  for (std::size_t node = 0; node <= n; ++node) {
    const std::size_t number = node < n ? node : at_end;
    const bool acts = number != JointModel::kNone;
    const std::size_t owner = acts ? set.numbers[number].law : layout.segment_regions[n - 1].outer;
    JointModel& joint = set.at_nodes.emplace_back(of_region[owner]);
    joint.joint = number;
    joint.owner = owner;
    joint.first = view.section_axes().rotation(0);
    joint.fraction = layout.ends[node];
    joint.length.fill(layout.joint_length[node]);
    const double at = layout.ends[node] * scene.beam.length;
    joint.begin = node == 0 ? at : at - 0.5 * layout.segment_length[node - 1];
    joint.end = node == n ? at : at + 0.5 * layout.segment_length[node];
    if (!acts) continue;
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.length[k] = static_cast<double>(set.numbers[number].length[k]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      const std::size_t axis = view.section_axes().rotation(k);
      const JointPlan& plan = build.joints[number];
      joint.resists[axis] = plan.active[k];
      joint.spring[axis] = static_cast<double>(set.numbers[number].spring[k]);
      // The numbers of a joint beside a spring have more compliance than its length.
      if (plan.node_spring[k] > 0.0) joint.length[axis] = plan.length[axis];
    }
    const bool within = node > 0 && node < n;
    joint.has_halves =
        within && std::ranges::any_of(build.chain.ground_joints, [&](const GroundJoint<L>& ground) {
          return ground.node == node;
        });
    const NodeShares* shares = within ? &shares_of.at(node) : nullptr;
    for (std::size_t k = 0; within && k < 3; ++k) {
      joint.fraction_of_moment[k] = shares->rotational(k, k);
    }
    if (within && set.numbers[number].stretches) {
      for (std::size_t k = 0; k < L::kTranslations; ++k) {
        const SectionJoint<L>& own = set.numbers[number];
        const std::size_t axis = view.section_axes().translation(k);
        const auto stiffness =
            static_cast<double>(axis == 2 ? own.stiffness[law::kAxial] : own.shear_stiffness[k]);
        if (stiffness > 0.0) joint.shift_compliance[axis] = joint.length[law::kAxial] / stiffness;
        joint.fraction_of_force[axis] = shares->shifting(axis, axis);
      }
    }
    // With what it takes over of an end; between unlike regions, of its owner alone.
    if (node == 1) joint.begin -= layout.bare_half[0][joint.first];
    if (node + 1 == n) joint.end += layout.bare_half[1][joint.first];
    const JointPlan& plan = build.joints[number];
    const bool is_before = owner == plan.region_a || plan.beyond_ends[0] == owner;
    if (plan.region_a != plan.region_b) (is_before ? joint.end : joint.begin) = at;
  }
  return set;
}

}  // namespace plastica::chain
