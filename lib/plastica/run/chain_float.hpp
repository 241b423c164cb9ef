#pragma once

#include <memory>

#include "plastica/chain/view.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_run.hpp"

namespace plastica {

/// The program of one level with float numbers (chain_float_*.cpp): statics, dynamics and laws,
/// each level compiled by itself.
/// @param model  outlives the program
std::unique_ptr<ChainProgram> make_float_program(const ChainModel& model,
                                                 const chain::View<chain::Twist<float>>& view);
std::unique_ptr<ChainProgram> make_float_program(const ChainModel& model,
                                                 const chain::View<chain::Planar<float>>& view);
std::unique_ptr<ChainProgram> make_float_program(const ChainModel& model,
                                                 const chain::View<chain::Spatial<float>>& view);

}  // namespace plastica
