#pragma once

#include <memory>

#include "plastica/model/material_field.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/model.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// A chain that can be run again and again with other material numbers; one a thread.
class ChainProgram {
 public:
  virtual ~ChainProgram() = default;
  /// @param material  of the scene's own material; regions keep theirs
  /// @param hooks     what a motion tells and asks
  virtual void run(const MaterialValues<double>& material, const Workspace& hooks,
                   Response& response) = 0;
};

/// @param model  outlives the program
std::unique_ptr<ChainProgram> make_chain_program(const ChainModel& model);

}  // namespace plastica
