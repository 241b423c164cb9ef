#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "plastica/model/field.hpp"

/// How the field table reaches into a Setup; not installed.
namespace plastica::model_detail {

/// `find_field` in any table.
const Field& find_in(std::span<const Field> table, std::string_view name,
                     const SourceLocation& where);

inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range kNotNegative{0.0};

/// Reaches a member of a setup.
#define PLASTICA_REACH(member) \
  [](auto& setup) -> auto& { return setup.member; }

/// The words of a choice, in the order of its enumerators.
template <class Enum>
std::span<const std::string_view> words();

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// @tparam Reach  a lambda from a (const) Setup to a reference of the member
template <auto Reach>
FieldValue get_member(const Setup& setup) {
  const auto& member = Reach(setup);
  using T = std::remove_cvref_t<decltype(member)>;
  if constexpr (IsOptional<T>::value) {
    if (!member) return std::monostate{};
    return *member;
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(words<T>()[static_cast<std::size_t>(member)]);
  } else {
    return static_cast<double>(member);
  }
}

template <auto Reach>
void set_member(Setup& setup, const FieldValue& value) {
  auto& member = Reach(setup);
  using T = std::remove_cvref_t<decltype(member)>;
  if constexpr (IsOptional<T>::value) {
    if (const double* number = std::get_if<double>(&value)) {
      member = *number;
    } else {
      member.reset();
    }
  } else if constexpr (std::is_enum_v<T>) {
    const auto list = words<T>();
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i] == std::get<std::string>(value)) member = static_cast<T>(i);
    }
  } else {
    member = static_cast<T>(std::get<double>(value));
  }
}

template <auto Reach>
constexpr Field number(std::string_view path, Dimension dimension, Range range,
                       std::string_view doc, std::optional<MaterialField> material = {}) {
  return {path,     FieldKind::Number,  dimension,         range, {}, doc,
          material, &get_member<Reach>, &set_member<Reach>};
}

template <auto Reach>
constexpr Field integer(std::string_view path, Range range, std::string_view doc) {
  return {path, FieldKind::Integer, Dimension::None,   range, {}, doc,
          {},   &get_member<Reach>, &set_member<Reach>};
}

template <auto Reach>
Field choice(std::string_view path, std::string_view doc) {
  using T = std::remove_cvref_t<decltype(Reach(std::declval<Setup&>()))>;
  return {path, FieldKind::Choice,  Dimension::None,   {}, words<T>(), doc,
          {},   &get_member<Reach>, &set_member<Reach>};
}

}  // namespace plastica::model_detail
