#include <cstdio>
#include <plastica/run/simulate.hpp>

int main() {
  plastica::Scene scene;  // a clamped bar of steel S355, 1 m, whose outer half is struck at 38 m/s
  scene.section.width = scene.section.height = 0.02;
  scene.material.break_strain = 0.02;
  scene.supports.emplace_back();
  scene.initial_motions.push_back({.from = {0.5, {}}, .velocity = {0.0, -38.0, 0.0}});
  plastica::simulate(scene, {.analysis = plastica::Analysis::Dynamics, .duration = 0.02},
                     [](plastica::ChainBreak& event) {
                       auto& joint = event.joints.front();
                       joint.cut = joint.joint < 2;  // it may break at the clamp alone
                       std::printf("%.1f ms: joint %d %s\n", 1e3 * event.time, joint.joint,
                                   joint.cut ? "is cut" : "holds");
                     });
}
