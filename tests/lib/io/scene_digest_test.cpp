#include "plastica/io/scene_digest.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

namespace plastica::io {
namespace {

/// A scene with one of everything, so that each part can be changed.
plastica::Setup full_setup() {
  plastica::Setup setup;
  Scene& scene = setup.scene;
  scene.beam.segment_fractions.assign(10, 0.1);
  scene.beam.joint_lengths.assign(9, 0.1);
  scene.beam.points.push_back({0.0, 0.0, 0.0});
  scene.regions.emplace_back();
  scene.drive.strain = {0.01};
  scene.supports.emplace_back();
  scene.loads.emplace_back();
  scene.initial_motions.emplace_back();
  scene.cuts.emplace_back();
  return setup;
}

std::uint64_t digest_after(const std::function<void(plastica::Setup&)>& change) {
  plastica::Setup setup = full_setup();
  change(setup);
  return scene_digest(setup);
}

TEST(SceneDigest, ChangesWithEveryField) {
  const std::uint64_t before = scene_digest(full_setup());
  for (const Field& field : fields()) {
    const std::uint64_t after = digest_after([&](plastica::Setup& setup) {
      const FieldValue value = field.get(setup);
      if (field.kind == FieldKind::Choice) {
        const bool first = std::get<std::string>(value) == field.choices[0];
        field.set(setup, std::string(field.choices[first ? 1 : 0]));
      } else {
        const auto* number = std::get_if<double>(&value);
        field.set(setup, number != nullptr ? *number + 1.0 : 1.0);
      }
    });
    EXPECT_NE(after, before) << field.path;
  }
}

TEST(SceneDigest, ChangesWithEverythingThatNoFieldNames) {
  using Change = std::function<void(plastica::Setup&)>;
  const std::vector<Change> changes{
      [](auto& s) { s.scene.beam.segment_fractions[0] = 0.2; },
      [](auto& s) { s.scene.beam.joint_lengths[0] = 0.2; },
      [](auto& s) {
        s.scene.beam.arc_towards = {1.0, 0.0, 0.0};
      },
      [](auto& s) { s.scene.beam.points[0][1] = 1.0; },
      [](auto& s) { s.scene.regions[0].from.fraction = 0.5; },
      [](auto& s) { s.scene.regions[0].to.segment = 3; },
      [](auto& s) { s.scene.regions[0].section.height = 0.2; },
      [](auto& s) { s.scene.regions[0].own = {"section"}; },
      [](auto& s) { s.scene.regions[0].to_section = s.scene.section; },
      [](auto& s) { s.scene.regions[0].material.density = 1.0; },
      [](auto& s) { s.scene.regions[0].material.hardening.backstress_rate[2] = 1.0; },
      [](auto& s) { s.scene.drive.strain[0] = 0.02; },
      [](auto& s) { s.scene.supports[0].at.fraction = 0.5; },
      [](auto& s) { s.scene.supports[0].kind = SupportKind::Pin; },
      [](auto& s) { s.scene.supports[0].hold = HeldFreedoms{}; },
      [](auto& s) { s.scene.supports[0].stiffness[0] = 1.0; },
      [](auto& s) { s.scene.supports[0].rotational_stiffness[0] = 1.0; },
      [](auto& s) {
        s.scene.supports[0].normal = {1.0, 0.0, 0.0};
      },
      [](auto& s) { s.scene.supports[0].gap = 1.0; },
      [](auto& s) { s.scene.supports[0].restitution = 0.5; },
      [](auto& s) { s.scene.supports[0].translation[1] = 1.0; },
      [](auto& s) { s.scene.supports[0].rotation[1] = 1.0; },
      [](auto& s) { s.scene.supports[0].history = History::constant(); },
      [](auto& s) { s.scene.loads[0].at.fraction = 0.5; },
      [](auto& s) { s.scene.loads[0].to = Place::end(); },
      [](auto& s) { s.scene.loads[0].force[0] = 1.0; },
      [](auto& s) { s.scene.loads[0].moment[0] = 1.0; },
      [](auto& s) { s.scene.loads[0].follows = true; },
      [](auto& s) { s.scene.loads[0].history = History::constant(); },
      [](auto& s) { s.scene.gravity_history = History::constant(); },
      [](auto& s) { s.scene.loads[0].history.continues = false; },
      [](auto& s) { s.scene.supports[0].history.continues = false; },
      [](auto& s) { s.scene.gravity_history.continues = false; },
      [](auto& s) { s.scene.initial_motions[0].from.fraction = 0.5; },
      [](auto& s) { s.scene.initial_motions[0].to.fraction = 0.5; },
      [](auto& s) { s.scene.initial_motions[0].velocity[0] = 1.0; },
      [](auto& s) { s.scene.initial_motions[0].spin[0] = 1.0; },
      [](auto& s) { s.scene.initial_motions[0].about.fraction = 0.25; },
      [](auto& s) { s.scene.cuts[0].at.fraction = 0.25; },
      [](auto& s) { s.scene.cuts[0].time = 1.0; },
      [](auto& s) { s.scene.probes[0].name = "other"; },
      [](auto& s) { s.scene.probes[0].quantity = ProbeQuantity::Strain; },
      [](auto& s) { s.scene.probes[0].at.fraction = 0.25; },
      [](auto& s) { s.scene.probes[0].component = Component::Z; },
      [](auto& s) { s.scene.probes[0].energy = EnergyKind::Kinetic; },
      [](auto& s) { s.solver.control_at = Place::start(); },
      [](auto& s) { s.solver.control_motion[0] = 1.0; },
  };
  std::set<std::uint64_t> digests{scene_digest(full_setup())};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    EXPECT_TRUE(digests.insert(digest_after(changes[k])).second) << "change " << k;
  }
}

TEST(SceneDigest, DoesNotCountNames) {
  EXPECT_EQ(scene_digest(full_setup()), digest_after([](plastica::Setup& setup) {
              setup.scene.name = "a scene";
              setup.scene.material.name = "steel";
            }));
}

}  // namespace
}  // namespace plastica::io
