#pragma once

#include <toml++/toml.h>

#include <string_view>
#include <vector>

namespace plastica::io {

/// A text without UTF-8's byte order mark, which the columns do not count.
inline std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

/// Cuts pieces out of the text by line and column, both from 1; columns count code points.
class TomlLines {
 public:
  explicit TomlLines(std::string_view text) : text_(text) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') starts_.push_back(i + 1);
    }
  }

  /// How many there are; what follows the last end of line is one, though it may be empty.
  std::size_t count() const { return starts_.size(); }

  /// Offset of the line's first character; the text's size behind the last line.
  std::size_t start(std::size_t number) const {
    return number > starts_.size() ? text_.size() : starts_[number - 1];
  }

  /// A line without its end.
  std::string_view line(std::size_t number) const {
    if (number < 1 || number > starts_.size()) return {};
    const std::size_t first = starts_[number - 1];
    return text_.substr(first, text_.find_first_of("\r\n", first) - first);
  }

  std::string_view piece(const toml::source_region& region) const {
    const std::size_t begin = offset(region.begin);
    const std::size_t end = offset(region.end);
    return end > begin ? text_.substr(begin, end - begin) : std::string_view{};
  }

  std::size_t offset(const toml::source_position& position) const {
    if (position.line < 1 || position.line > starts_.size()) return text_.size();
    std::size_t at = starts_[position.line - 1];
    for (auto column = position.column; column > 1 && at < text_.size(); --column) {
      ++at;
      while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U) ++at;
    }
    return at;
  }

 private:
  std::string_view text_;
  std::vector<std::size_t> starts_;
};

}  // namespace plastica::io
