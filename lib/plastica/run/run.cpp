#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "plastica/base/instruction_set.hpp"
#include "plastica/coupon/material.hpp"
#include "plastica/coupon/slope_kernel.hpp"
#include "plastica/law/plastic_work.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/run/parameters.hpp"
#include "plastica/run/response_size.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica {
namespace {

void set_parameters(const Model& model, ParameterValues values, MaterialValues<double>& material) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    material[static_cast<std::size_t>(*model.parameters[i]->material)] = values[i];
  }
}

/// Whether the values can be run: each within its field's range, and those of a law consistent.
bool valid(const Model& model, ParameterValues values, const MaterialValues<double>& material) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!model.parameters[i]->range.contains(values[i])) return false;
  }
  return !hardening_kind(model.hardening).broken_rule(material);
}

/// What every sample of a coupon adds to the response, and whether it broke.
template <class Law>
class Recorder {
 public:
  using State = typename Law::State;

  Recorder(const Model& model, const Law& law, double limit, Response& response)
      : model_(model),
        law_(law),
        limit_(limit),
        plastic_limit_(coupon::plastic_limit(model.coupon, limit)),
        response_(response) {}

  void take(std::size_t sample, double strain) {
    if (!cut_) {
      const State before = state_;
      const auto now = law::respond(law_, before, strain);
      const double work = law::plastic_work(law_, before, now);
      state_ = now.state;
      stress_ = now.stress;
      dissipation_ += work;
      if (!response_.event) watch(sample, strain, before, dissipation_ - work);
    }
    record(sample, strain);
    strain_ = strain;
  }

  double stress() const { return stress_; }
  double dissipation() const { return dissipation_; }
  const State& state() const { return state_; }
  bool cut() const { return cut_; }

 private:
  /// The flow of an increment goes one way: where it reaches the limit, all is known.
  void watch(std::size_t sample, double strain, const State& before, double dissipated) {
    const bool net = model_.coupon.break_measure == BreakMeasure::Net;
    const double permanent = net ? std::fabs(state_.plastic) : state_.accumulated;
    if (!(permanent > plastic_limit_)) return;
    const double excess = permanent - plastic_limit_;
    const double direction = strain < strain_ ? -1.0 : 1.0;
    const double flow = std::max(0.0, state_.accumulated - before.accumulated - excess);
    const auto along = law::backs_along<Law>(before, direction);
    BreakEvent event;
    event.sample = sample;
    event.stress = direction * law::flow_stress(law_, before.accumulated, flow, along);
    event.strain = before.plastic + direction * flow + event.stress / law_.stiffness;
    event.permanent_strain = limit_;
    event.dissipation = dissipated + law::flow_work(law_, before.accumulated, flow, along);
    response_.event = event;
    if (model_.on_break == BreakPolicy::CutAll) cut_at(event, direction * excess, excess);
  }

  /// A cut beam carries nothing and keeps the strain that it broke with.
  void cut_at(const BreakEvent& event, double signed_excess, double excess) {
    cut_ = true;
    stress_ = 0.0;
    state_.plastic -= signed_excess;
    state_.accumulated -= excess;
    dissipation_ = event.dissipation;
  }

  void record(std::size_t sample, double strain) {
    for (std::size_t i = 0; i < model_.probes.size(); ++i) {
      double& out = response_.probes[i][sample];
      switch (model_.probes[i]) {
        case ProbeQuantity::Strain: out = strain; break;
        case ProbeQuantity::Stress: out = stress_; break;
        case ProbeQuantity::PlasticStrain: out = state_.plastic; break;
        case ProbeQuantity::AccumulatedStrain: out = state_.accumulated; break;
        case ProbeQuantity::Load: out = stress_ * model_.coupon.load_per_stress; break;
        case ProbeQuantity::Dissipation: out = dissipation_; break;
        default: assert(false && "check_scene refuses the probes of a chain"); break;
      }
    }
  }

