#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "plastica/io/scene_file.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/choose_level.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using Vector = std::array<double, 3>;

const std::string kClamp = "[[support]]\nat = 'start'\nkind = 'clamp'\n";
const std::string kForce = "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\n";

plastica::Setup read(const std::string& text) { return parse_scene_file(text, "s.toml").setup; }

Scene scene_of(const std::string& text) { return read(text).scene; }

/// A cantilever with more text at its end.
Scene with(const std::string& text) { return scene_of(kClamp + kForce + text); }

History history_in(const std::string& text) {
  return scene_of(kClamp + kForce + "history = " + text).loads.at(0).history;
}

TEST(ChainScene, ReadsTheExampleOfACantilever) {
  const plastica::Setup setup = read(
      "[beam]\nlength = '4 m'\n"
      "section = { shape = 'rectangle', width = '20 mm', height = '30 mm' }\n"
      "material = '6061-T6'\nsegments = 32\n" +
      kClamp + kForce + "history = 'ramp'\n[[probe]]\nname = 'tip'\nkind = 'displacement'\n" +
      "at = 'end'\n");
  const Scene& scene = setup.scene;
  EXPECT_FALSE(scene.is_coupon());
  EXPECT_EQ(scene.beam.length, 4.0);
  EXPECT_EQ(scene.beam.segments, 32);
  EXPECT_DOUBLE_EQ(scene.section.height, 0.03);
  EXPECT_EQ(scene.material.name, "6061-T6");
  ASSERT_EQ(scene.supports.size(), 1U);
  EXPECT_EQ(scene.supports[0].kind, SupportKind::Clamp);
  EXPECT_EQ(scene.supports[0].at.fraction, 0.0);
  ASSERT_EQ(scene.loads.size(), 1U);
  EXPECT_EQ(scene.loads[0].force, (Vector{0.0, -100.0, 0.0}));
  EXPECT_EQ(scene.loads[0].at.fraction, 1.0);
  EXPECT_EQ(scene.loads[0].history, History::ramp());
  ASSERT_EQ(scene.probes.size(), 1U);
  EXPECT_EQ(scene.probes[0].name, "tip");
  EXPECT_EQ(scene.probes[0].quantity, ProbeQuantity::Displacement);
  EXPECT_EQ(scene.probes[0].component, Component::Y);
}

TEST(ChainScene, ReadsSectionAndMaterialFromTheBeamOrTheFile) {
  const std::string in_beam =
      "beam.material = { name = 'S235', density = '7800 kg/m^3' }\n"
      "beam.section = { shape = 'circle', radius = '1 cm' }\n";
  const std::string in_file =
      "material = { name = 'S235', density = '7800 kg/m^3' }\n"
      "section = { shape = 'circle', radius = '1 cm' }\n";
  for (const std::string& text : {in_beam, in_file}) {
    const Scene scene = scene_of(text + kClamp + kForce);
    EXPECT_EQ(scene.material.name, "S235");
    EXPECT_EQ(scene.material.yield_stress, 235e6);
    EXPECT_EQ(scene.material.density, 7800.0);
    EXPECT_EQ(scene.section.shape, SectionShape::Circle);
    EXPECT_EQ(scene.section.radius, 0.01);
  }
}

TEST(ChainScene, HasNoProbesUnlessItAsksForThem) { EXPECT_TRUE(with("").probes.empty()); }

TEST(ChainScene, TakesPlacesByNameNumberAndFraction) {
  const auto place = [](const std::string& at) {
    return with("[[support]]\nat = " + at + "\nkind = 'roller'\n").supports.at(1).at;
  };
  EXPECT_EQ(place("'end'").fraction, 1.0);
  EXPECT_EQ(place("0.25").fraction, 0.25);
  EXPECT_EQ(place("1.0").fraction, 1.0);
  EXPECT_EQ(place("'25 %'").fraction, 0.25);
  EXPECT_EQ(place("0.25").segment, std::nullopt);
  EXPECT_EQ(place("'100 %'").fraction, 1.0);
  EXPECT_EQ(place("{ segment = 3 }").segment, 3);
  EXPECT_EQ(place("{ segment = 10 }").segment, 10);
  for (const std::string start : {"0", "0.0", "{ segment = 0 }", "'start'"}) {
    const Scene scene = scene_of("[[support]]\nat = " + start + "\nkind = 'clamp'\n" + kForce);
    EXPECT_EQ(fraction_of(scene.supports[0].at, segment_ends(scene)), 0.0) << start;
  }
}

