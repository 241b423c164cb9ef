#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "plastica/base/quantity.hpp"
#include "plastica/model/field.hpp"

/// The numbers of what a scene has several of (supports, loads, masses …), each described once.
///
/// Readers, checks, HDF5, digest, JSON, the report and the choice of the level go by these tables:
/// a new number touches its struct, its table and what it does.
namespace plastica {

/// What a vector does to the beam, where a level may not hold it.
enum class VectorSense { None, Push, Rotate };

template <class Item>
struct ItemField {
  using Vector = std::array<double, 3>;

  std::string_view key;  ///< as in files
  std::variant<double Item::*, Vector Item::*> member;
  Dimension dimension = Dimension::None;
  /// Of an item that reaches from one place to another, if that differs.
  std::optional<Dimension> per_length{};
  Range range{};              ///< of each number, in SI
  std::string_view symbol{};  ///< in the report before a number, or before an axis: "gap ", "F_"
  VectorSense sense = VectorSense::None;

  Dimension dimension_of(const Item& item) const {
    if constexpr (requires { item.to.has_value(); }) {
      if (item.to.has_value() && per_length) return *per_length;
    }
    return dimension;
  }
  /// Of all items, whether they reach or not; empty: of each its own.
  std::string_view unit() const { return per_length ? std::string_view() : si_unit(dimension); }
  /// Null if it is a vector.
  const double* number(const Item& item) const {
    const auto* member_of = std::get_if<double Item::*>(&member);
    return member_of ? &(item.**member_of) : nullptr;
  }
  std::span<const double> values(const Item& item) const {
    if (const double* one = number(item)) return {one, 1};
    return item.*std::get<Vector Item::*>(member);
  }
};

std::span<const ItemField<Load>> load_fields();
std::span<const ItemField<PointMass>> mass_fields();
std::span<const ItemField<InitialMotion>> initial_motion_fields();

}  // namespace plastica
