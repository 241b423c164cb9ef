#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/problem/coordinate.hpp"
#include "calibrate/problem/parameter.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// Whether a parameter is the hinge length, which the curve does not depend on, but the break does.
bool is_hinge_length(const Parameter& p);

/// The parameters of a fit through scenes, and the coordinates in which they are searched; the size
/// of a linear one is the width of the bounds.
class SceneParameters {
 public:
  /// @param parameters  checked ones; must outlive this
  /// @param setup  what it has is the start of a parameter that is given none
  SceneParameters(std::span<const Parameter> parameters, const Setup& setup);

  /// How many are searched: free ones, but for break limits (n).
  std::size_t size() const { return searched_.size(); }
  const Parameter& parameter(std::size_t i) const { return *searched_[i].parameter; }
  const Coordinate& coordinate(std::size_t i) const { return searched_[i].coordinate; }
  double value(std::size_t i, double x) const { return coordinate(i).value(x); }
  /// The point that has these values, held within the bounds, and else the start (n).
  std::vector<double> point_at(const StartPoint& values) const;

  /// Fields that a scene is run with: those searched, then those tied to them (n_fields).
  const std::vector<const Field*>& fields() const { return fields_; }
  /// Their values [SI] at a point (n).
  std::vector<double> values(std::span<const double> x) const;

 private:
  struct Searched {
    const Parameter* parameter = nullptr;
    Coordinate coordinate;
  };
  struct Tie {
    std::size_t to = 0;  ///< index of a searched one
    double factor = 1.0;
  };
  std::vector<Searched> searched_;
  std::vector<Tie> ties_;
  std::vector<const Field*> fields_;
};

}  // namespace plastica::calibrate
