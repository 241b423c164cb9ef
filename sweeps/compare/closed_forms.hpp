#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/plan/quantity.hpp"

namespace plastica::sweeps {

/// A closed form of `theory/` that the cases of a sweep can be compared with.
struct ClosedForm {
  std::string_view name;
  std::string_view doc;  ///< one line: for which scenes, of what
  /// The quantity of a setup [SI]: one value, or of a curve one at each time [s].
  /// @throws InputError without a place if the scene or the quantity is not one it holds for
  std::vector<double> (*values)(const Setup& setup, const Quantity& quantity,
                                std::span<const double> time);
  bool at_end = false;      ///< of the state at the end of the run, to which it must have come
  bool in_bending = false;  ///< of a beam that bends and does not shear
};

/// All closed forms, by name.
std::span<const ClosedForm> closed_forms();

/// @throws InputError that names those there are
const ClosedForm& find_closed_form(std::string_view name, const SourceLocation& where = {});

}  // namespace plastica::sweeps
