#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"
#include "plastica/run/sliding_sum.hpp"

namespace plastica {

/// Permanent deformation of a joint in its axes: bending about x, about y, torsion [rad], and the
/// elongation of the length that it bends over [m], of which what is an edge's of the yield surface
/// does not count (law::NeutralAxis).
using JointFlow = std::array<double, 4>;
inline constexpr std::size_t kStretch = 3;  ///< the elongation in a `JointFlow`

/// Permanent deformation of the joint at each node (N + 1).
class NodeStrains {
 public:
  std::vector<JointFlow> permanent;    ///< now
  std::vector<JointFlow> accumulated;  ///< sums of |d permanent|
  std::vector<double> elongation;      ///< all of it [m]

  void reset(std::size_t nodes) {
    permanent.assign(nodes, {});
    accumulated.assign(nodes, {});
    elongation.assign(nodes, 0.0);
    strain_.assign(nodes, 0.0);
    is_known_ = true;
  }
  /// Takes what another time has.
  void take(NodeStrains& of) {
    std::swap(permanent, of.permanent);
    std::swap(accumulated, of.accumulated);
    std::swap(elongation, of.elongation);
    is_known_ = false;
  }

 private:
  friend class BreakWatch;
  std::vector<double> strain_;  ///< as `BreakWatch::strains` found them
  bool is_known_ = true;
};

/// The permanent strain at break is met within this fraction of the limit, if steps can be cut
/// back; joints nearer to their limits than this break together. (On the plateau of ideal
/// plasticity the joints share uniform bending evenly to 1e-7 only, since any distribution is in
/// equilibrium.)
inline constexpr double kBreakTolerance = 1e-4;

/// What a joint must have of a strain over a window itself, to break by it.
inline constexpr double kOwnPart = 0.01;

/// Whether a scene limits the strains of any joint.
bool has_break_limits(const Scene& scene);

/// How a joint's law distributes permanent rotation along a beam whose moment varies.
enum class Localization {
  Concentrated,  ///< in the joint of largest moment: ideal plasticity of the whole section
  Saturating,    ///< over a zone, which shrinks at large strains: fibres, Voce
  Distributed,   ///< over a zone that the moments set, however large the strains
};

/// How far the scene's laws localize permanent rotation.
Localization localization_of(const Scene& scene);

/// Permanent strains of a chain's joints, and which of them are over their limit (design 2.3).
///
/// The strain of a joint is (h/2) Theta/L_p, with the hinge length L_p, which is by default the
/// depth h in the plane of bending, and the rotation Theta that a length L_p of the beam takes
/// there:
/// - Distributed: Theta = theta_p L_p/l. The curvature theta_p/l converges with the segments by
///   itself, at the clamp of a cantilever too; a mean over L_p would make fine chains stronger than
///   coarse.
/// - else, l < L_p: the sum over a window of length L_p around the joint, moved into the beam at
///   its ends, a joint counting with the fraction of its length that the window covers.
/// - else, Saturating: Theta = theta_p L_p/l.
/// - else, Concentrated: what the neighbours turn as well is spread, what the joint turns beyond
///   them gathers in the hinge: Theta = theta_n L_p/l + (theta_p - theta_n), theta_n the larger of
///   the neighbours' curvatures times l, at most theta_p. So uniform moment (theta_n = theta_p) and
///   a lone hinge (theta_n = 0) both come out as in a fine chain.
/// L_p = 0: theta_p over the joint's own length, as in Wendelius' report.
///
/// What a window holds may be the hinge of a neighbour. So a strain over a window counts for a
/// joint up to 1/`kOwnPart` of its own, theta_p over its own length: one that has not yielded
/// itself does not break. Of joints that are over their limits together those are cut that are
/// nearest to them by their own strains of all such in their windows, or as near within
/// `kBreakTolerance`.
///
/// A permanent elongation is taken alike, over the hinge length of the axis that bends, and its
/// strain adds to that of bending: the extreme fibre's (plane sections). Where both axes bend it is
/// the mean of the strains over either length, by what each bends; where none does, the plain mean.
/// Of a section that bends it counts as far as its neutral axis explains it (law::NeutralAxis): a
/// surface with an edge at no axial force lengthens by more. In Wendelius' formulas it does not
/// count.
class BreakWatch {
 public:
  BreakWatch() = default;
  /// @param joints  at the nodes
  BreakWatch(const Scene& scene, std::vector<chain::JointModel> joints);

  bool active() const { return active_; }
  /// L_p of a joint, of bending about x and y and of torsion (`chain::hinge_lengths`) [m].
  const std::array<double, 3>& hinge_lengths(std::size_t joint) const { return hinge_[joint]; }
  std::size_t size() const { return joints_.size(); }

  // Each takes the flows of all joints, in the break measure, net or accumulated (joints), and
  // costs as much as there are joints, however many a hinge length holds; but for what breaks.

  /// Largest strain over its limit minus 1, of all joints; negative: nothing breaks.
  /// @param left_out  of each joint whether it does not count (joints); empty: all do
  double excess(const std::vector<JointFlow>& angles, const std::vector<bool>& left_out = {});

  /// The angles that count, in the break measure.
  const std::vector<JointFlow>& measured(const NodeStrains& of) const {
    return accumulated_ ? of.accumulated : of.permanent;
  }
  /// Of each joint the strain that is nearest to its limit, in the break measure; the largest of
  /// all where there is none. Most steps of most runs are asked for none, so they are found here.
  /// @return  [1] (joints)
  const std::vector<double>& strains(NodeStrains& of);
  double largest_strain(NodeStrains& of);

