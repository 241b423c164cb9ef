#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "plastica/base/stop_flag.hpp"

namespace plastica::python {

/// What long work is told, and says, from whichever thread it runs in.
struct Background {
  StopFlag stop;                             ///< raised by Ctrl-C
  std::function<void(double)> set_progress;  ///< how much is done, in the units of the caller
};

/// Does work without the interpreter's lock, in a thread of its own, while this one listens for
/// Ctrl-C and passes progress on. A thread of its own also has OpenMP's threads of its own: those
/// of a process that was forked meanwhile are gone.
/// @param progress  None, or a callable that is given the last progress, some ten times a second;
///                  what it raises stops the work
/// @throws what the work throws; KeyboardInterrupt, or what `progress` raised, once it has ended
void in_background(const std::function<void(const Background&)>& work,
                   const pybind11::object& progress);

/// The same of work that says nothing: what uses OpenMP must not do so in the caller's thread,
/// whose threads a forked process would wait for.
template <class Work>
auto in_background(const Work& work) {
  std::optional<decltype(work())> made;
  in_background([&](const Background&) { made.emplace(work()); }, pybind11::none());
  return std::move(*made);
}

}  // namespace plastica::python
