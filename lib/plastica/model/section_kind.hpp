#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/field.hpp"
#include "plastica/model/section.hpp"

/// What a shape of cross section is, said once for each shape, in a file of its own.
namespace plastica {

/// A rectangle of a section's quarter x, y >= 0 [m].
struct SectionBlock {
  double x_from = 0.0, x_to = 0.0;
  double y_from = 0.0, y_to = 0.0;
};

/// An area that is small beside the section, at one place of its quarter.
struct SectionSpot {
  double area = 0.0;  ///< [m^2]
  double x = 0.0;     ///< [m]
  double y = 0.0;     ///< [m]
};

/// A quarter of a section that is symmetric about both axes: blocks, none of which overlap, and
/// spots for what is no rectangle.
struct SectionQuarter {
  std::vector<SectionBlock> blocks;
  std::vector<SectionSpot> spots;
};

/// With x and y exchanged: what bending about y sees.
SectionQuarter exchanged(SectionQuarter quarter);

/// How far the shear stress of Saint-Venant's torsion meets the normal stress of bending on the
/// outside, which is what first yield in torsion with bending is about.
enum class SectionEdge {
  Round,      ///< one shear stress all around
  Rectangle,  ///< largest at the middle of the long sides, zero at the corners
  Walls,      ///< taken as the largest everywhere, which is safe
};

/// How much a section warps when it is twisted: holding that makes the beam stiffer.
enum class SectionWarping {
  Little,   ///< solid and closed sections
  Much,     ///< open sections
  Unknown,  ///< sections that are given by their numbers
};

/// A wall that local buckling is about: EN 1993-1-1, table 5.2.
struct SectionWall {
  enum class Kind {
    Round,     ///< of a round tube: d/t
    Internal,  ///< held along both edges: c/t
    Outstand,  ///< held along one edge: c/t
  };
  Kind kind = Kind::Internal;
  double slenderness = 0.0;  ///< [1]
  /// Whether bending about x, and about y, compresses it evenly; else it bends in its own plane.
  std::array<bool, 2> compressed{};
};

class SectionKind {
 public:
  virtual ~SectionKind() = default;

  virtual SectionShape shape() const = 0;
  /// The word for it in files.
  virtual std::string_view word() const = 0;
  /// Its dimensions, as files name them. Shapes may share some.
  virtual std::span<const Field> dimensions() const = 0;
  /// Whether a file that names the shape must give one of its dimensions, which has no default.
  virtual bool needs(const Field& /*dimension*/) const { return false; }
  /// What it is, in a few words, with its dimensions in mm.
  virtual std::string label(const Section& section) const = 0;

  /// @throws InputError naming the dimension
  virtual void check(const Section& section, const SourceLocation& where) const = 0;
  /// As `section_properties`; the section's own shear coefficient is set elsewhere.
  virtual SectionProperties properties(const Section& section, double poisson_ratio) const = 0;

  virtual SectionEdge edge() const { return SectionEdge::Walls; }
  bool round() const { return edge() == SectionEdge::Round; }
  /// Radius of the hole of a round section [m]; 0: solid.
  virtual double hole_radius(const Section& /*section*/) const { return 0.0; }
  /// Of sections that are not round; none: only its numbers are known, so that it has no fibres.
  virtual std::optional<SectionQuarter> quarter(const Section& /*section*/) const { return {}; }
  bool has_fibres() const { return round() || quarter(Section{}).has_value(); }
  /// Saint-Venant's shear per twist [m] at a point (x, y) of a section that is not round.
  virtual double twist_shear(const Section& section, const SectionProperties& properties,
                             const std::array<double, 2>& point) const;
  /// Whether the fully plastic surface in both moments is nowhere inside of m_1 + 3/4 m_2^2 = 1,
  /// the larger being m_1.
  virtual bool holds_plastic_block() const { return false; }
  /// By how much independent caps about both axes exceed what the section carries, at worst.
  virtual std::string_view beyond_caps(bool /*fully_plastic*/) const { return "100 %"; }
  /// Whether Wendelius' report has formulas for it.
  virtual bool in_report() const { return false; }
  /// What is known of warping when it is twisted.
  virtual SectionWarping warping() const { return SectionWarping::Little; }
  virtual std::vector<SectionWall> walls(const Section& /*section*/) const { return {}; }
};

/// Whether a file that says a shape must say one of its dimensions: all of them, or those without a
/// default where some have one.
bool must_be_said(const SectionKind& kind, const Field& dimension);

/// All shapes, in the order of `SectionShape`.
std::span<const SectionKind* const> section_kinds();

const SectionKind& section_kind(SectionShape shape);
inline const SectionKind& section_kind(const Section& section) {
  return section_kind(section.shape);
}

}  // namespace plastica
