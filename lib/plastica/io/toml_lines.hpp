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
    std::size_t characters = 0;
    starts_.push_back({0, 0});
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (is_inside_character(i)) continue;
      if (characters % kStride == 0) marks_.push_back(i);
      ++characters;
      if (text[i] == '\n') starts_.push_back({i + 1, characters});
    }
  }

  /// How many there are; what follows the last end of line is one, though it may be empty.
  std::size_t count() const { return starts_.size(); }

  /// Offset of the line's first character; the text's size behind the last line.
  std::size_t start(std::size_t number) const {
    return number > starts_.size() ? text_.size() : starts_[number - 1].offset;
  }

  /// A line without its end.
  std::string_view line(std::size_t number) const {
    if (number < 1 || number > starts_.size()) return {};
    const std::size_t first = starts_[number - 1].offset;
    return text_.substr(first, text_.find_first_of("\r\n", first) - first);
  }

  std::string_view piece(const toml::source_region& region) const {
    const std::size_t begin = offset(region.begin);
    const std::size_t end = offset(region.end);
    return end > begin ? text_.substr(begin, end - begin) : std::string_view{};
  }

  /// Offset of a position, found in a time that does not grow with the line's length.
  std::size_t offset(const toml::source_position& position) const {
    if (position.line < 1 || position.line > starts_.size()) return text_.size();
    const std::size_t column = position.column < 1 ? 1 : position.column;
    const std::size_t character = starts_[position.line - 1].characters + column - 1;
    if (character / kStride >= marks_.size()) return text_.size();
    std::size_t at = marks_[character / kStride];
    for (auto left = character % kStride; left > 0 && at < text_.size(); --left) {
      ++at;
      while (at < text_.size() && is_inside_character(at)) ++at;
    }
    return at;
  }

 private:
  struct Start {
    std::size_t offset = 0;
    std::size_t characters = 0;  ///< before it in the whole text
  };

  static constexpr std::size_t kStride = 64;

  /// Whether a byte is one of a code point in UTF-8, but not its first.
  bool is_inside_character(std::size_t at) const {
    return (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U;
  }

  std::string_view text_;
  std::vector<Start> starts_;
  std::vector<std::size_t> marks_;  ///< offsets of every kStride-th code point
};

}  // namespace plastica::io
