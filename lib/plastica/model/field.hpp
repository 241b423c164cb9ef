#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "plastica/base/check.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/model/material_field.hpp"
#include "plastica/model/scene.hpp"

/// The one table of every scene and solver field that a file may name.
///
/// The TOML reader, fit parameters, error lines, HDF5 attributes and `plastica fields` all read
/// it: a new field touches its struct and this table only.
namespace plastica {

/// A scene and how it is solved: what fields belong to.
struct Setup {
  Scene scene;
  SolverOptions solver;
};

/// Allowed numbers: low … high, each end included unless open.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  bool contains(double value) const;  ///< false for NaN and infinities
  std::string rule() const;           ///< "must be above 0", "must be from 0 to 1"
};

enum class FieldKind { Number, Integer, Choice };

/// A number in SI, a word of a choice, or nothing (an optional field that is not set).
using FieldValue = std::variant<std::monostate, double, std::string>;

struct Field {
  std::string_view path;  ///< "material.yield_stress", as in files
  FieldKind kind = FieldKind::Number;
  Dimension dimension = Dimension::None;
  Range range;                                ///< in SI; numbers and integers
  std::span<const std::string_view> choices;  ///< words of a choice
  std::string_view doc;                       ///< one line
  /// Set where a kernel can differentiate by the field: what a fit may move in a coupon test.
  std::optional<MaterialField> material;
  FieldValue (*get)(const Setup&) = nullptr;
  void (*set)(Setup&, const FieldValue&) = nullptr;  ///< unchecked; use `set_field`
};

/// All fields, in the order in which they are shown.
std::span<const Field> fields();

/// The field of a path, or of the last part of a path where that is unique ("yield_stress"). Former
/// names are names, too.
/// @throws InputError that names what there is
const Field& find_field(std::string_view name, const SourceLocation& where = {});

/// The field of exactly this path, or of this former one; null if there is none.
const Field* find_field_or_null(std::string_view path);

/// Checks a value against a field's range or choices and sets it.
/// @param shown  the value as the user wrote it, for the message; may be empty
/// @throws InputError naming file, line, field, value and rule
void set_field(Setup& setup, const Field& field, const FieldValue& value,
               const SourceLocation& where = {}, std::string_view shown = {});

/// Checks a number against a field's range. @throws InputError as above
void check_field(const Field& field, double value, const SourceLocation& where = {},
                 std::string_view shown = {});

/// A field's default, in SI or as a word; "unset" for an optional one.
std::string default_text(const Field& field);

}  // namespace plastica
