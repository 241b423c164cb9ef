#pragma once

#include <string>
#include <vector>

#include "plastica/model/field.hpp"
#include "plastica/run/response.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"
#include "sweeps/advise/watched_probes.hpp"

/// What of a scene an engine can run; not installed.
namespace plastica::sweeps {

/// Refuses what the beam for an engine does not hold: that the beam rests, supports off its start
/// or that move, spring or push, initial motions, cuts.
/// @throws InputError
void check_for_engine(const AdvisedEngine& engine, const Setup& setup);

/// Refuses a scene that yields or breaks, by a run of it.
/// @throws InputError
void check_elastic(const AdvisedEngine& engine, const Setup& setup, const Response& response);

/// The probes that an engine has: displacement, rotation, velocity and spin of points. Others are
/// left out, unless they were asked for by name.
/// @throws InputError as `watched_probes`, and for a name of a probe that the engine has not
WatchedProbes engine_probes(const Setup& setup, const std::vector<std::string>& names);

}  // namespace plastica::sweeps
