#pragma once

#include <stdexcept>

namespace plastica {

/// The machine failed, not the input: a program is missing, a file cannot be written.
/// The command turns it into exit code 3.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace plastica
