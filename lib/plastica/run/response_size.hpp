#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plastica/base/machine_memory.hpp"
#include "plastica/run/model.hpp"

namespace plastica {

struct ChainModel;

/// How large a scene's response is: `make_response` lays it out by these numbers.
struct ResponseSize {
  std::size_t samples = 0;
  std::size_t probes = 0;
  std::size_t frames = 0;    ///< samples that keep their shape; 0 of a coupon
  std::size_t segments = 0;  ///< N; 0 of a coupon
  std::size_t supports = 0;
  std::size_t modes = 0;   ///< of buckling and vibration
  bool in_motion = false;  ///< whether its frames have velocities

  /// Bytes that the response's numbers take.
  std::size_t bytes() const;
  /// The same with the least that model and program take besides.
  std::size_t needed_bytes() const;

  friend bool operator==(const ResponseSize&, const ResponseSize&) = default;
};

/// Lays nothing out: a scene of any size may be asked about, checked or not.
ResponseSize response_size(const Scene& scene, const SolverOptions& options);
ResponseSize response_size(const ChainModel& model);
ResponseSize response_size(const Model& model);

/// Refuses a scene whose response, model and program do not fit into memory.
/// @param memory  that there is [bytes]
/// @throws InputError with what it takes, what there is, and which fields make it so much
void check_memory(const Scene& scene, const SolverOptions& options,
                  std::size_t memory = machine_memory());

/// Refuses cases of which as many as there are threads do not fit into memory side by side.
/// @param needed  `needed_bytes` of all of them [bytes] (n_cases)
/// @throws InputError
void check_memory(std::vector<std::size_t> needed, int threads,
                  std::size_t memory = machine_memory());

/// "3.36 GB", in units of 1000.
std::string bytes_text(std::size_t bytes);

}  // namespace plastica
