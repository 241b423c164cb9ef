#pragma once

#include <string>
#include <utility>

#include "plastica/io/scene_store.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::testing {

/// A cantilever of a metre with a tip force, its joints clipped one by one.
/// @param more  lines behind it, such as further loads
inline std::string cantilever_text(const std::string& force = "-100 N",
                                   const std::string& more = "") {
  return R"([beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
material = "S355"
segments = 4
[rules]
yield_model = "per_axis"
[solver]
steps = 5
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = { segment = 4 }
force = ["0 N", ")" +
         force + R"(", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
[[probe]]
name = "root"
kind = "moment"
at = "start"
component = "x"
)" + more;
}

/// The same in a motion of five samples that begins with a blow.
inline std::string swinging_text() {
  std::string text = cantilever_text(
      "-1 N", "[[initial_motion]]\nfrom = 0.5\nvelocity = ['0 m/s', '-1 m/s', '0 m/s']\n");
  const std::string steps = "steps = 5";
  return text.replace(text.find(steps), steps.size(),
                      steps + "\nanalysis = 'dynamics'\nduration = '1 ms'");
}

inline std::string coupon_text() {
  return R"([material]
name = "S355"
break_strain = "2 %"
[drive]
deformation = "tension"
strain = ["0 %", "0.1 %", "1 %", "3 %"]
[[probe]]
kind = "stress"
)";
}

/// Runs a scene file's text and puts together what its result file would hold.
inline io::SceneRecord record_of(const std::string& text) {
  const io::SceneFile file = io::parse_scene_file(text, "beam.toml");
  const Model model = prepare(file.setup.scene, file.setup.solver);
  return io::make_scene_record(file, model, simulate(file.setup.scene, file.setup.solver));
}

}  // namespace plastica::testing
