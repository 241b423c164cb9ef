#include "plastica/run/sample_warning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/first_frequency.hpp"
#include "plastica/run/natural_frequencies.hpp"

namespace plastica::run_detail {

std::optional<double> lowest_frequency(const Model& model) {
  constexpr int kRigid = 6;  // modes of motion of a body that nothing holds
  const int freedoms = chain_freedoms(model);
  if (freedoms == 0) return std::nullopt;  // supports hold all of its segments
  const auto all = unloaded_frequencies(model, std::min(freedoms, kRigid + 1));
  const auto first = std::ranges::find_if(all, [](double frequency) { return frequency > 0.0; });
  return first == all.end() ? std::nullopt : std::optional(*first);
}

/// A sampled swing of frequency f is another one, of a lower frequency, where the interval is above
/// 1/(2 f) (Nyquist). With n samples in a period the largest of them is at worst cos(pi/n) of the
/// swing.
std::optional<std::string> sample_warning(const Facts& facts) {
  using model_detail::figure;
  constexpr double kFew = 4.0;  // samples of a period
  constexpr double kEnough = 10.0;
  std::optional<double> frequency = lowest_frequency(facts.model);
  if (!frequency) return std::nullopt;
  std::string swing = "the unloaded beam swings at " + figure(*frequency) + " Hz and faster";
  const double duration = facts.model.chain->stops.back();
  // Of twists alone: few ask for the swings of a stretch, which takes too many samples.
  for (const auto& one : model_detail::excited_frequencies(
           facts.scene, facts.level, {JointTranslation::Rigid, duration}, facts.section,
           segment_ends(facts.scene))) {
    if (one.hertz <= *frequency) continue;
    frequency = one.hertz;
    swing = "the beam swings with its " + model_detail::frequency_text(one);
  }
  const double interval = duration / facts.options.steps;
  const double in_period = 1.0 / (*frequency * interval);
  if (in_period >= kFew) return std::nullopt;
  const std::string where = "samples every " + figure(interval) + " s: " + swing +
                            ", of which they keep " + figure(in_period) + " a period; ";
  const std::string advice =
      ": solver.steps = " + figure(std::ceil(duration * *frequency * kEnough)) + " has ten";
  if (in_period < 2.0) {
    return where + "frequencies, extremes and curves of such a swing are not those of the motion" +
           advice;
  }
  return where + "extremes lack up to " +
         figure(100.0 * (1.0 - std::cos(std::numbers::pi / in_period))) + " % of such a swing" +
         advice;
}

}  // namespace plastica::run_detail
