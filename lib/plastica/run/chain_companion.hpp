#pragma once

#include <algorithm>
#include <cstddef>

#include "plastica/run/chain_body.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/solve/path_options.hpp"

namespace plastica {

/// A beam that takes the steps of another path at rest, the lead's, from whose numbers its own
/// differ by little. It is in equilibrium at each of these steps to its own tolerance, with a
/// history of its own. What it does not do is decide: how long steps are, whether the equilibrium
/// is stable, and which branch it is on are as for the lead, next to whose equilibrium its own is
/// sought.
template <class L, bool kElastic>
class ChainCompanion {
 public:
  using Work = solve::NewtonWork<L, kElastic>;

  /// @param one  of `may_accompany`; outlives this
  ChainCompanion(const LaneCase& one, const chain::View<L>& view)
      : body_(*one.model, view), material_(*one.material), response_(one.response) {
    newton_.max_iterations = kMostIterations;
    newton_.tolerance = newton_.one_solve_tolerance = one.model->options.tolerance;
    newton_.one_solve = true;
    body_.record.shapes_on_demand();
  }

  /// Before the lead seeks its first equilibrium.
  void begin() {
    Response& response = *response_;
    response.samples = 0;
    clear_motion(response);
    response.chain.events.clear();
    response.limit.reset();
    response.plateau.reset();
    response.buckling.reset();
    response.vibration.reset();
    counters_ = {};
    body_.reset(material_);
    body_.record.begin_frames(response);
    committed_ = body_.work.q;
    accompanies_ = true;
  }

  /// Takes a step that the lead has accepted.
  /// @param before  the lead's unknowns at the step before
  void take(const Work& lead, const chain::Coordinates<L>& before) {
    Work& w = body_.work;
    accompanies_ = accompanies_ && has_shape_of(lead.q);
    if (!accompanies_) return;
    w.time = lead.time;
    start_beside(lead.q, before, w.q);
    const auto outcome = solve::equilibrate(body_.build.chain, *body_.joints, newton_, w);
    counters_.iterations += outcome.iterations;
    accompanies_ = outcome.converged && !body_.joints->overloaded() && w.closed == lead.closed &&
                   is_near(lead.q);
    if (!accompanies_) return;
    const bool first = response_->samples == 0;
    const bool flows = first || body_.flows();
    if (flows) body_.set_trial_strains(first);
    body_.joints->commit();
    committed_ = w.q;
    ++counters_.steps;
    if (flows) body_.accept_strains();
    body_.record.add_work(w, *body_.joints);
  }

  /// Records the last step.
  void record() {
    if (!accompanies_ || response_->samples == body_.model.samples) return;
    body_.record.write(body_.work, *body_.joints, body_.strains, response_->samples, *response_);
    response_->chain.iterations[response_->samples] = counters_.iterations;
    ++response_->samples;
  }

  /// It cannot go on beside the lead.
  void leave() { accompanies_ = false; }

  /// After the lead has come to its end. What is noted beside the samples is as for the lead.
  /// @return whether the response is complete
  bool finish(const Response& lead) {
    Response& response = *response_;
    if (!accompanies_ || lead.status != Status::Completed) {
      response.samples = 0;
      return false;
    }
    response.status = Status::Completed;
    response.counters = counters_;
    body_.record.end_frames(response);
    response.axial = lead.axial;
    response.unheld_thrust = lead.unheld_thrust;
    response.critical = lead.critical;
    set_energy_balance(body_.model.scene.beam.length, response);
    response.permanent_strain = body_.watch.largest_strain(body_.strains);
    return true;
  }

 private:
  /// One step of Newton's method leaves the square of a small difference. Who needs many more is
  /// not near.
  static constexpr int kMostIterations = 6;
  /// How far joints may be off the lead's angles, over the largest of these. Farther away there may
  /// be another branch.
  static constexpr double kNear = 0.05;

  bool has_shape_of(const chain::Coordinates<L>& q) const {
    return q.angle.size() == committed_.angle.size() &&
           q.multiplier.size() == committed_.multiplier.size();
  }

  bool is_near(const chain::Coordinates<L>& lead) const {
    double off = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < lead.angle.size(); ++i) {
      off = std::max(off, static_cast<double>(size_of(body_.work.q.angle[i] - lead.angle[i])));
      largest = std::max(largest, static_cast<double>(size_of(lead.angle[i])));
    }
    return off <= std::max(kNear * largest, solve::kNoRotation);
  }

  /// As far from the lead as before its step.
  void start_beside(const chain::Coordinates<L>& lead, const chain::Coordinates<L>& before,
                    chain::Coordinates<L>& q) const {
    const auto set = [](auto& to, const auto& at, const auto& from, const auto& own) {
      for (std::size_t i = 0; i < to.size(); ++i) to[i] = at[i] + (own[i] - from[i]);
    };
    set(q.angle, lead.angle, before.angle, committed_.angle);
    set(q.shift, lead.shift, before.shift, committed_.shift);
    set(q.multiplier, lead.multiplier, before.multiplier, committed_.multiplier);
    q.root = lead.root + (committed_.root - before.root);
  }

  ChainBody<L, kElastic> body_;
  MaterialValues<double> material_;
  solve::NewtonOptions newton_;
  chain::Coordinates<L> committed_;
  Response* response_;
  PathCounters counters_{};
  bool accompanies_ = false;
};

}  // namespace plastica
