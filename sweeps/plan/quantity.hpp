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
  NaturalFrequency,  ///< of the scene at rest, by a linear eigenvalue [Hz]
  LimitLoad,         ///< factor of the first load at its limit [1]
  BreakLoad,    ///< factor of the first load at the first break [1]; of a coupon its stress [Pa]
  BreakTime,    ///< of the first break [s]
  BreakStrain,  ///< of a coupon: its total strain at the break [1]
  LedgerError,  ///< `Response::ledger_error`: what the energies leave unexplained [1]
  Fit,          ///< a parameter that [fit] finds in the scene
};

inline constexpr std::array<std::string_view, 8> kQuantityKinds{
    "probe",      "natural_frequency", "limit_load",   "break_load",
    "break_time", "break_strain",      "ledger_error", "fit"};

/// What is taken of a probe's values over time.
enum class Take {
  End,        ///< the last
  Least,      ///< the least
  Largest,    ///< the largest
  Size,       ///< the largest without its sign
  Mean,       ///< over time, by trapezia
  Curve,      ///< all: the error is the rms difference over the rms of the reference
  Frequency,  ///< of the strongest sine, see theory/spectrum.hpp [Hz]
};

inline constexpr std::array<std::string_view, 7> kTakes{"end",  "least", "largest",  "size",
                                                        "mean", "curve", "frequency"};

struct Quantity {
  QuantityKind kind = QuantityKind::Probe;
  std::size_t probe = 0;  ///< number of the scene's probe
  Take take = Take::End;
  int mode = 1;             ///< NaturalFrequency: 1, 2, …
  std::string parameter{};  ///< Fit: path of the field
  std::string name{};       ///< for tables: "tip, end"
  std::string unit{"1"};    ///< SI
  Dimension dimension = Dimension::None;

  bool is_curve() const { return kind == QuantityKind::Probe && take == Take::Curve; }
};

}  // namespace plastica::sweeps
