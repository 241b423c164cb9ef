#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "plastica/chain/layout.hpp"
#include "plastica/model/scene.hpp"

namespace plastica {

/// A joint that the scene cuts.
struct JointCut {
  double time = 0.0;     ///< [s]
  std::size_t node = 0;  ///< 0 … N
};

/// A checked scene of a chain, laid out once; shared by all threads that run it.
struct ChainModel {
  Scene scene;
  SolverOptions options;
  Level level = Level::Planar;
  std::size_t across = 1;  ///< Planar: 1 in the y-z plane, 0 in the x-z plane
  chain::Layout layout;
  std::vector<double> stops;              ///< times at which a step must end
  std::vector<bool> recorded;             ///< which of them are samples
  std::size_t samples = 0;                ///< the first one, at time 0, included
  std::vector<JointCut> cuts;             ///< by rising time, then joint
  std::vector<std::size_t> frame_sample;  ///< samples whose shape is kept, rising (n_frames)
};

}  // namespace plastica
