#include "sweeps/stability/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "plastica/report/format.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/stability/audit.hpp"

namespace plastica::sweeps::stability {
namespace {

using enum Validity;

std::string percent(double fraction) { return report::significant(100.0 * fraction, 3) + " %"; }

/// The warning of a scene that names its steps; empty if there is none.
std::optional<std::string> step_warning(const Setup& setup) {
  for (const std::string& warning : scene_warnings(prepare(setup.scene, setup.solver))) {
    for (const std::string_view named : {"steps of ", "is of first order", "rho_infinity"}) {
      if (warning.find(named) != std::string::npos) return warning;
    }
  }
  return std::nullopt;
}

/// The energies of a path or motion [J]: the largest entry, and what counts most against it.
struct EnergyBalance {
  double size = 0.0;
  double residual = 0.0;    ///< largest |residual|
  double made = 0.0;        ///< by the scheme, at most
  double dissipated = 0.0;  ///< by the scheme, at most
};

EnergyBalance balance_of(const Response& response) {
  EnergyBalance balance;
  for (const Energies& e : std::span(response.chain.energy).first(response.samples)) {
    for (const double term : {e.elastic, e.kinetic, e.plastic, e.damping, e.impact, e.fracture,
                              e.external, e.numerical_dissipation}) {
      balance.size = std::max(balance.size, std::fabs(term));
    }
    balance.residual = std::max(balance.residual, std::fabs(e.residual));
    balance.made = std::max(balance.made, -e.numerical_dissipation);
    balance.dissipated = std::max(balance.dissipated, e.numerical_dissipation);
  }
  return balance;
}

/// A miss that nothing but a warning about the steps excuses.
Verdict missed(const Setup& setup, std::string reason) {
  if (setup.solver.analysis == Analysis::Dynamics) {
    if (const auto warning = step_warning(setup))
      return {Inaccurate, reason + "; warned: " + *warning};
  }
  return {Undetected, std::move(reason)};
}

std::optional<Verdict> check_kept(const Setup& setup, const Response& response,
                                  const Expectation& expected) {
  for (const Kept& kept : expected.kept) {
    const auto values = std::span(response.probes[kept.probe]).first(response.samples);
    double change = 0.0;
    for (const double value : values) change = std::max(change, std::fabs(value - values[0]));
    if (change <= kept.tolerance * kept.size) continue;
    return missed(setup, kept.what + " changes by " + percent(change / kept.size));
  }
  return std::nullopt;
}

std::optional<Verdict> check_references(const Setup& setup, const Response& response,
                                        const Expectation& expected) {
  std::optional<Verdict> coarse;
  for (const Reference& reference : expected.references) {
    const std::size_t sample =
        reference.sample == Reference::kLast ? response.samples - 1 : reference.sample;
    const double found = response.probes[reference.probe][sample];
    const double size = reference.size > 0.0 ? reference.size : std::fabs(reference.value);
    const double off = std::fabs(found - reference.value) / size;
    if (!(off <= reference.tolerance)) {
      return missed(setup, reference.what + " is off by " + percent(off) + ": " +
                               report::significant(found, 6) + " for " +
                               report::significant(reference.value, 6));
    }
    if (!reference.continuum || coarse) continue;
    const double beam = std::fabs(found - *reference.continuum) / size;
    if (beam > kAccurate) {
      coarse = Verdict{Inaccurate, reference.what + " of the chain is " + percent(beam) +
                                       " off the beam's: few segments"};
    }
  }
  return coarse;
}

std::optional<Verdict> check_limit(const Setup& setup, const Response& response,
                                   const Expectation& expected) {
  if (response.status != Status::LimitLoad) {
    if (!expected.limit) return std::nullopt;
    return Verdict{Undetected, "went on beyond the limit load factor of " +
                                   report::significant(*expected.limit)};
  }
  if (setup.scene.yield_model == YieldModel::Elastic) {
    if (expected.may_reverse) return Verdict{Failed, "limit-load"};
    return Verdict{Undetected, "a limit load of an elastic beam"};
  }
  if (!expected.limit) return std::nullopt;
  const double miss =
      std::max(*expected.limit - response.limit->above, response.limit->below - *expected.limit);
  if (miss <= kAccurate * *expected.limit) return std::nullopt;
  return Verdict{Undetected, "the limit load factor is " +
                                 report::significant(response.limit->below) + " for " +
                                 report::significant(*expected.limit)};
}

}  // namespace

Verdict judge(const Setup& setup, const Response& response, const Expectation& expected) {
  if (!is_complete(response.status)) return {Failed, std::string(name_of(response.status))};
  if (response.samples == 0) return {Undetected, "no sample"};
  if (!is_finite(setup, response)) return {Undetected, "a number is not finite"};

  const bool moves = setup.solver.analysis == Analysis::Dynamics && !setup.scene.is_coupon();
  const EnergyBalance balance = setup.scene.is_coupon() ? EnergyBalance{} : balance_of(response);
  if (moves && response.energy_balance_error > kBalanceTolerance) {
    if (balance.made > kAccurate * balance.size) {
      return {Inaccurate, "the scheme makes " + percent(balance.made / balance.size) +
                              " of the energy, as the energy balance states"};
    }
    return {Inaccurate, "the energy balance is off by " + percent(response.energy_balance_error)};
  }
  if (moves && response.momentum_error > kBalanceTolerance) {
    return {Inaccurate, "momentum is off by " + percent(response.momentum_error)};
  }
  if (const auto wrong = audit(setup, response)) return {Undetected, *wrong};
  if (expected.unstable && response.status == Status::Completed) {
    return {Undetected, "an unstable equilibrium"};
  }
  if (expected.breaks && response.status != Status::Broken) return {Undetected, "did not break"};
  if (balance.made > kAccurate * balance.size) {
    return missed(setup,
                  "the scheme makes " + percent(balance.made / balance.size) + " of the energy");
  }
  const bool dissipates = balance.dissipated > kAccurate * balance.size;
  Verdict stated{Inaccurate, "the scheme dissipates " + percent(balance.dissipated / balance.size) +
                                 " of the energy, as the energy balance states"};
  if (auto found = check_kept(setup, response, expected)) return dissipates ? stated : *found;
  if (auto found = check_limit(setup, response, expected)) return *found;
  if (response.status == Status::Completed) {
    if (auto found = check_references(setup, response, expected)) {
      return found->validity == Undetected && dissipates ? stated : *found;
    }
  }
  if (dissipates) return stated;
  if (!moves && balance.residual > kBalanceTolerance * balance.size) {
    return {Inaccurate, "the energy balance is off by " + percent(balance.residual / balance.size) +
                            ", as its residual states"};
  }
  return {};
}

}  // namespace plastica::sweeps::stability
