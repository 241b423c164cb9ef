#include "tests/cli/curves.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plastica::testing {

std::string broken_curve(double yield, int number, double step) {
  constexpr double kModulus = 2000.0;  // MPa per % of strain
  const double breaks_at = 2.0 + yield / kModulus;
  std::string text = "Strain (%),Stress (MPa)\n";
  for (int i = 0, broken = 0; broken < 3; ++i) {
    const double strain = step * i;
    const bool intact = strain < breaks_at;
    const double roughness = 0.2 * ((i * 37 + number * 17) % 11 - 5);
    const double stress = intact ? std::min(kModulus * strain, yield) + roughness : 0.0;
    text += fmt::format("{:.4f},{:.2f}\n", strain, stress);
    broken += intact ? 0 : 1;
  }
  return text;
}

std::string fit_file(const std::string& files, const std::string& fit) {
  return "[fit]\n" + fit + "\n[[target]]\nfiles = " + files +
         "\nstrain = { column = \"Strain\", unit = \"%\" }"
         "\nstress = { column = \"Stress\", unit = \"MPa\" }\n";
}

}  // namespace plastica::testing
