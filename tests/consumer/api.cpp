// Every header that the library promises, and something of each.
#include <cmath>
#include <cstdio>
#include <plastica/base/check.hpp>
#include <plastica/base/status.hpp>
#include <plastica/base/version.hpp>
#include <plastica/io/scene_file.hpp>
#include <plastica/io/scene_store.hpp>
#include <plastica/model/field.hpp>
#include <plastica/model/material_table.hpp>
#include <plastica/model/profile_table.hpp>
#include <plastica/model/region.hpp>
#include <plastica/model/scene.hpp>
#include <plastica/report/scene_text.hpp>
#include <plastica/run/batch.hpp>
#include <plastica/run/natural_frequencies.hpp>
#include <plastica/run/response.hpp>
#include <plastica/run/scene_warnings.hpp>
#include <plastica/run/simulate.hpp>
#include <plastica/theory/beam_cases.hpp>
#include <plastica/theory/beam_ends.hpp>
#include <plastica/theory/beam_vibration.hpp>
#include <plastica/theory/bending.hpp>
#include <plastica/theory/cantilever.hpp>
#include <plastica/theory/convergence.hpp>
#include <plastica/theory/elastica.hpp>
#include <plastica/theory/limit_load.hpp>
#include <plastica/theory/lumped_chain.hpp>
#include <plastica/theory/polygon.hpp>
#include <plastica/theory/report_formulas.hpp>
#include <plastica/theory/sampling.hpp>
#include <plastica/theory/spectrum.hpp>
#include <plastica/theory/statistics.hpp>
#include <plastica/theory/torsion_circle.hpp>
#include <plastica/theory/torsion_elastic.hpp>
#include <plastica/theory/uniaxial.hpp>
#include <string>
#include <vector>

namespace {

constexpr double kForce = 100.0;  // [N], so little that the beam stays straight

/// A cantilever of a rolled profile, 2 m, of which the outer half is of another material.
const char* const kScene = R"(
[beam]
length = "2 m"
section = "IPE 80"
material = "S235"
segments = 64
[[region]]
from = 0.5
to = "end"
material = "S355"
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-100 N", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
)";

}  // namespace

int main() try {
  using namespace plastica;
  std::printf("%s\n", version().empty() ? "no version" : "a version");
  const io::SceneFile file = io::parse_scene_file(kScene, "cantilever.toml");
  Setup setup = file.setup;
  const Model model = prepare(setup.scene, setup.solver);
  std::printf("%zu warnings\n", scene_warnings(model).size());

  // The tip against the closed form.
  const double modulus = named_material("S235").material.youngs_modulus;
  const double second_moment =
      section_properties(named_profile("IPE 80"), setup.scene.material.poisson_ratio)
          .second_moment_x;
  const theory::BeamCase beam{.ends = theory::BeamEnds::ClampedFree,
                              .length = 2.0,
                              .bending_stiffness = modulus * second_moment,
                              .load = {.position = 2.0, .force = -kForce}};
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  run(model, {}, workspace, response);
  const double tip = response.probes[0][response.samples - 1];
  std::printf("%s, tip %.3f of the closed form\n", name_of(response.status).data(),
              tip / theory::beam_deflection(beam, 2.0));

  // A batch over yield stresses: the region keeps its own.
  std::vector<BatchCase> cases;
  for (const double yield : {200e6, 300e6}) {
    BatchCase one{std::to_string(cases.size()), setup.scene, setup.solver};
    Setup changed{one.scene, one.options};
    set_everywhere(changed, find_field("material.yield_stress"), yield);
    one.scene = changed.scene;
    cases.push_back(one);
  }
  for (const BatchRow& row : run_batch(cases))
    std::printf("%s ", name_of(row.response.status).data());
  std::printf("%.0f MPa\n", cases[1].scene.regions[0].material.yield_stress / 1e6);

  const double first = natural_frequencies(setup.scene, setup.solver, 1).frequency[0];
  const io::SceneRecord record = io::make_scene_record(file, model, response);
  std::printf("%s, %s\n", first > 0.0 ? "it rings" : "it does not ring",
              report::scene_report(record).find("tip") != std::string::npos ? "told" : "not told");
  setup.scene.section.width = -1.0;
  (void)simulate(setup.scene, setup.solver);
} catch (const plastica::InputError& error) {
  std::printf("%s\n", error.what());
}
