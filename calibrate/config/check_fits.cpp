#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/fit/scene_laws.hpp"

namespace plastica::calibrate {

void check_fits(const SceneFitFile& file) {
  for (const SceneFitCase& one : file.cases) {
    if (file.options.laws.empty()) check_scenes(one.targets, file.options);
    for (const Law law : file.options.laws) {
      check_scenes(targets_of(law, one.targets), options_of(law, file.options, one.targets));
    }
  }
}

}  // namespace plastica::calibrate
