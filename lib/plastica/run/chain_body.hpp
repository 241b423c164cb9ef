#pragma once

#include <memory>
#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/run/break_watch.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_record.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/solve/newton.hpp"

namespace plastica {

/// What a path and a motion of one beam have in common: the chain, its joints with their material,
/// what breaks them, and the record. Compiled once for each level (chain_body.cpp).
template <class L, bool kElastic>
class ChainBody {
 public:
  using S = typename L::Scalar;
  using Work = solve::NewtonWork<L, kElastic>;
  using Joints = chain::SectionJointsBase<L, kElastic>;

  ChainBody(const ChainModel& model, const chain::View<L>& view);
  ChainBody(const ChainBody&) = delete;  // the record looks at its neighbours
  ChainBody& operator=(const ChainBody&) = delete;

  /// Back to the virgin beam, with a material of the scene's own part.
  void reset(const MaterialValues<double>& material);

  /// Whether any joint has flowed in the step that `work` holds; else its permanent strains are
  /// those of the step before. (Work of flow may be negative, where a joint yields back early.)
  bool flows() const;
  /// Permanent strains of the step that `work` holds, before it is accepted.
  /// @param of_all  whether they are not those of the step before where no joint flows in it
  void set_trial_strains(bool of_all = false);
  /// Takes them.
  void accept_strains();
  /// Notes the axial force of joints that yield in the step just accepted, or would if they saw it,
  /// where the response has to speak of it (`Response::axial`).
  /// @param in_motion  whether `work` holds all forces of the step, inertia included; else they are
  ///                   found from the unknowns
  /// @param given      these forces, if they are known; else null (joints)
  void note_axial(bool in_motion, Response& response, const std::vector<S>* given = nullptr);
  /// After the run.
  void finish_axial(Response& response) const;
  /// All joints over their limit now, with moment, angle and dissipation.
  std::vector<BrokenJoint> broken();
  /// What is known of a joint that broke or is cut.
  void describe(BrokenJoint& broken) const;

  const ChainModel& model;
  chain::View<L> view;
  chain::Build<L> build;
  std::unique_ptr<Joints> joints;
  std::vector<chain::JointModel> joint_models;  ///< at the nodes, with the material that runs
  Work work;
  BreakWatch watch;
  ChainRecord<L, kElastic> record;
  NodeStrains strains;  ///< at the last accepted step
  NodeStrains trial;    ///< of a step that is being judged

 private:
  void set_material(const MaterialValues<double>& material);

  void set_neutral_axes();
  /// What of a permanent elongation of the joint at a node counts against its limit [m].
  double counted_stretch(std::size_t node, double stretch) const;

  void find_axial_forces(bool in_motion);
  /// Whether a joint transmits more than the force at which its section yields by N alone.
  bool carries_axial_yield() const;
  /// See `AxialNote`.
  double missing_elongation(std::size_t j) const;

  MaterialValues<double> material_{};  ///< that the joints have
  /// Of bending about x and about y (regions); empty: all elongation counts.
  std::vector<std::array<law::NeutralAxis, 2>> neutral_axes_;
  // Of `note_axial`:
  chain::Placement<L> axial_placement_;
  chain::OuterForces<L> axial_outside_;
  chain::AxialForces<L> axial_forces_;
  std::vector<S> axial_;        ///< [N] (joints)
  std::size_t axial_part_ = 0;  ///< whose section the noted joint has
};

}  // namespace plastica
