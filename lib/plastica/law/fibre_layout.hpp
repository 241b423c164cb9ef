#pragma once

#include <vector>

#include "plastica/law/section_form.hpp"
#include "plastica/model/section.hpp"

namespace plastica::law {

/// What a fibre section can bend about: one axis takes layers over the depth, both take a grid.
enum class FibrePlane { AboutX, AboutY, Both };

/// Where the fibres of a section are: areas and positions, the same for every joint and lane.
///
/// Each interval of the depth has two fibres, the Gauss points of its width: area, first, second
/// and third moment of every interval are exact, and so are A and I whatever the number of fibres.
/// (A fibre at the middle of each layer lowers I by 1/n^2.) An even number of intervals puts a
/// boundary on the axis, which makes the fully plastic moment exact, too. Round sections have a
/// polar grid when they bend about both axes.
struct FibreLayout {
  FibrePlane plane = FibrePlane::Both;
  /// AboutX, AboutY: distance from the axis along y or -x [m]; Both: y (n_fibres).
  std::vector<double> depth;
  std::vector<double> across;  ///< Both: -x [m] (n_fibres), else empty
  std::vector<double> area;    ///< [m^2] (n_fibres)
  /// Torsion: rings of a round section by radius and area, shear strain radius x twist; other
  /// sections have one, which stands for the law of the extreme fibre: J/W_t [m], W_t^2/J [m^2].
  std::vector<double> ring_radius, ring_area;

  /// How many states of the uniaxial law a joint has: fibres, then rings.
  std::size_t states() const { return area.size() + ring_area.size(); }
};

/// Lays out the fibres.
/// @param fibres  along the depth, >= 2; rounded up to a multiple of four
FibreLayout fibre_layout(const Section& section, const SectionForm& form, FibrePlane plane,
                         int fibres);

}  // namespace plastica::law
