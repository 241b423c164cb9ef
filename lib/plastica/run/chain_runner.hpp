#pragma once

#include "plastica/run/chain_body.hpp"
#include "plastica/solve/path.hpp"

namespace plastica {

/// The program of one level in statics.
template <class L, bool kElastic>
class ChainRunner final : public ChainProgram, private solve::PathObserver<L, kElastic> {
 public:
  using Work = solve::NewtonWork<L, kElastic>;

  ChainRunner(const ChainModel& model, const chain::View<L>& view);

  void run(const MaterialValues<double>& material, const Workspace& hooks,
           Response& response) override;

 private:
  bool yields() const override;
  solve::Verdict judge(const Work& w, bool shortest) override;
  bool accept(const Work& w) override;
  bool record(const Work& w) override;

  void set_path_options();
  void note_break(const Work& w);

  ChainBody<L, kElastic> body_;
  solve::PathOptions options_;
  solve::ControlPoint<L> control_;
  chain::Coordinates<L> committed_, previous_;
  Response* response_ = nullptr;
  const Workspace* hooks_ = nullptr;                        ///< while a path is walked
  const solve::PathWalker<L, kElastic>* walker_ = nullptr;  ///< while a path is walked
};

}  // namespace plastica