  /// Strains of one joint: bending about x, about y, torsion, with the signs of the rotations that
  /// its hinge takes; and of bending about both and stretch, in Wendelius' formulas the larger of
  /// the two of bending [1].
  std::array<double, 4> strains_at(const std::vector<JointFlow>& angles, std::size_t joint);

  /// The strain nearest to its limit of a joint that turns alone, all others straight.
  double lone_strain(const JointFlow& angle, std::size_t joint) const;

  /// All joints over their limit, with cause, strain and limit; where one is, also those that are
  /// below it by less than `kBreakTolerance`. `cut` says which are to be cut, where all are.
  std::vector<BrokenJoint> broken(const std::vector<JointFlow>& angles);

 private:
  /// Strains that have limits: of bending about x, about y, torsion, and of bending about both with
  /// stretch; and of stretch alone.
  struct Strains {
    std::array<double, 4> of{};
    double stretch = 0.0;
  };
  /// How far a joint is to a limit.
  struct LimitUse {
    double of = 0.0;
    std::size_t worst = 0;  ///< which strain
  };
  LimitUse use_of(const Strains& strain, std::size_t joint) const;
  /// The same where a window's strain counts as far as the joint has yielded itself.
  LimitUse own_use_of(const Strains& strain, const JointFlow& flow, std::size_t joint) const;
  /// Strains of what a joint has yielded itself, over its own length.
  Strains own_strains(const JointFlow& flow, std::size_t joint) const {
    return strains_of(spread(flow, joint), joint);
  }
  bool has_window_of(std::size_t joint, std::size_t strain) const {
    if (hinge_[joint][0] == 0.0) return false;
    return strain < 3 ? has_window(joint, strain) : has_window(joint, 0) || has_window(joint, 1);
  }
  /// Of joints that are over their limits those that are to be cut.
  void mark_hinges(const std::vector<JointFlow>& angles, std::vector<BrokenJoint>& joints) const;
  /// What a joint breaks by.
  BreakCause cause_of(const Strains& strain, std::size_t joint, std::size_t worst) const;

  /// Makes all ready to go through the joints in their order.
  void begin(const std::vector<JointFlow>& angles);
  /// Calls `use` with each joint and its strains, in their order.
  template <class Use>
  void for_each_joint(const std::vector<JointFlow>& angles, const Use& use);
  /// What a hinge takes: rotations, and elongation over the hinge lengths of x and of y.
  struct Hinge {
    std::array<double, 3> angle{};
    std::array<double, 2> stretch{};
  };
  Strains strains_of(const Hinge& theta, std::size_t joint) const;
  /// A strain as it is held against limit k: that of bending about one axis with the stretch.
  static double held(const Strains& strain, std::size_t k) {
    return strain.of[k] + (k < 2 ? strain.stretch : 0.0);
  }
  double nearest_limit(const Strains& strain, std::size_t joint) const;
  /// Whether Theta about an axis is a sum over a window: between unlike sections a joint has a
  /// length about each.
  bool has_window(std::size_t joint, std::size_t axis) const {
    return localization_ != Localization::Distributed &&
           joints_[joint].length[axis] < hinge_[joint][axis];
  }
  /// L_p about an axis, or the joint's own length where there is none.
  double strained_length(std::size_t joint, std::size_t axis) const {
    const double hinge = hinge_[joint][axis];
    return hinge == 0.0 ? joints_[joint].own_length() : hinge;
  }
  /// theta_p L_p/l; without L_p what strains the joint's own length as much.
  Hinge spread(const JointFlow& flow, std::size_t joint) const;
  /// A part of the beam [m].
  struct Window {
    double low = 0.0, high = 0.0;
    /// The fraction of a joint's length that it covers, if it touches it.
    double covers(const chain::JointModel& joint) const;
  };
  Window window_of(std::size_t joint, std::size_t axis) const;
  /// Theta of a joint; to be called for one after the other.
  Hinge hinge_of(const std::vector<JointFlow>& angles, std::size_t joint);
  /// Its elongation over the hinge length of an axis.
  double stretch_over(const std::vector<JointFlow>& angles, std::size_t joint, std::size_t axis);
  JointFlow over_window(const std::vector<JointFlow>& angles, std::size_t joint, std::size_t axis) {
    return same_hinges_[axis] ? windowed(angles, joint, axis) : lone_window(angles, joint, axis);
  }
  /// Of all axes, over the window of one.
  JointFlow windowed(const std::vector<JointFlow>& angles, std::size_t joint, std::size_t axis);
  /// The sum over a window by itself, where the next one may begin before it.
  JointFlow lone_window(const std::vector<JointFlow>& angles, std::size_t joint,
                        std::size_t axis) const;
  /// @param hinge  L_p [m]
  double concentrated(const std::vector<JointFlow>& angles, std::size_t joint, std::size_t axis,
                      double hinge) const;

  std::vector<chain::JointModel> joints_;
  /// Joints that the window about an axis touches, and what it covers whole.
  struct Sliding {
    SlidingSum covered;
    std::size_t first = 0, end = 0;
  };
  std::array<Sliding, 3> sliding_;
  std::vector<std::array<double, 3>> hinge_;  ///< L_p by axis (joints)
  std::array<bool, 3> same_hinges_{true, true, true};
  bool any_stretch_ = false;  ///< of the flows that are gone through
  Localization localization_ = Localization::Concentrated;
  bool report_ = false;
  bool accumulated_ = false;
  bool active_ = false;
};

}  // namespace plastica
