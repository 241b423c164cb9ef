#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/problem/parameter.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// Whether a parameter is a limit, which is not searched but set.
bool is_break(const Parameter& p);

/// Whether a parameter is the hinge length, which the curve does not depend on, but the break does.
bool is_hinge_length(const Parameter& p);

/// The parameters of a fit through scenes, and the coordinates in which they are searched:
/// ln(value/start), or the distance from the start over the width of the bounds.
class SceneParameters {
 public:
  /// @param parameters  checked ones; must outlive this
  /// @param setup  what it has is the start of a parameter that is given none
  SceneParameters(std::span<const Parameter> parameters, const Setup& setup);

  /// How many are searched: free ones, but for break limits (n).
  std::size_t size() const { return searched_.size(); }
  const Parameter& parameter(std::size_t i) const { return *searched_[i].parameter; }
  bool is_logarithmic(std::size_t i) const { return searched_[i].logarithmic; }
  /// Coordinates of the bounds; the start is at 0.
  double lower(std::size_t i) const;
  double upper(std::size_t i) const;
  double coordinate(std::size_t i, double value) const;
  double value(std::size_t i, double coordinate) const;  ///< within the bounds [SI]
  double slope(std::size_t i, double value) const;       ///< d value / d coordinate
  /// The point that has these values, held within the bounds, and else the start (n).
  std::vector<double> point_at(const StartPoint& values) const;

  /// Fields that a scene is run with: those searched, then those tied to them (n_fields).
  const std::vector<const Field*>& fields() const { return fields_; }
  /// Their values [SI] at a point (n).
  std::vector<double> values(std::span<const double> x) const;

 private:
  struct Searched {
    const Parameter* parameter = nullptr;
    double start = 0.0;
    bool logarithmic = false;
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
