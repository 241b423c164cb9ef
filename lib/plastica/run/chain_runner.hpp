#pragma once

#include <memory>
#include <vector>

#include "plastica/chain/joint_numbers.hpp"
#include "plastica/run/break_watch.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_record.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/solve/path.hpp"

namespace plastica {

/// The program of one level.
template <class L, bool kElastic>
class ChainRunner final : public ChainProgram, private solve::PathObserver<L, kElastic> {
 public:
  using Work = solve::NewtonWork<L, kElastic>;
  using Joints = chain::SectionJointsBase<L, kElastic>;

  ChainRunner(const ChainModel& model, const chain::View<L>& view);

  void run(const MaterialValues<double>& material, Response& response) override;

 private:
  bool yields() const override;
  solve::Verdict judge(const Work& w, bool shortest) override;
  void accept(const Work& w) override;
  bool record(const Work& w) override;

  void set_path_options();
  void set_material(const MaterialValues<double>& material);
  void set_closure_stiffness();
  void set_trial_strains(const Work& w);
  const std::vector<JointAngles>& measured(const NodeStrains& strains) const;
  void note_break(const Work& w);

  const ChainModel& model_;
  chain::View<L> view_;
  std::vector<chain::PartForm> parts_;
  chain::Build<L> build_;
  std::unique_ptr<Joints> joints_;
  MaterialValues<double> material_{};  ///< that the joints have
  solve::PathOptions options_;
  solve::ControlPoint<L> control_;
  Work work_;
  chain::Coordinates<L> committed_, previous_;
  BreakWatch watch_;
  ChainRecord<L, kElastic> record_;
  NodeStrains strains_;  ///< at the last accepted step
  NodeStrains trial_;    ///< of a step that is being judged
  Response* response_ = nullptr;
  const solve::PathWalker<L, kElastic>* walker_ = nullptr;  ///< while a path is walked
};

}  // namespace plastica
