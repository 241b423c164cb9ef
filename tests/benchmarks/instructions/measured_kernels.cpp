#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/released_cantilever.hpp"

/// Runs each kernel a fixed number of times inside `measured`, and prints for each call of it the
/// kernel's name and how many units (points, segments x steps, segments x iterations) it did.
/// `check_instructions` counts the instructions of each call. A kernel "NAME@N" is one of several
/// sizes, whose instructions must grow no faster than N.
namespace plastica {
namespace {

constexpr int kSegments = 64;
constexpr int kSteps = 20;
constexpr int kPoints = 300;

/// The one function whose instructions are counted.
[[gnu::noinline]] void measured(const std::function<void()>& kernel) {
  kernel();
  asm volatile("");  // not the last call: else it would be a jump, and `measured` not seen to end
}

/// A first call, which may lay out memory, and a counted one. @return the last response
Response count(std::string_view name, const Setup& setup, double units_of_iteration = 0.0,
               double units = 0.0) {
  const Model model = prepare(setup.scene, setup.solver);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  run(model, {}, workspace, response);
  measured([&] { run(model, {}, workspace, response); });
  if (response.status != Status::Completed) std::fputs("a kernel did not go to its end\n", stderr);
  const double done = units_of_iteration * response.counters.iterations + units;
  std::printf("%.*s %.17g\n", static_cast<int>(name.size()), name.data(), done);
  return response;
}

Setup setup_of(Scene scene, Level level) {
  Setup setup{std::move(scene), {}};
  setup.solver.level = level;
  setup.solver.frames = 1;
  // valgrind knows no AVX-512.
  set_field(setup, find_field("solver.isa"), std::string("avx2"));
  return setup;
}

/// Newton iterations of a cantilever with a tip force of `load` EI/L^2, in so many steps.
void count_iterations(std::string_view name, Level level, YieldModel model,
                      int segments = kSegments, double load = 2.0, int steps = 4) {
  Scene scene = testing::cantilever_scene(segments);
  scene.yield_model = model;
  scene.material.yield_stress = 1e12;
  scene.loads.push_back({.force = {0.0, -load * testing::bending_stiffness_of(scene), 0.0}});
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  Setup setup = setup_of(scene, level);
  setup.solver.steps = steps;
  count(name, setup, segments);
}

/// Steps of the released cantilever.
void count_steps(std::string_view name, Level level, Scheme scheme, int segments = kSegments,
                 int steps = kSteps) {
  Setup setup = setup_of(testing::released_cantilever(segments), level);
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.scheme = scheme;
  setup.solver.time_step = 1e-3;
  setup.solver.duration = steps * 1e-3;
  setup.solver.steps = 1;
  count(name, setup, 0.0, static_cast<double>(segments) * steps);
}

Scene tension(HardeningLaw law) {
  Scene scene;
  scene.material.hardening.law = law;
  scene.material.hardening.tangent_modulus = 1.2e9;
  for (int i = 1; i <= kPoints; ++i) scene.drive.strain.push_back(0.05 * i / kPoints);
  return scene;
}

void count_points(std::string_view name, HardeningLaw law) {
  count(name, {tension(law), {}}, 0.0, kPoints);
}

/// Points with derivatives by E, yield stress and, with hardening, a number of the law.
void count_differentiated_points(std::string_view name, HardeningLaw law) {
  std::vector<std::string> parameters{"youngs_modulus", "yield_stress"};
  std::vector<double> values{200e9, 300e6};
  if (law != HardeningLaw::Ideal) {
    parameters.emplace_back(law == HardeningLaw::Linear ? "tangent_modulus" : "saturation_stress");
    values.push_back(law == HardeningLaw::Linear ? 1.1e9 : 120e6);
  }
  const Model model = prepare(tension(law), {}, parameters);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  Sensitivity sensitivity = make_sensitivity(model);
  measured([&] { run_sensitivity(model, values, workspace, response, sensitivity); });
  std::printf("%.*s %d\n", static_cast<int>(name.size()), name.data(), kPoints);
}

/// Up to as many segments as valgrind goes through in seconds.
void count_sizes() {
  const auto at = [](const std::string& name, int segments) {
    return name + "@" + std::to_string(segments);
  };
  for (const int n : {64, 1024, 16384, 65536}) {
    count_steps(at("step_planar_articulated", n), Level::Planar, Scheme::ArticulatedMidpoint, n, 4);
  }
  for (const int n : {64, 1024, 16384}) {
    count_steps(at("step_spatial_articulated", n), Level::Spatial, Scheme::ArticulatedMidpoint, n,
                4);
    count_steps(at("step_planar_midpoint", n), Level::Planar, Scheme::LinearlyImplicitMidpoint, n,
                2);
    count_iterations(at("iteration_planar_elastic", n), Level::Planar, YieldModel::Elastic, n, 0.02,
                     1);
  }
  for (const int n : {64, 512, 4096}) {
    count_iterations(at("iteration_spatial_elastic", n), Level::Spatial, YieldModel::Elastic, n,
                     0.02, 1);
  }
}

void count_all() {
  count_points("point_ideal", HardeningLaw::Ideal);
  count_points("point_linear", HardeningLaw::Linear);
  count_differentiated_points("point_ideal_two_derivatives", HardeningLaw::Ideal);
  count_differentiated_points("point_linear_three_derivatives", HardeningLaw::Linear);
  count_iterations("iteration_planar_elastic", Level::Planar, YieldModel::Elastic);
  count_iterations("iteration_planar_per_axis", Level::Planar, YieldModel::PerAxis);
  count_iterations("iteration_spatial_elastic", Level::Spatial, YieldModel::Elastic);
  count_steps("step_planar_midpoint", Level::Planar, Scheme::LinearlyImplicitMidpoint);
  count_steps("step_planar_articulated", Level::Planar, Scheme::ArticulatedMidpoint);
  count_steps("step_planar_energy_momentum", Level::Planar, Scheme::EnergyMomentum);
  count_steps("step_spatial_articulated", Level::Spatial, Scheme::ArticulatedMidpoint);
  count_steps("step_spatial_midpoint", Level::Spatial, Scheme::LinearlyImplicitMidpoint);
}

}  // namespace
}  // namespace plastica

int main() {
  plastica::count_all();
  plastica::count_sizes();
}
