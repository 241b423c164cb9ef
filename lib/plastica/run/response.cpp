#include "plastica/run/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica {

double energy_balance_error(std::span<const Energies> samples, double rounding) {
  double largest = rounding;
  double wrong = 0.0;
  for (const Energies& energy : samples) {
    wrong = std::max({wrong, std::fabs(energy.residual), -energy.numerical_dissipation});
    for (const double entry :
         {energy.elastic, energy.kinetic, energy.plastic, energy.damping,
          energy.numerical_dissipation, energy.impact, energy.fracture, energy.external}) {
      largest = std::max(largest, std::fabs(entry));
    }
  }
  return largest > 0.0 ? wrong / largest : 0.0;
}

void set_energy_balance(double length, Response& response) {
  // A position has the rounding of the beam's length, a rotation that of 1; sums over steps have
  // more.
  constexpr double kRounding = 100.0 * std::numeric_limits<double>::epsilon();
  double largest = 0.0;
  const std::vector<double>& reaction = response.chain.reaction;
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    const double arm = i % 6 < 3 ? length : 1.0;
    largest = std::max(largest, arm * std::fabs(reaction[i]));
  }
  response.energy_balance_error = energy_balance_error(
      std::span(response.chain.energy).first(response.samples), kRounding * largest);
}

void clear_run(Response& response) {
  response.status = Status::NotRun;
  response.samples = 0;
  response.permanent_strain = 0.0;
  response.event.reset();
  response.chain.events.clear();
  response.counters = {};
  response.limit.reset();
  response.plateau.reset();
  response.critical.reset();
  response.buckling.reset();
  response.vibration.reset();
  response.axial.reset();
  response.unheld_thrust = false;
  response.seconds = 0.0;
  clear_motion(response);
}

void clear_motion(Response& response) {
  response.energy_balance_error = response.momentum_error = 0.0;
  response.shortest_step = response.longest_step = 0.0;
}

void note_step(double step, Response& response) {
  const bool first = response.longest_step == 0.0;
  response.shortest_step = first ? step : std::min(response.shortest_step, step);
  response.longest_step = std::max(response.longest_step, step);
}

void judge_balance(Response& response) {
  const bool ended = response.status == Status::Completed || response.status == Status::Broken;
  if (ended && !response.balances()) response.status = Status::NotBalanced;
}

}  // namespace plastica
