#pragma once

#include <cstddef>
#include <optional>

namespace plastica::cli {

/// This process among those that mpirun or srun has started.
struct Launched {
  std::size_t rank = 0;  ///< 0 … count-1
  std::size_t count = 1;
};

/// What the launcher says in the environment; empty where this process was started alone.
/// @throws InputError if it says no numbers
std::optional<Launched> launched();

}  // namespace plastica::cli
