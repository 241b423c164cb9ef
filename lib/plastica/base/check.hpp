#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace plastica {

/// Where in the user's input something was read.
struct SourceLocation {
  std::string file;  ///< path as the user gave it; empty for values set by a program
  int line = 0;      ///< first line is 1; 0 where a file has no lines or none applies
};

/// Bad input: one line that names file, line, field, value and the rule that the value breaks.
///
/// `what()` reads `FILE:LINE: FIELD = VALUE: RULE`; parts that are empty are left out.
/// The command turns it into exit code 2; a batch, into one rejected case.
class InputError : public std::runtime_error {
 public:
  /// @param where  file and line of the value
  /// @param field  name of the field, column or option, as the user writes it
  /// @param value  the value as the user wrote it
  /// @param rule   what is allowed, in words: "must be positive", "is not a unit of stress"
  InputError(SourceLocation where, std::string_view field, std::string_view value,
             std::string_view rule);

  const SourceLocation& where() const { return where_; }
  const std::string& field() const { return field_; }
  const std::string& value() const { return value_; }
  const std::string& rule() const { return rule_; }

 private:
  SourceLocation where_;
  std::string field_;
  std::string value_;
  std::string rule_;
};

}  // namespace plastica
