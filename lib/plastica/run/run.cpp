#include <algorithm>
#include <cassert>
#include <cmath>

#include "plastica/base/dual.hpp"
#include "plastica/coupon/material.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica {
namespace {

template <class S>
void set_parameters(const Model& model, ParameterValues values, MaterialValues<S>& material) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    material[static_cast<std::size_t>(*model.parameters[i]->material)] = S(values[i]);
  }
}

bool in_range(const Model& model, ParameterValues values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!model.parameters[i]->range.contains(values[i])) return false;
  }
  return true;
}

/// What every sample of a coupon adds to the response.
template <class Law>
class Recorder {
 public:
  using State = typename Law::State;

  Recorder(const Model& model, double limit, double stiffness, Response& response)
      : model_(model), limit_(limit), stiffness_(stiffness), response_(response) {}

  void take(std::size_t sample, double strain, const State& before,
            const law::UniaxialResponse<double, State>& now) {
    const double previous_stress = stress_;
    stress_ = now.stress;
    dissipation_ += 0.5 * (previous_stress + stress_) * (now.state.plastic - before.plastic);
    if (!response_.event) watch(sample, strain, now);
    record(sample, strain, now.state);
    strain_ = strain;
  }

 private:
  void watch(std::size_t sample, double strain, const law::UniaxialResponse<double, State>& now) {
    const double permanent = coupon::break_measure(model_.coupon, now.state);
    if (!(permanent > limit_)) return;
    BreakEvent event;
    event.sample = sample;
    const double direction = strain < strain_ ? -1.0 : 1.0;
    const double at =
        law::strain_at_break(strain, permanent - limit_, direction, now.tangent, stiffness_);
    event.strain = direction > 0.0 ? std::max(at, strain_) : std::min(at, strain_);
    event.stress = now.stress + now.tangent * (event.strain - strain);
    event.permanent_strain = limit_;
    event.dissipation = dissipation_;
    response_.event = event;
  }

  void record(std::size_t sample, double strain, const State& state) {
    const bool cut = response_.event && model_.on_break == BreakPolicy::CutAll;
    const double carried = cut ? 0.0 : stress_;
    for (std::size_t i = 0; i < model_.probes.size(); ++i) {
      double& out = response_.probes[i][sample];
      switch (model_.probes[i]) {
        case ProbeQuantity::Strain: out = strain; break;
        case ProbeQuantity::Stress: out = carried; break;
        case ProbeQuantity::PlasticStrain: out = state.plastic; break;
        case ProbeQuantity::AccumulatedStrain: out = state.accumulated; break;
        case ProbeQuantity::Load: out = carried * model_.coupon.load_per_stress; break;
        case ProbeQuantity::Dissipation: out = dissipation_; break;
      }
    }
  }

  const Model& model_;
  double limit_;
  double stiffness_;
  Response& response_;
  double strain_ = 0.0;
  double stress_ = 0.0;
  double dissipation_ = 0.0;
};

/// The fit's case, kept lean: only the stress is asked for, and nothing can break.
template <class Law>
void run_stress_only(const Model& model, const Law& law, Response& response,
                     typename Law::State& state) {
  double* out = response.probes[0].data();
  const double* strain = model.drive.data();
  const std::size_t samples = model.drive.size();
  for (std::size_t i = 0; i < samples; ++i) {
    const auto now = law::respond(law, state, strain[i]);
    state = now.state;
    out[i] = now.stress;
  }
}

void finish(const Model& model, Response& response, double last_stress) {
  response.samples = model.drive.size();
  if (!std::isfinite(last_stress) || !std::isfinite(response.permanent_strain)) {
    response.status = Status::NonFinite;
    response.samples = 0;
    return;
  }
  response.status = response.event ? Status::Broken : Status::Completed;
}

