#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

/// Names of input and result files that have changed. The old ones are read for one version: the
/// user is told the new one. Not installed.
namespace plastica {

struct Renamed {
  std::string_view before;
  std::string_view now;
};

/// Keys and words of input files; the words of result files, too.
inline constexpr std::array kRenamedWords{
    Renamed{"largest_turn", "largest_rotation"},      // scenes, solver
    Renamed{"ledger", "energy_balance"},              // check files, [[claim]]
    Renamed{"ledger_error", "energy_balance_error"},  // sweep files, error.quantity
    Renamed{"most_iterations", "max_iterations"},     // scenes, solver
    Renamed{"most_work", "max_work"},                 // check files, stability
    Renamed{"numerical", "numerical_dissipation"},    // scenes, energy of a probe
};

/// Datasets of result files, by their path from the root.
inline constexpr std::array kRenamedStored{
    Renamed{"options/setup/solver/largest_turn", "options/setup/solver/largest_rotation"},
    Renamed{"options/setup/solver/most_iterations", "options/setup/solver/max_iterations"},
    Renamed{"outcome/ledger_error", "outcome/energy_balance_error"},
    Renamed{"buckling/turn", "buckling/rotation"},
    Renamed{"critical_points/unstable_ways", "critical_points/unstable_modes"},
    Renamed{"energy/numerical", "energy/numerical_dissipation"},
    Renamed{"events/pieces/event", "events/fragments/event"},
    Renamed{"events/pieces/first", "events/fragments/first"},
    Renamed{"events/pieces/last", "events/fragments/last"},
    Renamed{"cases/ledger_error", "cases/energy_balance_error"},
};

/// The old name of what has this one now; empty if it never had another one.
constexpr std::string_view old_name(std::span<const Renamed> names, std::string_view now) {
  const auto found = std::ranges::find(names, now, &Renamed::now);
  return found == names.end() ? std::string_view{} : found->before;
}

/// The new name of what had this one; the name itself if it has not changed.
constexpr std::string_view new_name(std::span<const Renamed> names, std::string_view before) {
  const auto found = std::ranges::find(names, before, &Renamed::before);
  return found == names.end() ? before : found->now;
}

/// The path of a field, "solver.max_iterations", of one whose last name may be an old one.
inline std::string new_path(std::string_view path) {
  const std::size_t last = path.rfind('.') + 1;
  return std::string(path.substr(0, last)).append(new_name(kRenamedWords, path.substr(last)));
}

}  // namespace plastica