TEST(ChainScene, ReadsHistories) {
  EXPECT_EQ(history_in("'ramp'"), History::ramp());
  EXPECT_FALSE(history_in("{ turning_points = [1] }").continues);
  EXPECT_FALSE(history_in("{ time = ['0 s', '1 s'], factor = [0, 1] }").continues);
  const History turning = history_in("{ turning_points = [1, -1, 0.5] }");
  EXPECT_EQ(turning.time, (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(turning.factor, (std::vector<double>{0.0, 1.0, -1.0, 0.5}));
  const History cycles = history_in("{ cycles = 2 }");
  EXPECT_EQ(cycles.factor, (std::vector<double>{0.0, 1.0, -1.0, 1.0, -1.0, 0.0}));
  EXPECT_EQ(cycles.end(), 5.0);
  const History table = history_in("{ time = ['0 s', '500 ms', '2 s'], factor = [0, 1, '50 %'] }");
  EXPECT_EQ(table.time, (std::vector<double>{0.0, 0.5, 2.0}));
  EXPECT_EQ(table.factor, (std::vector<double>{0.0, 1.0, 0.5}));
  const Scene constant =
      scene_of("solver.duration = '1 s'\n" + kClamp + kForce + "history = 'constant'\n");
  EXPECT_EQ(constant.loads[0].history.at(0.0), 1.0);
  EXPECT_EQ(constant.loads[0].history.end(), 0.0);
}

TEST(ChainScene, ReadsEveryKindOfSupport) {
  const Scene scene = with(
      "[[support]]\nat = { segment = 2 }\nkind = 'roller'\nhold = ['y']\n"
      "translation = ['0 m', '5 mm', '0 m']\nhistory = { turning_points = [2] }\n"
      "[[support]]\nat = { segment = 3 }\nkind = 'pin'\n"
      "[[support]]\nat = { segment = 4 }\nkind = 'guide'\nrotation = ['90 deg', '0 rad', '0 rad']\n"
      "[[support]]\nat = { segment = 5 }\nkind = 'elastic'\nstiffness = ['0 N/m', '2 kN/mm', '0 "
      "N/m']\n"
      "rotational_stiffness = ['3 N m/rad', '0 N m/rad', '0 N m/rad']\n"
      "[[support]]\nat = 6.5e-1\nkind = 'pillar'\nnormal = [0, -3, 4]\ngap = '2 mm'\n");
  ASSERT_EQ(scene.supports.size(), 6U);
  EXPECT_EQ(scene.supports[1].held(), (HeldFreedoms{false, true}));
  EXPECT_EQ(scene.supports[1].translation, (Vector{0.0, 0.005, 0.0}));
  EXPECT_EQ(scene.supports[1].history.factor, (std::vector<double>{0.0, 2.0}));
  EXPECT_EQ(scene.supports[2].kind, SupportKind::Pin);
  EXPECT_DOUBLE_EQ(scene.supports[3].rotation[0], std::numbers::pi / 2.0);
  EXPECT_EQ(scene.supports[4].stiffness, (Vector{0.0, 2e6, 0.0}));
  EXPECT_EQ(scene.supports[4].rotational_stiffness, (Vector{3.0, 0.0, 0.0}));
  EXPECT_EQ(scene.supports[5].normal, (Vector{0.0, -0.6, 0.8}));
  EXPECT_EQ(scene.supports[5].gap, 0.002);
}

TEST(ChainScene, TakesDirectionsByName) {
  const auto normal = [](const std::string& word) {
    return with("[[support]]\nat = { segment = 5 }\nkind = 'pillar'\nnormal = '" + word + "'\n")
        .supports.at(1)
        .normal;
  };
  EXPECT_EQ(normal("y"), (Vector{0.0, 1.0, 0.0}));
  EXPECT_EQ(normal("-x"), (Vector{-1.0, 0.0, 0.0}));
}

TEST(ChainScene, ReadsLoadsAtAPointAndSpread) {
  const Scene scene = with(
      "[[load]]\nat = 0.5\nmoment = ['1 kN m', '0 N m', '0 N m']\nfollows = true\n"
      "[[load]]\nat = 'start'\nto = 0.5\nforce = ['0 N/m', '-2 kN/m', '0 N/m']\n"
      "moment = ['3 N m/m', '0 N m/m', '0 N m/m']\n");
  ASSERT_EQ(scene.loads.size(), 3U);
  EXPECT_EQ(scene.loads[1].moment, (Vector{1e3, 0.0, 0.0}));
  EXPECT_EQ(scene.loads[1].force, Vector{});
  EXPECT_TRUE(scene.loads[1].follows);
  EXPECT_FALSE(scene.loads[1].to);
  ASSERT_TRUE(scene.loads[2].to);
  EXPECT_EQ(scene.loads[2].to->fraction, 0.5);
  EXPECT_EQ(scene.loads[2].force, (Vector{0.0, -2e3, 0.0}));
  EXPECT_EQ(scene.loads[2].moment, (Vector{3.0, 0.0, 0.0}));
  EXPECT_FALSE(scene.loads[2].follows);
}

/// As regions say it.
TEST(ChainScene, ReadsFromAndToOfSpreadLoadsAndBeds) {
  const Scene scene = with(
      "[[load]]\nfrom = 0.25\nto = 0.75\nforce = ['0 N/m', '-1 N/m', '0 N/m']\n"
      "[[support]]\nfrom = 0.5\nto = 'end'\nkind = 'elastic'\n"
      "stiffness = ['0 Pa', '1 Pa', '0 Pa']\n");
  EXPECT_EQ(scene.loads.at(1).at.fraction, 0.25);
  EXPECT_EQ(scene.loads.at(1).to.value().fraction, 0.75);
  EXPECT_EQ(scene.supports.at(1).at.fraction, 0.5);
  EXPECT_EQ(scene.supports.at(1).to.value().fraction, 1.0);
}

TEST(ChainScene, ReadsGravityAsAListOrATable) {
  const Vector down{0.0, -9.81, 0.0};
  const Scene list = scene_of("gravity = ['0 m/s^2', '-9.81 m/s^2', '0 m/s^2']\n" + kClamp);
  EXPECT_EQ(list.gravity, down);
  EXPECT_EQ(list.gravity_history, History::ramp());
  const Scene table =
      scene_of(kClamp + kForce + "[gravity]\ny = '-9.81 m/s^2'\nhistory = 'constant'\n");
  EXPECT_EQ(table.gravity, down);
  EXPECT_EQ(table.gravity_history.at(0.0), 1.0);
  const Scene whole =
      scene_of("gravity.acceleration = ['0 m/s^2', '-1 gravity', '0 m/s^2']\n" + kClamp);
  EXPECT_DOUBLE_EQ(whole.gravity[1], -9.80665);
}

TEST(ChainScene, DividesTheBeamByLengthsOrFractions) {
  const Scene lengths =
      scene_of("beam.segment_lengths = ['500 mm', '1 m', '0.5 m']\n" + kClamp + kForce);
  EXPECT_EQ(lengths.beam.length, 2.0);
  EXPECT_EQ(lengths.beam.segments, 3);
  EXPECT_EQ(lengths.beam.segment_fractions, (std::vector<double>{0.25, 0.5, 0.25}));
  const Scene fractions = scene_of("[beam]\nlength = '3 m'\nsegment_lengths = [0.25, '75 %']\n" +
                                   std::string("joint_lengths = ['1 m']\n") + kClamp + kForce);
  EXPECT_EQ(fractions.beam.length, 3.0);
  EXPECT_EQ(fractions.beam.segment_fractions, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(fractions.beam.joint_lengths, (std::vector<double>{1.0}));
}

TEST(ChainScene, ReadsShapes) {
  const Scene arc =
      scene_of("[beam]\nlength = '2 m'\nshape = 'arc'\narc_angle = '45 deg'\narc_towards = '-y'\n" +
               kClamp + kForce);
  EXPECT_EQ(arc.beam.shape, BeamShape::Arc);
  EXPECT_DOUBLE_EQ(arc.beam.arc_angle, std::numbers::pi / 4.0);
  EXPECT_EQ(arc.beam.arc_towards, (Vector{0.0, -1.0, 0.0}));
  const Scene polyline = scene_of(
      "[beam]\nshape = 'polyline'\n"
      "points = [['0 m', '0 m', '0 m'], ['0 m', '30 cm', '40 cm'], ['0 m', '0 m', '80 cm']]\n" +
      kClamp + kForce);
  EXPECT_DOUBLE_EQ(polyline.beam.length, 1.0);
  ASSERT_EQ(polyline.beam.points.size(), 3U);
  EXPECT_DOUBLE_EQ(polyline.beam.points[1][1], 0.3);
}

TEST(ChainScene, ReadsRegionsOnTopOfTheBeam) {
  const Scene scene = scene_of(
      "[beam]\nmaterial = 'S355'\nsection = { width = '20 mm', height = '30 mm' }\n"
      "[[region]]\nfrom = 0.5\nto = 'end'\nsection.height = '10 mm'\n"
      "[[region]]\nfrom = { segment = 2 }\nto = { segment = 4 }\nmaterial = 'S235'\n" +
      kClamp + kForce);
  ASSERT_EQ(scene.regions.size(), 2U);
  EXPECT_EQ(scene.regions[0].from.fraction, 0.5);
  EXPECT_EQ(scene.regions[0].section.height, 0.01);
  EXPECT_EQ(scene.regions[0].section.width, 0.02);
  EXPECT_EQ(scene.regions[0].material.name, "S355");
  EXPECT_EQ(scene.regions[1].to.segment, 4);
  EXPECT_EQ(scene.regions[1].section.height, 0.03);
  EXPECT_EQ(scene.regions[1].material.name, "S235");
  EXPECT_EQ(scene.regions[0].own, (std::vector<std::string>{"section.height"}));
  EXPECT_EQ(scene.regions[1].own, (std::vector<std::string>{"material"}));
}

TEST(ChainScene, KnowsWhatARegionSaysItself) {
  const auto own = [](const std::string& says, const std::string& before = "") {
    return scene_of(before +
                    "[rules]\nyield_model = 'per_axis'\n[beam]\nlength = '1 m'\n[[region]]\nfrom = "
                    "0.5\nto = 'end'\n" +
                    says + kClamp + kForce)
        .regions[0]
        .own;
  };
  using Paths = std::vector<std::string>;
  EXPECT_EQ(own("section = 'IPE 200'\n"), (Paths{"section"}));
  EXPECT_EQ(own("section = { profile = 'IPE 200' }\n"), (Paths{"section"}));
  EXPECT_EQ(own("material = { name = 'S235', density = '8 g/cm^3' }\n"), (Paths{"material"}));
  EXPECT_EQ(own("material.density = '8 g/cm^3'\nsection.width = '50 mm'\n"),
            (Paths{"section.width", "material.density"}));
  const std::string table =
      "material.hardening = { law = 'multilinear', plastic_strain = [0.1], flow_stress = "
      "['500 MPa'] }\n";
  EXPECT_EQ(own(table, table).front(), "material.hardening.law");
}

/// A list of a region is all of its table: points of the beam's that it does not have are none.
TEST(ChainScene, HasOfARegionsTableWhatItsListsSay) {
  const auto table = [](const std::string& strains, const std::string& stresses) {
    return "material.hardening = { law = 'multilinear', plastic_strain = " + strains +
           ", flow_stress = " + stresses + " }\n";
  };
  const Scene scene = scene_of(table("[0.01, 0.1]", "['400 MPa', '450 MPa']") +
                               "[beam]\nlength = '1 m'\n[[region]]\nfrom = 0.5\nto = 'end'\n" +
                               table("[0.2]", "['500 MPa']") + kClamp + kForce);
  const Hardening& h = scene.regions[0].material.hardening;
  EXPECT_EQ(h.plastic_strain[0], 0.2);
  EXPECT_EQ(h.plastic_strain[1], 0.0);
  EXPECT_EQ(h.flow_stress[1], 0.0);
  EXPECT_DOUBLE_EQ(scene.material.hardening.flow_stress[1], 450e6);
}

TEST(ChainScene, ReadsProbesOfEveryKind) {
  for (std::size_t i = 0; i < probe_kinds().size(); ++i) {
    const auto quantity = static_cast<ProbeQuantity>(i);
    if (quantity == ProbeQuantity::Load || quantity == ProbeQuantity::Dissipation) continue;
    if (quantity >= ProbeQuantity::Velocity) continue;  // of motions
    const std::string kind(probe_kinds()[i]);
    const bool energy = quantity == ProbeQuantity::Energy;
    const bool reaction = kind.starts_with("reaction");
    const auto probes =
        with("[[probe]]\nkind = '" + kind + "'\n" + (energy ? "energy = 'residual'\n" : "") +
             (reaction ? "at = 'start'\n" : ""))
            .probes;
    ASSERT_EQ(probes.size(), 1U);
    EXPECT_EQ(probes[0].name, kind);
    EXPECT_EQ(probes[0].quantity, quantity) << kind;
    EXPECT_EQ(probes[0].energy, energy ? EnergyKind::Residual : EnergyKind::Elastic);
  }
}

TEST(ChainScene, ChoosesTheComponentThatAYZSceneMoves) {
  const auto component = [](const std::string& text) {
    return with("[[probe]]\n" + text + "\n").probes.at(0).component;
  };
  EXPECT_EQ(component("kind = 'displacement'"), Component::Y);
  EXPECT_EQ(component("kind = 'force'"), Component::Y);
  EXPECT_EQ(component("kind = 'moment'"), Component::X);
  EXPECT_EQ(component("kind = 'rotation'"), Component::X);
  EXPECT_EQ(component("kind = 'moment'\ncomponent = 'z'"), Component::Z);
  EXPECT_EQ(component("kind = 'displacement'\ncomponent = 'size'"), Component::Size);
}

TEST(ChainScene, ReadsWhatPathControlWatches) {
  const plastica::Setup setup = read(
      "solver.control = 'displacement'\nsolver.control_at = 0.5\n"
      "solver.control_motion = ['0 m', '-20 mm', '0 m']\n" +
      kClamp + kForce);
  EXPECT_EQ(setup.solver.control, PathControl::Displacement);
  ASSERT_TRUE(setup.solver.control_at);
  EXPECT_EQ(setup.solver.control_at->fraction, 0.5);
  EXPECT_EQ(setup.solver.control_motion, (std::array{0.0, -0.02, 0.0}));
}

TEST(ChainScene, NamesTheLineOfWhatTheSceneAsAWholeRefuses) {
  const auto error = [](const std::string& text) {
    return testing::message_of([&] { read(text); });
  };
  // Without lengths of its own the beam would have a segment end there.
  EXPECT_EQ(error("[beam]\nsegment_lengths = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\n" +
                  kClamp + kForce + "[[support]]\nkind = 'clamp'\nat = 0.33\n"),
            "s.toml:11: support[2].at = 0.33: a clamp that holds rotation (rx) must be at a "
            "segment's end; the nearest are 0.3 and 0.4");
  EXPECT_EQ(error("[solver]\nlevel = 'twist'\n" + kClamp + kForce),
            "s.toml:2: solver.level = twist: load[1].force has a component along y, and twist is "
            "about the beam's axis z alone");
  EXPECT_EQ(error("\n" + kForce + "[[support]]\nat = 'start'\nkind = 'roller'\n"),
            "s.toml:5: support: the supports together leave the beam free to move along z (level "
            "planar)");
}

TEST(ChainScene, IsWhatEverySceneOfTheDataIs) {
  const std::filesystem::path folder =
      std::filesystem::path(PLASTICA_SOURCE_DIR) / "data" / "scenes";
  int chains = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    SceneFile file;
    ASSERT_NO_THROW(file = read_scene_file(entry.path().string())) << entry.path();
    if (!file.setup.scene.is_coupon()) ++chains;
  }
  EXPECT_GE(chains, 15);
}

TEST(ChainScene, OfTheReportAreModelledAsSmallAsTheyCanBe) {
  const auto level = [](const std::string& name) {
    const auto setup =
        read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml").setup;
    return choose_level(setup.scene, setup.solver).level;
  };
  EXPECT_EQ(level("report_fig01_breaking"), Level::Coupon);
  EXPECT_EQ(level("report_fig06_bent"), Level::Planar);
  EXPECT_EQ(level("report_fig06_twisted"), Level::Twist);
  EXPECT_EQ(level("report_fig08_square"), Level::Planar);
  EXPECT_EQ(level("report_fig10_twisted_steel"), Level::Twist);
  EXPECT_EQ(level("report_proposal4_square"), Level::Spatial);
  EXPECT_EQ(level("report_proposal5_wood"), Level::Spatial);
  EXPECT_EQ(level("bathe_bolourchi_45"), Level::Spatial);
}

}  // namespace
}  // namespace plastica::io
