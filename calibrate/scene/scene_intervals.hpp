#pragma once

#include "calibrate/fit/intervals.hpp"

namespace plastica::calibrate {

/// Intervals of fits through scenes are those of every fit.
using SceneIntervalOptions = IntervalOptions;
using SceneProfile = LikelihoodProfile;
using SceneBootstrap = BootstrapResult;
using SceneIntervals = FitIntervals;

}  // namespace plastica::calibrate
