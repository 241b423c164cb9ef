#include <iostream>

#include "calibrate/target/target.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/quantity.hpp"

int main() {
  const plastica::calibrate::Curve curve{{0.0, 0.001}, {0.0, 200.0e6}};
  const plastica::InputError error({"fit.toml", 3}, "yield_stress", "-1", "must be positive");
  std::cout << curve.size() << " samples in " << si_unit(plastica::Dimension::Stress) << '\n';
  std::cout << error.what() << '\n';
}
