#include "sweeps/plan/derived_fields.hpp"

#include <gtest/gtest.h>

#include "sweeps/plan/refining.hpp"
#include "tests/support/message.hpp"

namespace plastica::sweeps {
namespace {

const Field& field(std::string_view path) { return find_axis_field(path); }

double get(const Setup& setup, std::string_view path) {
  return std::get<double>(field(path).get(setup));
}

/// A steel beam of 2 m and 0.1 m square, 10 segments.
Setup beam() {
  Setup setup;
  setup.scene.beam.length = 2.0;
  return setup;
}

TEST(DerivedFields, SetTheLengthBySlenderness) {
  plastica::Setup setup = beam();
  EXPECT_DOUBLE_EQ(get(setup, "beam.slenderness"), 20.0);
  field("beam.slenderness").set(setup, 5.0);
  EXPECT_DOUBLE_EQ(setup.scene.beam.length, 0.5);
}

TEST(DerivedFields, SetTheSegmentsByTheirLengthOverTheDepth) {
  plastica::Setup setup = beam();
  EXPECT_DOUBLE_EQ(get(setup, "beam.segment_depth"), 2.0);
  field("beam.segment_depth").set(setup, 0.3);
  EXPECT_EQ(setup.scene.beam.segments, 67);  // of 66.7
  field("beam.segment_depth").set(setup, 1e3);
  EXPECT_EQ(setup.scene.beam.segments, 1);
}

TEST(DerivedFields, ScaleLoads) {
  plastica::Setup setup = beam();
  setup.scene.loads.push_back({.force = {0.0, 2.0, 0.0}, .moment = {3.0, 0.0, 0.0}});
  field("scale.loads").set(setup, -2.0);
  EXPECT_EQ(setup.scene.loads[0].force[1], -4.0);
  EXPECT_EQ(setup.scene.loads[0].moment[0], -6.0);
}

TEST(DerivedFields, ScaleMotions) {
  plastica::Setup setup = beam();
  setup.scene.supports.push_back({.translation = {0.0, 0.1, 0.0}, .rotation = {0.2, 0.0, 0.0}});
  setup.scene.initial_motions.push_back({.velocity = {1.0, 0.0, 0.0}, .spin = {0.0, 2.0, 0.0}});
  setup.scene.drive.strain = {0.01};
  field("scale.motions").set(setup, 3.0);
  EXPECT_DOUBLE_EQ(setup.scene.supports[0].translation[1], 0.3);
  EXPECT_DOUBLE_EQ(setup.scene.supports[0].rotation[0], 0.6);
  EXPECT_EQ(setup.scene.initial_motions[0].velocity[0], 3.0);
  EXPECT_EQ(setup.scene.initial_motions[0].spin[1], 6.0);
  EXPECT_DOUBLE_EQ(setup.scene.drive.strain[0], 0.03);
}

TEST(DerivedFields, ScaleEveryLength) {
  plastica::Setup setup = beam();
  setup.scene.regions.emplace_back();
  setup.scene.supports.push_back({.gap = 0.5});
  setup.scene.hinge_length = 0.25;
  field("scale.size").set(setup, 2.0);
  EXPECT_EQ(setup.scene.beam.length, 4.0);
  EXPECT_EQ(setup.scene.section.height, 0.2);
  EXPECT_EQ(setup.scene.regions[0].section.radius, 0.1);
  EXPECT_EQ(setup.scene.supports[0].gap, 1.0);
  EXPECT_EQ(setup.scene.hinge_length, 0.5);
}

TEST(DerivedFields, LeaveMassesInAnotherSize) {
  plastica::Setup setup = beam();
  setup.scene.masses.push_back({Place::end(), 2.0, {1.0, 2.0, 3.0}});
  field("scale.size").set(setup, 2.0);
  field("scale.loads").set(setup, 2.0);
  EXPECT_EQ(setup.scene.masses[0].mass, 2.0);
  EXPECT_EQ(setup.scene.masses[0].inertia, (std::array{1.0, 2.0, 3.0}));
}

TEST(DerivedFields, TakeANamedMaterial) {
  plastica::Setup setup;
  field("material.name").set(setup, std::string("6061-T6"));
  EXPECT_EQ(setup.scene.material.name, "6061-T6");
  EXPECT_LT(setup.scene.material.youngs_modulus, 80e9);
}

TEST(DerivedFields, KnowWhatRefines) {
  EXPECT_EQ(refinement_of(field("beam.segments")), Refinement::Count);
  EXPECT_EQ(refinement_of(field("solver.time_step")), Refinement::Size);
  EXPECT_EQ(refinement_of(field("beam.segment_depth")), Refinement::Size);
  EXPECT_EQ(refinement_of(field("material.youngs_modulus")), Refinement::None);
}

}  // namespace
}  // namespace plastica::sweeps
