#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plastica/model/item_field.hpp"
#include "plastica/model/support.hpp"

/// What the kinds of support are, a line each in support_kind.cpp. What they do to the beam is in
/// chain/builder.hpp, by the traits and not by the kinds.
namespace plastica {

struct SupportTraits {
  SupportKind kind{};
  std::string_view word;  ///< in files
  HeldFreedoms held{};    ///< rigidly, unless `hold` of a support says otherwise
  /// Why a support of the kind has no `hold`; empty: it may have one.
  std::string_view no_hold{};
  bool springs = false;     ///< holds by springs, at a place or along a length
  bool normal = false;      ///< acts along its normal
  bool any_normal = false;  ///< whose default no file has to give
  bool one_sided = false;   ///< pushes along its normal, and never pulls
  bool releases = false;    ///< holds nothing: the beam itself turns freely there
  int symbol = 0;           ///< gnuplot's point type; squares hold rotations
};

/// All kinds, in the order of `SupportKind`.
std::span<const SupportTraits> support_traits();
inline const SupportTraits& traits_of(const Support& support) {
  return support_traits()[static_cast<std::size_t>(support.kind)];
}

/// A number of supports, and whose it is.
struct SupportField : ItemField<Support> {
  bool SupportTraits::*of = nullptr;  ///< null: of all kinds

  bool belongs_to(const Support& support) const { return of == nullptr || traits_of(support).*of; }
};
std::span<const SupportField> support_fields();

/// "kind = \"pillar\" or \"inclined_roller\"": the kinds that have a trait.
std::string kinds_with(bool SupportTraits::*trait);

}  // namespace plastica
