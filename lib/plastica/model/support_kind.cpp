#include "plastica/model/support_kind.hpp"

#include <algorithm>
#include <array>

#include "plastica/model/field_table.hpp"

namespace plastica {
namespace {

constexpr std::array<SupportTraits, 8> kTraits{{
    {.kind = SupportKind::Clamp,
     .word = "clamp",
     .held = {true, true, true, true, true, true},
     .symbol = 5},
    {.kind = SupportKind::Pin,
     .word = "pin",
     .held = {true, true, true, false, false, true},
     .symbol = 9},
    {.kind = SupportKind::Roller,
     .word = "roller",
     .held = {true, true, false, false, false, false},
     .symbol = 6},
    {.kind = SupportKind::Guide,
     .word = "guide",
     .held = {false, false, false, true, true, true},
     .symbol = 4},
    {.kind = SupportKind::Elastic, .word = "elastic", .springs = true, .symbol = 12},
    {.kind = SupportKind::Pillar,
     .word = "pillar",
     .no_hold = "a pillar only pushes; what holds is another support",
     .normal = true,
     .any_normal = true,
     .one_sided = true,
     .symbol = 8},
    {.kind = SupportKind::InclinedRoller,
     .word = "inclined_roller",
     .no_hold = "an inclined roller holds along its normal; what else holds is another support",
     .normal = true,
     .symbol = 7},
    {.kind = SupportKind::Hinge,
     .word = "hinge",
     .no_hold = "a hinge lets go; what holds the beam there is another support",
     .releases = true,
     .symbol = 14},
}};

consteval bool in_order() {
  for (std::size_t i = 0; i < kTraits.size(); ++i) {
    if (static_cast<std::size_t>(kTraits[i].kind) != i) return false;
  }
  return true;
}
static_assert(in_order(), "kinds are in the order of their enumerators");

}  // namespace

std::span<const SupportTraits> support_traits() { return kTraits; }

std::span<const SupportField> support_fields() {
  using enum VectorSense;
  constexpr auto kSprings = &SupportTraits::springs;
  constexpr auto kNormal = &SupportTraits::normal;
  constexpr auto kOneSided = &SupportTraits::one_sided;
  using model_detail::kNotNegative;
  // A bed has force per length and way, the unit of a stress.
  static constexpr std::array<SupportField, 7> kFields{{
      {{"stiffness", &Support::stiffness, Dimension::Stiffness, Dimension::Stress, kNotNegative,
        "k_"},
       kSprings},
      {{"rotational_stiffness",
        &Support::rotational_stiffness,
        Dimension::RotationalStiffness,
        {},
        kNotNegative,
        "k_r"},
       kSprings},
      {{"normal", &Support::normal, Dimension::None, {}, {}, "", Push}, kNormal},
      {{"gap", &Support::gap, Dimension::Length, {}, kNotNegative, "gap "}, kOneSided},
      {{"restitution", &Support::restitution, Dimension::None, {}, {0.0, 1.0}, "restitution "},
       kOneSided},
      {{"translation", &Support::translation, Dimension::Length, {}, {}, "", Push}},
      {{"rotation", &Support::rotation, Dimension::Angle, {}, {}, "r", Rotate}},
  }};
  return kFields;
}

std::string kinds_with(bool SupportTraits::*trait) {
  std::string text;
  for (const SupportTraits& kind : kTraits) {
    if (!(kind.*trait)) continue;
    text += (text.empty() ? "kind = \"" : " or \"") + std::string(kind.word) + '"';
  }
  return text;
}

std::span<const std::string_view> support_kinds() {
  static const auto kWords = [] {
    std::array<std::string_view, kTraits.size()> words;
    std::ranges::transform(kTraits, words.begin(), &SupportTraits::word);
    return words;
  }();
  return kWords;
}

HeldFreedoms Support::held() const { return hold ? *hold : traits_of(*this).held; }

bool Support::has_normal() const { return traits_of(*this).normal; }

}  // namespace plastica
