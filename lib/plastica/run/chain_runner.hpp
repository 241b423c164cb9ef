#pragma once

#include <optional>

#include "plastica/run/chain_body.hpp"
#include "plastica/run/chain_companion.hpp"
#include "plastica/run/out_of_plane.hpp"
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
  std::vector<bool> run_with(std::span<const LaneCase> cases) override;

  // The same in steps, for beams whose equilibria are sought side by side.
  /// @return whether an equilibrium is sought at the time in `body().work`, from the unknowns there
  bool begin(const MaterialValues<double>& material, const Workspace& hooks, Response& response);
  /// See PathContinuation::take.
  bool take(bool converged, int iterations, bool factored, double unstable_modes) {
    return continuation_->take(converged, iterations, factored, unstable_modes);
  }
  /// Seeks the equilibrium, and all that follow, alone.
  void proceed();
  /// After the path has ended.
  void finish();
  ChainBody<L, kElastic>& body() { return body_; }
  /// Whether what is sought next is looked at for more than where points are and what the laws say:
  /// `work` must then hold all that `equilibrate` leaves in it.
  bool needs_all() const;
  bool records_next() const { return continuation_->records_next(); }
  const solve::NewtonOptions& newton() const { return options_.newton; }

 private:
  bool yields() const override;
  solve::Verdict judge(const Work& w, bool shortest) override;
  bool accept(const Work& w) override;
  bool record(const Work& w) override;
  int unstable_beside(const Work& w) override;
  double log_determinant_beside(const Work& w) override;
  void note_mode(bool out_of_plane, Work& w, std::vector<double>& mode) override;

  bool begin_path();
  bool find_modes();
  void note_limit_mode(LimitLoad& limit);
  void set_path_options();
  void note_break(const Work& w);
  // Out of the plane of a planar chain: check_plane.hpp.
  bool has_space_beside();
  bool is_pushed(const Work& w) const;
  /// What joints' sections carry, and how stiff they are about the other axis.
  struct Sections {
    const std::vector<law::SectionForce<typename L::Scalar>>& force;
    const std::vector<typename L::Scalar>& aside;
  };
  Sections sections() const {
    return {body_.joints->section_forces(), body_.joints->stiffness_aside()};
  }
  void see(const chain::Coordinates<L>& q, double time, const Sections* sections);
  /// @param sections  there; null where nothing has yielded
  void check_plane(const chain::Coordinates<L>& q, double time, const Sections* sections);
  void check_plane_while_moments_grow(const Work& w);
  void check_plane_where_loads_turn(const Work& w);

  ChainBody<L, kElastic> body_;
  solve::PathOptions options_;
  solve::ControlPoint<L> control_;
  chain::Coordinates<L> committed_, previous_;
  solve::ElasticResponses<L> elastic_;
  Response* response_ = nullptr;
  MaterialValues<double> material_{};
  const Workspace* hooks_ = nullptr;  ///< while a path is followed
  std::optional<solve::PathContinuation<L, kElastic>> continuation_;
  std::unique_ptr<OutOfPlane> beside_;  ///< of a planar chain, made when first asked for
  bool asks_beside_ = false;            ///< at each step, to tell where the plane is left
  bool leaves_plane_ = false;           ///< seen in a path that did not ask
  bool has_yielded_ = false;
  bool flowed_ = false;  ///< in the step that was judged last
  /// Where buckling is asked for: the last equilibrium that is known to be stable, and elastic.
  chain::Coordinates<L> stable_;
  double stable_time_ = 0.0;
  bool has_stable_ = false;
  std::vector<bool> reported_;   ///< joints whose break is an event already (nodes)
  int unstable_beside_ = 0;      ///< as known last
  double checked_at_ = -1.0;     ///< time of the last check of stability out of the plane
  double checked_moment_ = 0.0;  ///< largest of a joint at the last such check [N m]
  double last_time_ = 0.0;       ///< of the last step
  /// `sections` there, of a planar chain that has yielded.
  std::vector<law::SectionForce<typename L::Scalar>> last_forces_;
  std::vector<typename L::Scalar> last_aside_;
  MaterialValues<double> beside_material_{};
  std::vector<std::unique_ptr<ChainCompanion<L, kElastic>>> companions_;  ///< of `run_with`
  PlanarEquilibrium seen_;
};

// Those that lanes need, too (chain_runner_*.cpp).
extern template class ChainRunner<chain::Planar<double>, false>;
extern template class ChainRunner<chain::Spatial<double>, false>;

}  // namespace plastica
