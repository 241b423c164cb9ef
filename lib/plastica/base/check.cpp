#include "plastica/base/check.hpp"

namespace plastica {
namespace {

/// Values come from files of any kind: a long or multi-line one must not break the one-line rule.
std::string shown(std::string_view value) {
  constexpr std::size_t kLongest = 80;
  std::string text(value.substr(0, kLongest));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  if (value.size() > kLongest) text += "...";
  return text;
}

std::string message(const SourceLocation& where, std::string_view field, std::string_view value,
                    std::string_view rule) {
  std::string text;
  if (!where.file.empty()) {
    text += where.file;
    if (where.line > 0) text += ":" + std::to_string(where.line);
    text += ": ";
  }
  if (!field.empty()) {
    text += field;
    if (!value.empty()) text += " = " + shown(value);
    text += ": ";
  } else if (!value.empty()) {
    text += shown(value) + ": ";
  }
  text += rule;
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
