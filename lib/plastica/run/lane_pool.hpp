#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/run/lane_program.hpp"

namespace plastica {

/// A case that is laid out and waits for others of its shape.
struct WaitingCase {
  std::size_t index = 0;  ///< in the batch
  std::unique_ptr<Model> model;
  BatchRow row;
  Workspace hooks;
};

/// Collects cases of lane programs and runs them when there are enough of a shape; one a thread.
class LanePool {
 public:
  using Take = std::function<void(std::size_t index, BatchRow&& row)>;

  /// Takes a case in, and runs those of its shape if a program is full.
  /// @param one   of `has_lanes`
  /// @param take  called with the rows of the cases that were run
  /// @throws InputError as `make_lane_program`; the case is given back in `one`
  void add(WaitingCase&& one, const Take& take);

  /// Takes in all that wait in another one.
  void merge(LanePool&& other, const Take& take);

  /// Runs all that wait, in programs that are not full.
  void finish(const Take& take);

 private:
  struct Shape {
    std::unique_ptr<LaneProgram> program;
    std::vector<WaitingCase> waiting;
  };

  static void run(Shape& shape, const Take& take);

  std::vector<Shape> shapes_;
};

/// CPU time of this thread so far [s]: what else the machine does is not counted.
double thread_seconds();

}  // namespace plastica
