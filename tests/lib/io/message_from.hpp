#pragma once

#include <string>

namespace plastica::io {

/// The message of the Error that an action throws; says so if it throws none.
template <typename Error, typename Action>
std::string message_from(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace plastica::io
