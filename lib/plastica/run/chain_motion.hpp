#pragma once

#include <memory>

#include "plastica/chain/view.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_run.hpp"

namespace plastica {

/// The program of one level in dynamics. Instantiated for the levels with double
/// (chain_motion_*.cpp), each compiled by itself, and with float (chain_float*.cpp).
/// @param model  outlives the program
template <class L, bool kElastic>
std::unique_ptr<ChainProgram> make_motion_runner(const ChainModel& model,
                                                 const chain::View<L>& view);

}  // namespace plastica
