#pragma once

#include <string>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"

/// Scenes and curves that the study of starts fits.
namespace plastica::studies {

/// A fit whose curve was made by its own scene, with noise of 0.5 % of the largest ordinate.
struct StartsProblem {
  std::string name;
  calibrate::WeightedTarget weighted;
  /// Free ones, from a 30th to 30 times the truth, which is their start; a fraction from 0.02 to 1.
  std::vector<calibrate::Parameter> parameters;
  bool cheap = false;  ///< whether a fit takes some tenths of a second
};

/// Pushed, twisted and shaken beams, and a coupon; in the order of the study's table.
std::vector<StartsProblem> starts_problems();

}  // namespace plastica::studies
