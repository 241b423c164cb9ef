#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/advise/for_engine/engine_advice.hpp"
#include "tests/support/chain_scene.hpp"

/// Advice for an engine is run in that engine, and held against a truth that knows nothing of it.
namespace plastica::testing {

/// What the probes of a scene show, at each sample (n_probes x n_samples).
using Histories = std::vector<std::vector<double>>;

/// The error of a history as the advice measures it, computed here anew: of the history the root
/// mean square over that of the truth, of the largest size and of the last value the difference
/// over the truth's largest size.
inline double error_of(const std::vector<double>& history, const std::vector<double>& truth) {
  double squares = 0.0;
  double difference = 0.0;
  double largest = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squares += truth[i] * truth[i];
    difference += (history[i] - truth[i]) * (history[i] - truth[i]);
    largest = std::max(largest, std::abs(history[i]));
    scale = std::max(scale, std::abs(truth[i]));
  }
  return std::max({std::sqrt(difference / squares), std::abs(largest - scale) / scale,
                   std::abs(history.back() - truth.back()) / scale});
}

/// The scene by our own dynamics, much finer than any advice here: 128 segments, 4000 steps, energy
/// conserved; joints that stretch and shear.
inline Histories truth_of(plastica::Setup setup) {
  setup.scene.beam.segments = 128;
  setup.solver.scheme = Scheme::EnergyMomentum;
  setup.solver.translation = JointTranslation::Elastic;
  setup.solver.time_step = setup.solver.duration / 4000.0;
  const Response response = completed(setup.scene, setup.solver);
  return response.probes;
}

/// Advises for some errors, and runs each advice in the engine.
/// @param run  Histories(const Setup&, const EngineAdvice&): by the engine itself
template <typename Run>
void expect_within(std::string_view engine, const std::string& text,
                   const std::vector<double>& errors, const Run& run) {
  const plastica::Setup setup = io::parse_scene_file(text, "scene.toml").setup;
  const Histories truth = truth_of(setup);
  for (const double within : errors) {
    SCOPED_TRACE(within);
    sweeps::AdviceOptions options;
    options.within = within;
    const sweeps::EngineAdvice advice =
        sweeps::advise_for_engine(*sweeps::advised_engine(engine), setup, options);
    ASSERT_EQ(advice.end, sweeps::EngineAdviceEnd::Found);
    EXPECT_LE(advice.promised, within);
    const Histories histories = run(setup, advice);
    double measured = 0.0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      measured = std::max(measured, error_of(histories[k], truth[k]));
    }
    ::testing::Test::RecordProperty("measured_within_" + std::to_string(within),
                                    std::to_string(measured));
    EXPECT_LE(measured, advice.promised);
    // Near what was asked for, so that it is not dearer than need be.
    EXPECT_GT(measured, 0.2 * within);
  }
}

}  // namespace plastica::testing
