#include "plastica/base/check.hpp"

namespace plastica {
namespace {

constexpr std::size_t kLongestFile = 4096;
constexpr std::size_t kLongestField = 200;
constexpr std::size_t kLongestValue = 80;
constexpr std::size_t kLongestRule = 2000;

/// What users wrote, and what quotes it, comes from files of any kind: a long or multi-line text
/// must not break the one-line rule.
std::string shown(std::string_view whole, std::size_t longest) {
  std::size_t size = whole.size();
  if (size > longest) {
    size = longest;
    // Not within a character of UTF-8.
    while (size > 0 && (static_cast<unsigned char>(whole[size]) & 0xC0U) == 0x80U) --size;
  }
  std::string text(whole.substr(0, size));
  for (char& c : text) {
    if ((static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7F') c = ' ';
  }
  if (size < whole.size()) text += "...";
  return text;
}

std::string message(const SourceLocation& where, std::string_view field, std::string_view value,
                    std::string_view rule) {
  std::string text;
  if (!where.file.empty()) {
    text += shown(where.file, kLongestFile);
    if (where.line > 0) text += ":" + std::to_string(where.line);
    text += ": ";
  }
  if (!field.empty()) {
    text += shown(field, kLongestField);
    if (!value.empty()) text += " = " + shown(value, kLongestValue);
    text += ": ";
  } else if (!value.empty()) {
    text += shown(value, kLongestValue) + ": ";
  }
  text += shown(rule, kLongestRule);
  return text;
}

}  // namespace

InputError::InputError(SourceLocation where, std::string_view field, std::string_view value,
                       std::string_view rule)
    : std::runtime_error(message(where, field, value, rule)),
      where_(std::move(where)),
      field_(field),
      value_(value),
      rule_(rule) {}

}  // namespace plastica
