#pragma once

namespace plastica::cli {

/// What the command's exit code means; part of its interface.
enum ExitCode : int {
  kDone = 0,           ///< done and acceptable
  kNotAcceptable = 1,  ///< done, but a target has no usable fit, or a scene no equilibrium
  kBadInput = 2,       ///< one line on stderr says what is wrong with the input
  kMachineFailed = 3,  ///< disk, memory, a missing program
  kInterrupted =
      130,  ///< Ctrl-C, SIGTERM; what was finished is kept: fits for --resume, a motion in its file
};

}  // namespace plastica::cli
