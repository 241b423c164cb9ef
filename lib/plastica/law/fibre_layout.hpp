#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/model/section.hpp"

namespace plastica::law {

/// What a fibre section sees of a joint: bending about one axis takes layers over the depth;
/// bending about both with torsion a grid; torsion alone what differs in its shear.
enum class FibrePlane { AboutX, AboutY, Both, Torsion };

/// Where the fibres of a section are: areas and positions, the same for every joint and lane.
///
/// Each interval of the depth has two fibres, the Gauss points of its width: area, first, second
/// and third moment of every interval are exact, and so are A and I whatever the number of fibres.
/// (A fibre at the middle of each layer lowers I by 1/n^2.) An even number of intervals puts a
/// boundary on the axis, which makes the fully plastic moment exact, too. Round sections have a
/// polar grid when they bend about both axes, rings when they twist.
struct FibreLayout {
  FibrePlane plane = FibrePlane::Both;
  /// AboutX, AboutY: distance from the axis along y or -x [m]; Both: y (n_fibres).
  std::vector<double> depth;
  std::vector<double> across;  ///< Both: -x [m] (n_fibres), else empty
  std::vector<double> area;    ///< [m^2] (n_fibres)
  /// AboutX, AboutY: mean square of the distance from the other axis over a fibre [m^2] (n_fibres),
  /// else empty.
  std::vector<double> aside;
  /// Both, Torsion: shear strain per twist [m] (n_fibres): the radius in a round section, in others
  /// law/shear_levers.hpp.
  std::vector<double> lever;
  /// Both: shear strain per unit of each way in which the section can warp beyond Saint-Venant's
  /// [m] (n_fibres): see law/fibre_grid.hpp.
  std::array<std::vector<double>, 2> warp;

  /// How many states of its law a joint has: the fibres', and one for what has warped.
  std::size_t states() const { return area.size() + (warp[0].empty() ? 0 : 1); }
};

/// Lays out the fibres.
/// @param properties  of the section
/// @param fibres      along the depth, >= 2; rounded up to a multiple of four
FibreLayout fibre_layout(const Section& section, const SectionProperties& properties,
                         FibrePlane plane, int fibres);

/// The largest count with which `fibre_layout` lays out the same fibres as with this one: the next
/// multiple of four, at least four for each part of the half depth that has a width of its own
/// (flange, web).
int taken_fibres(const Section& section, FibrePlane plane, int fibres);

}  // namespace plastica::law
