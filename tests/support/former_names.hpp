#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plastica/base/former_names.hpp"

namespace plastica::testing {

/// Collects what is said of former names while it lives: "FILE:LINE: BEFORE is now NOW".
class FormerNames {
 public:
  FormerNames()
      : before_(listen_to_former_names(
            [this](const SourceLocation& where, std::string_view before, std::string_view now) {
              notes_.push_back(where.file + ':' + std::to_string(where.line) + ": " +
                               std::string(before) + " is now " + std::string(now));
            })) {}
  ~FormerNames() { listen_to_former_names(std::move(before_)); }
  FormerNames(const FormerNames&) = delete;
  FormerNames& operator=(const FormerNames&) = delete;

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<std::string> notes_;
  FormerNameListener before_;
};

}  // namespace plastica::testing
