#pragma once

#include <span>
#include <string>

#include "plastica/run/model.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Checks a scene, chooses its level and lays out a model, once.
/// @param parameters  paths of the fields that each `run` sets; others keep the scene's value. Of a
///                    chain, break strains are none, and shear values only where the scene sets
///                    them
/// @throws InputError naming the field that is out of range, does not fit, or cannot be a
///         parameter at this level
Model prepare(const Scene& scene, const SolverOptions& options = {},
              std::span<const std::string> parameters = {});

/// A response with room for a model's probes and samples.
Response make_response(const Model& model);
/// Derivatives with room for a model's samples and parameters.
Sensitivity make_sensitivity(const Model& model);
Workspace make_workspace(const Model& model);

/// Runs a model. Neither checks the scene again nor allocates (but for a chain's laws, once
/// whenever its material differs from the run before, and a break event); any number of threads may
/// run one model, each with its own workspace and response.
/// @param values  SI, in the order of `model.parameters` (n_parameters)
/// @param workspace, response  made for this model
/// @throws std::invalid_argument for too few or too many values, a workspace that was made for
///         another model, or a response of another size
void run(const Model& model, ParameterValues values, Workspace& workspace, Response& response);

/// Runs a model and differentiates the stress at each sample, and the permanent strain at the end,
/// by the parameters (exactly, with dual numbers). Probes of the response are filled as by `run`.
/// A cut has no derivative: the model is a coupon without a break limit, and the stress its one
/// probe.
/// @throws std::invalid_argument as `run`, and for a model or derivatives that are not so
void run_sensitivity(const Model& model, ParameterValues values, Workspace& workspace,
                     Response& response, Sensitivity& sensitivity);

/// `prepare` and `run` in a row, for a scene that is run once.
/// @param on_break  decides at each break of a motion what is cut; may be empty
/// @throws InputError as `prepare` and `check_memory`
Response simulate(const Scene& scene, const SolverOptions& options = {},
                  const BreakListener& on_break = {});

}  // namespace plastica
