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
    Renamed{"drop_share", "drop_fraction"},            // fit files, corrections
    Renamed{"end_share", "end_fraction"},              // fit files, corrections
    Renamed{"kinematic_share", "kinematic_fraction"},  // material, hardening
    Renamed{"largest_turn", "largest_rotation"},       // scenes, solver
    Renamed{"largest", "max"},                         // sweep files, error.take
    Renamed{"least", "min"},                           // sweep files, error.take
    Renamed{"ledger", "energy_balance"},               // check files, [[claim]]
    Renamed{"ledger_error", "energy_balance_error"},   // sweep files, error.quantity
    Renamed{"most_iterations", "max_iterations"},      // scenes, solver
    Renamed{"most_work", "max_work"},                  // check files, stability
    Renamed{"numerical", "numerical_dissipation"},     // scenes, energy of a probe
    Renamed{"silent", "undetected"},                   // check files, [[claim]]
    Renamed{"strain-path", "path"},                    // fit files, objective
    Renamed{"unsound", "invalid"},                     // check files, [[claim]]
    Renamed{"zero_share", "zero_fraction"},            // fit files, corrections
};

/// Datasets and groups of result files, by the last part of their path.
inline constexpr std::array kRenamedStored{
    Renamed{"divided", "remeshed"},
    Renamed{"given_noise", "stated_noise"},
    Renamed{"kinematic_share", "kinematic_fraction"},
    Renamed{"largest_turn", "largest_rotation"},
    Renamed{"last_whole_strain", "last_intact_strain"},
    Renamed{"last_whole_stress", "last_intact_stress"},
    Renamed{"ledger_error", "energy_balance_error"},
    Renamed{"misfit_share", "misfit_fraction"},
    Renamed{"most_iterations", "max_iterations"},
    Renamed{"moved", "free"},
    Renamed{"numerical", "numerical_dissipation"},
    Renamed{"parts", "targets"},
    Renamed{"pieces", "fragments"},
    Renamed{"rp02", "proof_stress"},
    Renamed{"runs_probability", "runs_test_p"},
    Renamed{"segment_shares", "segment_fractions"},
    Renamed{"turn", "rotation"},
    Renamed{"unstable_ways", "unstable_modes"},
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

/// The path of a field, "solver.max_iterations", of one whose last part may be an old name.
inline std::string new_path(std::string_view path) {
  const std::size_t last = path.rfind('.') + 1;
  return std::string(path.substr(0, last)).append(new_name(kRenamedWords, path.substr(last)));
}

/// The path that a field had before. Digests are made of it, so that journals stay usable.
inline std::string old_path(std::string_view path) {
  const std::size_t last = path.rfind('.') + 1;
  const std::string_view before = old_name(kRenamedWords, path.substr(last));
  return before.empty() ? std::string(path) : std::string(path.substr(0, last)).append(before);
}

}  // namespace plastica
