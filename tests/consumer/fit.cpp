#include <algorithm>
#include <calibrate/calibrate.hpp>
#include <cstdio>

using namespace plastica::calibrate;

int main() {
  Curve measured;  // of a steel without hardening, broken after 2 %
  for (int i = 0; i <= 200; ++i) {
    const double strain = 1e-4 * i;
    measured.strain.push_back(strain);
    measured.stress.push_back(std::min(210e9 * strain, 355e6));
  }
  measured.strain.push_back(0.0201);
  measured.stress.push_back(0.0);

  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
    options.parameters.emplace_back().field = &plastica::find_field(name);
  }
  const std::vector<Target> targets{make_target("bar", measured)};
  for (const FitResult& result : fit(targets, options)) {
    for (const FittedParameter& p : result.parameters)
      std::printf("%s %.4g\n", p.name().c_str(), p.value);
  }
}
