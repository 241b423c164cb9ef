#pragma once

#include <array>

#include "plastica/io/scene_store.hpp"
#include "plastica/io/value_rule.hpp"

/// What the file of a simulated scene must hold beyond types and shapes, which its layout says
/// (scene_layout.hpp); not installed.
namespace plastica::io {

/// The numbers that are not just finite, or not negative; those of a table of fields have its
/// range.
inline constexpr std::array kSceneRules{
    ValueRule{"supports/at", kFraction},
    ValueRule{"supports/to", kFraction, Order::Any, true},
    ValueRule{"loads/at", kFraction},
    ValueRule{"loads/to", kFraction, Order::Any, true},
    ValueRule{"masses/at", kFraction},
    ValueRule{"gravity/history_time", kNotNegative, Order::RisesStrictly},
    ValueRule{"initial_motions/from", kFraction},
    ValueRule{"initial_motions/to", kFraction},
    ValueRule{"initial_motions/about", kFraction},
    ValueRule{"cuts/at", kFraction},
    ValueRule{"cuts/time", kNotNegative},
    ValueRule{"options/beam/segment_fractions", kAboveZero},
    ValueRule{"options/beam/joint_lengths", kAboveZero},
    ValueRule{"options/control/at", kFraction, Order::Any, true},
    ValueRule{"beam/ends", kFraction, Order::RisesStrictly},
    ValueRule{"beam/joint_length", kAboveZero},
    ValueRule{"beam/width", kAboveZero},
    ValueRule{"beam/height", kAboveZero},
    ValueRule{"beam/modulus", kAboveZero},
    ValueRule{"beam/strain_per_angle", kNotNegative},
    ValueRule{"probes/at", kFraction},
    ValueRule{"path/frame_sample", {}, Order::RisesStrictly},
    ValueRule{"outcome/energy_balance_error", kNotNegative},
    ValueRule{"outcome/momentum_error", kNotNegative},
    ValueRule{"outcome/shortest_step", kNotNegative},
    ValueRule{"outcome/longest_step", kNotNegative},
    ValueRule{"meta/run_seconds", kNotNegative},
};

/// Whether all that was read goes together: samples, frames, joints, segments, events.
/// @throws InputError that names what does not
void check_agreement(const Hdf5Group& root, const SceneRecord& record);

}  // namespace plastica::io
