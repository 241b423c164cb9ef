#pragma once

#include <string>

#include "plastica/io/scene_file.hpp"
#include "sweeps/advise/advice.hpp"

namespace plastica::cli {

/// What `advise --for ENGINE` is asked for.
struct EngineAdviceRequest {
  std::string engine;
  std::string scene;   ///< file
  std::string output;  ///< the beam, for the engine; empty: not written
  std::string json;    ///< likewise
  sweeps::AdviceOptions options;
  bool force = false;
  bool quiet = false;
};

/// Refuses an engine that is not known, and an output that is no file of it. @throws InputError
void check_engine_request(const EngineAdviceRequest& request);

/// Advises, prints the advice, and writes what is asked for.
/// @return exit code: 0, 1 if there is no setting within the error, 130 if interrupted
/// @throws InputError
int advise_for_engine(EngineAdviceRequest request, const io::SceneFile& file);

}  // namespace plastica::cli
