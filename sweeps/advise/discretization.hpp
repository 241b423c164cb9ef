#pragma once

#include <vector>

#include "plastica/model/field.hpp"
#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {

/// Fibres along the depth that show when a section yields: the outermost lies at 0.98 of a
/// rectangle's half depth, so that it yields from 1.02 times first yield on; of four it is at 0.79.
inline constexpr double kRichFibres = 40.0;

/// A number of a scene's discretization, which advice chooses.
struct FinenessAxis {
  const Field* field = nullptr;
  double coarsest = 0.0;  ///< value at which advice begins, and which it never goes beyond
  double finest = 0.0;    ///< value that it does not pass
  /// What a finer value is at least, where two coarse ones may be alike, and both wrong: few fibres
  /// stay elastic up to a multiple of the moment at which the section's surface yields.
  double finer_at_least = 0.0;

  /// What falls as the value gets finer: 1/value of a count, else the value.
  double size(double value) const;
  /// The value whose size is `size` times `factor`, within the axis' limits; counts are rounded to
  /// the finer side.
  double scaled(double value, double factor) const;
};

/// A value of each axis, in their order (n_axes).
using Setting = std::vector<double>;

/// The longest time step that sees each swing of the loads and motions [s]: a quarter of the
/// shortest time in which a smooth history goes one way. Two steps of a multiple of it may both
/// miss, or hit alike, what goes to and fro. Infinite where all histories are straight.
double resolving_step(const Setup& setup);

/// The axes that a scene has: its segments; the time step of a motion, which begins with one that
/// is no longer than `resolving_step`, and with adaptive steps what one may be off; fibres of a
/// fibre section; the recorded steps of a path at rest that yields, which advice never makes fewer.
/// @throws InputError for a coupon, whose run has no such error, and for a scene that says
///         something by the number of a segment
std::vector<FinenessAxis> fineness_axes(const Setup& setup);

/// Whether something in the scene is half a segment off, so that its error has a term of first
/// order in the segments beside that of second order: joints that shear at an elastic support, a
/// point mass or, in a motion, a load within the beam.
bool has_first_order_errors(const Setup& setup);

/// The scene with a setting.
Setup setup_at(const Setup& setup, const std::vector<FinenessAxis>& axes, const Setting& setting);

/// The setting as a run takes it: a time step divides the time from one sample to the next, and the
/// recorded steps of a path are a multiple of the scene's own.
Setting taken_setting(const Setup& setup, const std::vector<FinenessAxis>& axes, Setting setting);

/// The setting that a scene's file has.
Setting own_setting(const Setup& setup, const std::vector<FinenessAxis>& axes);

}  // namespace plastica::sweeps
