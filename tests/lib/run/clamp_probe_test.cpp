#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"

// Probes of angles and permanent strains at a clamp, whatever joins the first segment to it.

namespace plastica {
namespace {

/// The last values of the probes of a cantilever that yields at its clamp.
std::vector<double> probed(const std::string& rule, int segments, const std::string& at) {
  std::string text =
      "[beam]\nlength = '0.5 m'\nsegments = " + std::to_string(segments) +
      "\nsection = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
      "[material]\nname = 'S355'\nhardening = { law = 'linear', tangent_modulus = '2 GPa' }\n"
      "[rules]\nyield_model = 'fibre'\nend_rule = '" +
      rule +
      "'\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[load]]\nat = 'end'\nforce = ['0 N', '-1350 N', '0 N']\n";
  for (const char* kind : {"plastic_strain", "local_plastic_strain", "plastic_angle", "angle"}) {
    text +=
        "[[probe]]\nname = '" + std::string(kind) + "'\nkind = '" + kind + "'\nat = " + at + "\n";
  }
  const Setup setup = io::parse_scene_file(text, "clamp.toml").setup;
  const Response response = simulate(setup.scene, setup.solver);
  EXPECT_EQ(response.status, Status::Completed);
  std::vector<double> last;
  for (const auto& probe : response.probes) last.push_back(probe.back());
  return last;
}

// A rule without a joint in the clamp yields in the next one, a segment off or half of one.
TEST(ClampProbe, IsThatOfTheNextJointWhereTheClampHasNone) {
  const double truth = probed("half_joint", 400, "'start'")[0];
  EXPECT_GT(truth, 0.001);
  for (const std::string rule : {"half", "equal", "three_halves"}) {
    const auto at_clamp = probed(rule, 400, "'start'");
    EXPECT_NEAR(at_clamp[0], truth, 0.05 * truth) << rule;
    EXPECT_EQ(at_clamp, probed(rule, 400, "{ segment = 1 }")) << rule;
    for (const double value : at_clamp) EXPECT_GT(std::fabs(value), 0.0) << rule;
  }
}

/// The strain of the extreme fibre at an end that a pin lets turn, or a rotational spring holds:
/// that of the moment there, as the stress. The angle there is none of the section.
TEST(EndProbe, OfStrainIsThatOfTheMomentWhereTheEndTurns) {
  for (const int segments : {10, 40}) {
    for (const bool spring : {false, true}) {
      const std::string text =
          "[beam]\nlength = '1 m'\nsegments = " + std::to_string(segments) +
          "\nsection = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
          "[material]\nyoungs_modulus = '200 GPa'\n[rules]\nyield_model = 'elastic'\n"
          "[[support]]\nat = 'start'\nkind = 'pin'\n" +
          (spring ? "[[support]]\nat = 'start'\nkind = 'elastic'\nrotational_stiffness = "
                    "['500 N m/rad', '0 N m/rad', '0 N m/rad']\n"
                  : "") +
          "[[support]]\nat = 'end'\nkind = 'roller'\nhold = ['y']\n"
          "[[load]]\nat = 0.5\nforce = ['0 N', '-100 N', '0 N']\n"
          "[[probe]]\nkind = 'strain'\nat = 'start'\n[[probe]]\nkind = 'stress'\nat = 'start'\n"
          "name = 'stress'\n";
      const plastica::Setup setup = io::parse_scene_file(text, "pin.toml").setup;
      const Response response = simulate(setup.scene, setup.solver);
      ASSERT_EQ(response.status, Status::Completed);
      const double stress = response.probes[1].back();
      EXPECT_EQ(std::fabs(stress) > 1e5, spring);
      EXPECT_NEAR(response.probes[0].back(), stress / 200e9, 1e-6 * std::fabs(stress) / 200e9);
    }
  }
}

}  // namespace
}  // namespace plastica
