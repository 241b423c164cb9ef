#include <cstdio>
#include <plastica/run/simulate.hpp>

int main() {
  plastica::Scene scene;  // a clamped bar of steel S355, 1 m, whose outer half is struck at 45 m/s
  scene.section.width = scene.section.height = 0.02;
  scene.material.break_strain = 0.02;
  scene.supports.emplace_back();
  scene.initial_motions.push_back({.from = {0.5, {}}, .velocity = {0.0, -45.0, 0.0}});
  const plastica::SolverOptions options{
      .analysis = plastica::Analysis::Dynamics, .duration = 0.02, .time_step = 20e-6};
  const auto on_break = [](plastica::ChainBreak& event) {
    for (plastica::BrokenJoint& joint : event.joints) {
      joint.cut = joint.joint == 0;  // it may break at the clamp alone
      std::printf("%.1f ms: joint %d %s\n", 1e3 * event.time, joint.joint,
                  joint.cut ? "is cut" : "holds");
    }
  };
  const plastica::Response response = plastica::simulate(scene, options, on_break);
  std::printf("%s, energy off by %.2f %%\n", name_of(response.status).data(),
              100.0 * response.energy_balance_error);
}
