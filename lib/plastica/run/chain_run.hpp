#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plastica/model/material_field.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/model.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// One of the scenarios that are stepped together.
struct LaneCase {
  const ChainModel* model = nullptr;
  const MaterialValues<double>* material = nullptr;  ///< of the scene's own material
  const Workspace* hooks = nullptr;
  Response* response = nullptr;
};

/// A chain that can be run again and again with other material numbers; one a thread.
class ChainProgram {
 public:
  virtual ~ChainProgram() = default;
  /// @param material  of the scene's own material; regions keep theirs
  /// @param hooks     what a motion tells and asks
  virtual void run(const MaterialValues<double>& material, const Workspace& hooks,
                   Response& response) = 0;
  /// Runs the first case and takes the others along as its companions (chain_companion.hpp), as
  /// far as that can be done.
  /// @param cases  the first with the program's model, the others of `may_accompany`
  /// @return which have their response; the first one has
  virtual std::vector<bool> run_with(std::span<const LaneCase> cases);
};

/// @param model  outlives the program
std::unique_ptr<ChainProgram> make_chain_program(const ChainModel& model);

}  // namespace plastica
