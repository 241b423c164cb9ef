#pragma once

#include <exception>

namespace plastica::calibrate {

/// A fit was stopped before its end, as asked for.
class FitInterrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "the fit was interrupted"; }
};

}  // namespace plastica::calibrate
