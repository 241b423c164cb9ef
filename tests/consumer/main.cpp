#include <cstdio>
#include <plastica/run/simulate.hpp>

int main() {
  plastica::Scene scene;  // a bar of steel S355; nothing breaks until a limit is set
  scene.material.break_strain = 0.02;
  scene.drive.strain = {0.001, 0.010, 0.009, 0.020, 0.025};  // loads, unloads, reloads
  const plastica::Response response = plastica::simulate(scene);
  for (const double stress : response.probes[0]) std::printf("%.1f MPa\n", stress / 1e6);
  if (response.event) std::printf("broke at %.2f %% strain\n", 100.0 * response.event->strain);
}