  const Model& model_;
  const Law& law_;
  double limit_;          ///< in the break measure
  double plastic_limit_;  ///< in the law's permanent strain
  Response& response_;
  State state_;
  bool cut_ = false;
  double strain_ = 0.0;
  double stress_ = 0.0;
  double dissipation_ = 0.0;
};

/// The fit's case, kept lean: only the stress is asked for, and nothing can break.
/// @param law    copied, so that the compiler knows that no store changes it
/// @param end    the state after the last sample
template <class Law>
void run_stress_only(const Model& model, const Law law, Response& response,
                     typename Law::State& end) {
  typename Law::State state;
  double* out = response.probes[0].data();
  const double* strain = model.drive.data();
  const std::size_t samples = model.drive.size();
  for (std::size_t i = 0; i < samples; ++i) {
    const auto now = law::respond(law, state, strain[i]);
    state = now.state;
    out[i] = now.stress;
  }
  end = state;
}

/// The first sample at which a probe is not finite, or the number of samples.
std::size_t finite_samples(const Response& response, std::size_t samples) {
  std::size_t first = samples;
  for (const std::vector<double>& probe : response.probes) {
    for (std::size_t i = 0; i < first; ++i) {
      if (!std::isfinite(probe[i])) first = i;
    }
  }
  return first;
}

/// `ends` are numbers at the last sample; a law that overflowed on the way stays non-finite.
void finish(const Model& model, Response& response, std::initializer_list<double> ends) {
  response.samples = model.drive.size();
  response.status = response.event ? Status::Broken : Status::Completed;
  for (const double end : ends) {
    if (std::isfinite(end)) continue;
    response.status = Status::NonFinite;
    response.samples = finite_samples(response, model.drive.size());
    return;
  }
}

/// Whether the law's numbers are usable: products of valid parameters can overflow or vanish.
bool representable(const coupon::CouponMaterial<double>& m) {
  return std::isfinite(m.stiffness) && std::isfinite(1.0 / m.stiffness) && std::isfinite(m.yield) &&
         m.yield > 0.0;
}

/// Empties the response and sets the numbers of the run. Whether it can go on; if not, the status
/// says why.
bool begin(const Model& model, ParameterValues values, MaterialValues<double>& material,
           coupon::CouponMaterial<double>& m, Response& response) {
  if (!take_parameters(model, values, material)) {
    response.status = Status::InvalidParameter;
    return false;
  }
  m = coupon::coupon_material(model.coupon, material);
  if (!representable(m)) {
    response.status = Status::NonFinite;
    return false;
  }
  return true;
}

/// Follows the curve as often as its parameters need.
void differentiate(const Model& model, ParameterValues values, Response& response,
                   Sensitivity& sensitivity) {
  MaterialValues<double> material = model.material;
  set_parameters(model, values, material);
  // Each gives the same bits.
  const coupon::SlopeKernel kernel = coupon::slope_kernel(resolved(InstructionSet::Auto));
  for (std::size_t first = 0; first < values.size(); first += coupon::kMaxSlopes) {
    const std::size_t n_slopes = std::min(values.size() - first, coupon::kMaxSlopes);
    std::array<std::size_t, coupon::kMaxSlopes> fields{};
    for (std::size_t i = 0; i < n_slopes; ++i) {
      fields[i] = static_cast<std::size_t>(*model.parameters[first + i]->material);
    }
    kernel({.shape = &model.coupon,
            .material = material.data(),
            .fields = fields.data(),
            .n_slopes = n_slopes,
            .strain = model.drive.data(),
            .n_samples = model.drive.size(),
            .stress = response.probes[0].data(),
            .slopes = sensitivity.stress.data() + first,
            .stride = values.size(),
            .permanent = &response.permanent_strain,
            .permanent_slopes = sensitivity.permanent_strain.data() + first});
  }
}

