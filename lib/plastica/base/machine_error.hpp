#pragma once

#include <stdexcept>

namespace plastica {

/// The machine failed, not the user's input, which is an InputError: a program is missing, the
/// memory is full. io::StorageError, the one of files, is one of these; the command turns all of
/// them into exit code 3.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace plastica
