#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "plastica/base/quantity.hpp"

namespace plastica::sweeps {

/// What of a case's run is compared.
enum class QuantityKind {
  Probe,             ///< a probe of the scene, see `Take`
  NaturalFrequency,  ///< of the unloaded beam [Hz]
  LimitLoad,         ///< factor of the first load at its limit [1]
  BreakLoad,    ///< factor of the first load at the first break [1]; of a coupon its stress [Pa]
  BreakTime,    ///< of the first break [s]
  BreakStrain,  ///< of a coupon: its total strain at the break [1]
  EnergyBalanceError,  ///< `Response::energy_balance_error`: what the energies leave unexplained
                       ///< [1]
  Fit,                 ///< a parameter that [fit] finds in the scene
  LoadedFrequency,     ///< natural frequency about the loaded state [Hz]
  BucklingFactor,      ///< load factor at which it buckles, about the loaded state [1]
  BreakPlace,          ///< of the first joint that broke: its number over that of the segments [1]
};

inline constexpr std::array<std::string_view, 11> kQuantityKinds{
    "probe",        "natural_frequency",    "limit_load", "break_load",       "break_time",
    "break_strain", "energy_balance_error", "fit",        "loaded_frequency", "buckling_factor",
    "break_place"};

/// Whether a quantity is one of several modes.
constexpr bool has_modes(QuantityKind kind) {
  return kind == QuantityKind::NaturalFrequency || kind == QuantityKind::LoadedFrequency ||
         kind == QuantityKind::BucklingFactor;
}

/// Whether it comes out of a run of the scene as it is; else of modes or a fit.
constexpr bool is_simulated(QuantityKind kind) {
  return !has_modes(kind) && kind != QuantityKind::Fit;
}

/// What is taken of a probe's values over time.
enum class Take {
  End,        ///< the last
  Min,        ///< the smallest
  Max,        ///< the largest
  Size,       ///< the largest without its sign
  Mean,       ///< over time, by trapezia
  Curve,      ///< all: the error is the rms difference over the rms of the reference
  Frequency,  ///< of the strongest sine, see theory/spectrum.hpp [Hz]
};

inline constexpr std::array<std::string_view, 7> kTakes{"end",  "min",   "max",      "size",
                                                        "mean", "curve", "frequency"};

struct Quantity {
  QuantityKind kind = QuantityKind::Probe;
  std::size_t probe = 0;  ///< number of the scene's probe
  Take take = Take::End;
  int mode = 1;             ///< of frequencies and buckling factors: 1, 2, …
  std::string parameter{};  ///< Fit: path of the field
  std::string name{};       ///< for tables: "tip, end"
  std::string unit{"1"};    ///< SI
  Dimension dimension = Dimension::None;

  bool is_curve() const { return kind == QuantityKind::Probe && take == Take::Curve; }
};

}  // namespace plastica::sweeps
