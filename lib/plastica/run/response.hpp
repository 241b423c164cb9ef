#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/base/status.hpp"

namespace plastica {

/// A joint went over its break limit.
struct BreakEvent {
  std::size_t sample = 0;         ///< first sample of the drive at which the limit is exceeded
  double strain = 0.0;            ///< total strain at which it was reached, between two samples [1]
  double stress = 0.0;            ///< that the beam carried there [Pa]
  double permanent_strain = 0.0;  ///< the limit that was reached, in the break measure [1]
  double dissipation = 0.0;       ///< plastic work per volume up to there [J/m^3]
};

/// What a run gives; sized by `make_response`, so that `run` does not allocate.
struct Response {
  Status status = Status::NotRun;
  /// Values of each probe at each sample (n_probes x n_samples), in the order of the scene.
  std::vector<std::vector<double>> probes;
  std::size_t samples = 0;  ///< samples that are valid; all of them if the status is usable
  /// Break measure at the last sample, or at the break of a beam that was cut there [1].
  double permanent_strain = 0.0;
  std::optional<BreakEvent> event;
};

/// Derivatives of a response by the model's parameters; sized by `make_sensitivity`.
struct Sensitivity {
  std::vector<double> stress;            ///< d stress / d parameter (n_samples x n_parameters)
  std::vector<double> permanent_strain;  ///< d permanent_strain / d parameter (n_parameters)
};

}  // namespace plastica
