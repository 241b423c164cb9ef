#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plastica/model/drive.hpp"

namespace plastica::calibrate {

/// What a column of a file of curves holds.
enum class ColumnRole {
  Other,
  Time,
  Strain,
  Elongation,  ///< of the gauge length, by an extensometer
  Travel,      ///< of the crosshead: the machine and the grips give way in it, too
  Stress,
  Force,
  Geometry,  ///< a dimension of the specimen
};

/// What a column is taken for, and why.
struct ColumnMeaning {
  ColumnRole role = ColumnRole::Other;
  bool is_true = false;         ///< true strain or stress, as its name says
  bool is_engineering = false;  ///< the opposite, as its name says
  bool is_travel = false;       ///< a strain that is travel over a length
  bool is_plastic = false;      ///< a strain without its elastic part
  bool is_lesser = false;  ///< wanted of the machine ("set", "soll"), an extreme, an error, a part
  bool is_weak = false;    ///< its unit alone says so, not its name
  std::optional<Deformation> test;  ///< of a strain or stress of bending or torsion, by its name
  std::optional<std::string> unit;  ///< the file's own, or the one that ends the name
  std::string why;                  ///< "name", "name, unit", "unit", "place"
};

/// In lower-case words: "crosshead travel".
std::string_view words_of(ColumnRole role);

/// What a column is by its name and its unit, in words and abbreviations of English, German,
/// French, Spanish and Italian laboratories. The unit decides where it can: "Standard force" in MPa
/// is a stress, "Strain" in mm an elongation. A unit may end a name, as in "Stress_MPa".
/// @param name  without its unit
/// @param unit  of the file; may be empty
ColumnMeaning meaning_of(std::string_view name, std::string_view unit);

/// A name in lower case; umlauts and accents as well.
std::string lower_name(std::string_view name);

}  // namespace plastica::calibrate
