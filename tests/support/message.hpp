#pragma once

#include <string>

#include "plastica/base/check.hpp"

namespace plastica::testing {

/// The whole line of the InputError that an action throws.
template <typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace plastica::testing