void run_chain(const Model& model, ParameterValues values, Workspace& workspace,
               Response& response) {
  MaterialValues<double> material;
  if (!take_parameters(model, values, material)) {
    response.status = Status::InvalidParameter;
    return;
  }
  workspace.chain->run(material, workspace, response);
}

/// @throws std::invalid_argument
void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("plastica::run: ") + what);
}

/// Whether a response has room for what a model gives.
bool has_room(const Model& model, const Response& response) {
  const ResponseSize size = response_size(model);
  const auto fits = [&](const std::vector<double>& probe) { return probe.size() == size.samples; };
  if (response.probes.size() != size.probes || !std::ranges::all_of(response.probes, fits)) {
    return false;
  }
  if (!model.chain) return true;
  const ChainHistory& chain = response.chain;
  return chain.time.size() == size.samples && chain.frame_sample.size() == size.frames &&
         chain.rotation.size() == 3 * size.frames * size.segments &&
         chain.reaction.size() == 6 * size.frames * size.supports &&
         chain.velocity.empty() != size.in_motion;
}

void check_run(const Model& model, ParameterValues values, const Workspace& workspace,
               const Response& response) {
  require(model.chain || !model.drive.empty(), "a model that `prepare` has not made");
  require(values.size() == model.parameters.size(),
          "not a value for each of the model's parameters");
  require(!model.chain || (workspace.chain && workspace.model == model.chain),
          "a workspace that was not made for this model");
  require(has_room(model, response), "a response that was not made for this model");
}

bool stress_only(const Model& model) {
  return model.probes.size() == 1 && model.probes[0] == ProbeQuantity::Stress &&
         !model.coupon.breaks();
}

}  // namespace

bool take_parameters(const Model& model, ParameterValues values, MaterialValues<double>& material) {
  material = model.material;
  set_parameters(model, values, material);
  return valid(model, values, material);
}

void run(const Model& model, ParameterValues values, Workspace& workspace, Response& response) {
  check_run(model, values, workspace, response);
  clear_run(response);
  if (model.chain) {
    run_chain(model, values, workspace, response);
    return;
  }
  MaterialValues<double> material;
  coupon::CouponMaterial<double> m;
  if (!begin(model, values, material, m, response)) return;
  coupon::with_law(model.coupon.hardening, m, material, [&](const auto& law) {
    using Law = std::remove_cvref_t<decltype(law)>;
    if (stress_only(model)) {
      typename Law::State state;
      run_stress_only(model, law, response, state);
      response.permanent_strain = coupon::break_measure(model.coupon, state);
      finish(model, response, {response.probes[0].back(), state.plastic, state.accumulated});
      return;
    }
    Recorder<Law> recorder(model, law, m.limit, response);
    for (std::size_t i = 0; i < model.drive.size(); ++i) recorder.take(i, model.drive[i]);
    const auto& state = recorder.state();
    response.permanent_strain =
        recorder.cut() ? m.limit : coupon::break_measure(model.coupon, state);
    finish(model, response,
           {recorder.stress(), state.plastic, state.accumulated, recorder.dissipation()});
  });
}

void run_sensitivity(const Model& model, ParameterValues values, Workspace& workspace,
                     Response& response, Sensitivity& sensitivity) {
  check_run(model, values, workspace, response);
  require(
      !model.chain && stress_only(model),
      "a model that is not a coupon without a break limit and with the stress as its one probe");
  require(sensitivity.stress.size() == model.drive.size() * values.size() &&
              sensitivity.permanent_strain.size() == values.size(),
          "derivatives that were not made for this model");
  clear_run(response);
  if (values.empty()) {
    run(model, values, workspace, response);
    return;
  }
  MaterialValues<double> material;
  coupon::CouponMaterial<double> m;
  if (!begin(model, values, material, m, response)) return;
  differentiate(model, values, response, sensitivity);
  finish(model, response, {response.probes[0].back(), response.permanent_strain});
}

}  // namespace plastica
