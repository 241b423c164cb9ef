#pragma once

#include <optional>
#include <string_view>

#include "plastica/model/material.hpp"
#include "plastica/model/section.hpp"

namespace plastica::model_detail {

/// How far a thin wall lets its section go before it buckles locally: the classes of EN 1993-1-1,
/// 5.5.2.
struct WallClass {
  /// 1: hinges turn; 2: the plastic moment, without turning far; 3: first yield; 4: less.
  int section_class = 1;
  std::string_view ratio;    ///< what its slenderness is: "d/t", "c/t"
  double slenderness = 0.0;  ///< of the wall that decides [1]
  double limit = 0.0;        ///< of the class before it [1]
};

/// The worst class of a section's walls; nothing for a solid section.
///
/// EN 1993-1-1, table 5.2, with e^2 = (235 MPa/f_y)(E/210 GPa), which is 235 MPa/f_y for steel
/// (EN 1993-1-4, table 5.2 for others): round tubes in bending or compression d/t <= 50, 70, 90
/// e^2. Walls that are held along both edges: one that bending compresses evenly c/t <= 33, 38,
/// 42 e, one that bends in its plane 72, 83, 124 e; along one edge 9, 10, 14 e. c is the clear
/// width, between walls or fillets.
/// @param about_x, about_y  which axes the beam bends about
std::optional<WallClass> worst_wall(const Section& section, const Material& material, bool about_x,
                                    bool about_y);

}  // namespace plastica::model_detail
