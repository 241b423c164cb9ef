#pragma once

#include <functional>
#include <memory>

#include "plastica/base/stop_flag.hpp"
#include "plastica/base/team_wire.hpp"

namespace plastica::cli {

/// What tells the processes of a team of a signal, while they wait for one another.
struct StopWatch {
  StopFlag stop = nullptr;
  /// Says so, where it is for this process to say; called from any thread, one call at a time,
  /// until it returns true.
  std::function<bool()> raised{};
};

/// The processes that an MPI launcher has started. Of processes of one machine at least: its
/// processors are theirs in equal parts.
class MpiWire : public TeamWire {
 public:
  /// How many threads each process may have without being in the way of others of its machine.
  virtual int threads() const = 0;
  virtual void watch(StopWatch watch) = 0;
};

/// Joins them. MPI ends with the wire. To be called once in a program.
/// @throws std::runtime_error if MPI fails
std::unique_ptr<MpiWire> join_mpi();

}  // namespace plastica::cli
