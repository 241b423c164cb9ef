#include "plastica/model/support.hpp"

#include <algorithm>

namespace plastica {

std::span<const std::string_view> support_kinds() {
  static constexpr std::array<std::string_view, 8> kWords{
      "clamp", "pin", "roller", "guide", "elastic", "pillar", "inclined_roller", "hinge"};
  return kWords;
}

std::span<const std::string_view> freedom_names() {
  static constexpr std::array<std::string_view, 6> kWords{"x", "y", "z", "rx", "ry", "rz"};
  return kWords;
}

HeldFreedoms Support::held() const {
  if (hold) return *hold;
  switch (kind) {
    case SupportKind::Clamp: return {true, true, true, true, true, true};
    case SupportKind::Pin: return {true, true, true, false, false, true};
    case SupportKind::Roller: return {true, true, false, false, false, false};
    case SupportKind::Guide: return {false, false, false, true, true, true};
    case SupportKind::Elastic:
    case SupportKind::Pillar:
    case SupportKind::InclinedRoller:
    case SupportKind::Hinge: return {};
  }
  return {};
}

bool Support::has_normal() const {
  return kind == SupportKind::Pillar || kind == SupportKind::InclinedRoller;
}

bool Support::moves() const {
  const auto is_set = [](double component) { return component != 0.0; };
  return std::any_of(translation.begin(), translation.end(), is_set) ||
         std::any_of(rotation.begin(), rotation.end(), is_set);
}

}  // namespace plastica
