#include <cstdio>
#include <plastica/run/simulate.hpp>

int main() {
  plastica::Scene scene;  // a bar of steel S355, 1 m, pushed down at its end and let go
  scene.section.width = scene.section.height = 0.02;
  scene.beam.segments = 32;
  scene.yield_model = plastica::YieldModel::Fibre;
  scene.supports.emplace_back();  // a clamp at the start
  plastica::Load push;            // at the end
  push.force = {0.0, -568.0, 0.0};
  push.history = plastica::History::turning_points({1.0, 0.0});
  scene.loads.push_back(push);
  scene.probes = {{"tip", plastica::ProbeQuantity::Displacement}};
  const plastica::Response response = plastica::simulate(scene);
  const auto& tip = response.probes[0];  // 20 steps: the load is greatest in the tenth
  std::printf("pushed %.2f mm, stays bent %.2f mm\n", -1e3 * tip[10], -1e3 * tip[20]);
}
