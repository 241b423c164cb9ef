#pragma once

#include <string>
#include <string_view>

namespace plastica::report {

/// Widest line of a report.
inline constexpr std::size_t kWidth = 100;

/// Puts ANSI colours around whole lines, or leaves them as they are.
class Ink {
 public:
  explicit Ink(bool color) : color_(color) {}
  std::string heading(std::string_view text) const { return inside("\x1b[1m", text); }
  std::string good(std::string_view text) const { return inside("\x1b[32m", text); }
  std::string bad(std::string_view text) const { return inside("\x1b[33m", text); }

 private:
  std::string inside(std::string_view start, std::string_view text) const {
    if (!color_) return std::string(text);
    const bool ends = text.ends_with('\n');
    if (ends) text.remove_suffix(1);
    return std::string(start) + std::string(text) + "\x1b[0m" + (ends ? "\n" : "");
  }

  bool color_;
};

}  // namespace plastica::report
