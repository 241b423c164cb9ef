#pragma once

#include <array>
#include <string>
#include <vector>

#include "plastica/model/item_field.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// A vector that pushes or turns the beam, or that a support acts along.
struct SceneAction {
  std::string field;  ///< "load[1].force"
  VectorSense sense = VectorSense::Push;
  std::array<double, 3> vector{};
};

/// All of a scene; those that are zero, too.
std::vector<SceneAction> actions_of(const Scene& scene);

}  // namespace plastica::model_detail