template <std::size_t N>
void sensitivity_chunk(const Model& model, ParameterValues values, std::size_t first,
                       Response& response, Sensitivity& sensitivity) {
  using D = Dual<double, N>;
  const std::size_t parameters = values.size();
  const std::size_t width = std::min(N, parameters - first);
  MaterialValues<D> material;
  for (std::size_t i = 0; i < kMaterialFields; ++i) material[i] = D(model.material[i]);
  set_parameters(model, values, material);
  for (std::size_t i = 0; i < width; ++i) {
    const auto field = static_cast<std::size_t>(*model.parameters[first + i]->material);
    material[field] = D::parameter(values[first + i], i);
  }
  const auto m = coupon::coupon_material(model.coupon, material);
  coupon::with_law(model.coupon.hardening, m, [&](const auto& law) {
    typename std::remove_cvref_t<decltype(law)>::State state;
    double* out = sensitivity.stress.data() + first;
    for (std::size_t s = 0; s < model.drive.size(); ++s, out += parameters) {
      const auto now = law::respond(law, state, D(model.drive[s]));
      state = now.state;
      response.probes[0][s] = now.stress.value;
      for (std::size_t i = 0; i < width; ++i) out[i] = now.stress.derivative[i];
    }
    const D permanent = coupon::break_measure(model.coupon, state);
    response.permanent_strain = permanent.value;
    for (std::size_t i = 0; i < width; ++i) {
      sensitivity.permanent_strain[first + i] = permanent.derivative[i];
    }
  });
}

bool stress_only(const Model& model) {
  return model.probes.size() == 1 && model.probes[0] == ProbeQuantity::Stress &&
         !model.coupon.breaks();
}

}  // namespace

void run(const Model& model, ParameterValues values, Workspace& /*workspace*/, Response& response) {
  assert(values.size() == model.parameters.size());
  response.event.reset();
  response.samples = 0;
  if (!in_range(model, values)) {
    response.status = Status::InvalidParameter;
    return;
  }
  MaterialValues<double> material = model.material;
  set_parameters(model, values, material);
  const auto m = coupon::coupon_material(model.coupon, material);
  coupon::with_law(model.coupon.hardening, m, [&](const auto& law) {
    using Law = std::remove_cvref_t<decltype(law)>;
    typename Law::State state;
    double stress = 0.0;
    if (stress_only(model)) {
      run_stress_only(model, law, response, state);
      stress = response.probes[0].back();
    } else {
      Recorder<Law> recorder(model, m.limit, m.stiffness, response);
      for (std::size_t i = 0; i < model.drive.size(); ++i) {
        const auto now = law::respond(law, state, model.drive[i]);
        recorder.take(i, model.drive[i], state, now);
        state = now.state;
        stress = now.stress;
      }
    }
    response.permanent_strain = coupon::break_measure(model.coupon, state);
    finish(model, response, stress);
  });
}

void run_sensitivity(const Model& model, ParameterValues values, Workspace& workspace,
                     Response& response, Sensitivity& sensitivity) {
  assert(values.size() == model.parameters.size());
  assert(stress_only(model));
  if (values.empty()) {
    run(model, values, workspace, response);
    return;
  }
  response.event.reset();
  response.samples = 0;
  if (!in_range(model, values)) {
    response.status = Status::InvalidParameter;
    return;
  }
  constexpr std::size_t kWidest = 8;
  for (std::size_t first = 0; first < values.size(); first += kWidest) {
    switch (std::min(values.size() - first, kWidest)) {
      case 1: sensitivity_chunk<1>(model, values, first, response, sensitivity); break;
      case 2: sensitivity_chunk<2>(model, values, first, response, sensitivity); break;
      case 3: sensitivity_chunk<3>(model, values, first, response, sensitivity); break;
      case 4: sensitivity_chunk<4>(model, values, first, response, sensitivity); break;
      default: sensitivity_chunk<kWidest>(model, values, first, response, sensitivity); break;
    }
  }
  finish(model, response, response.probes[0].back());
}

}  // namespace plastica
