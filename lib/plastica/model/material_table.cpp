#include "plastica/model/material_table.hpp"

#include <utility>
#include <vector>

namespace plastica {
namespace {

/// An isotropic metal: G and tau_y follow from E, nu and sigma_y.
NamedMaterial metal(std::string name, double youngs_modulus, double poisson_ratio, double density,
                    double yield_stress, std::string description, std::string source) {
  Material m;
  m.name = std::move(name);
  m.youngs_modulus = youngs_modulus;
  m.poisson_ratio = poisson_ratio;
  m.density = density;
  m.yield_stress = yield_stress;
  return {
      .material = std::move(m), .description = std::move(description), .source = std::move(source)};
}

NamedMaterial spruce_c24() {
  Material m;
  m.name = "C24";
  m.youngs_modulus = 11e9;
  m.poisson_ratio = 0.37;
  m.shear_modulus = 0.69e9;
  m.density = 420.0;
  m.yield_stress = 24e6;
  m.shear_yield_stress = 4e6;
  return {.material = std::move(m),
          .description =
              "softwood (spruce, pine) of strength class C24, along the grain: mean "
              "stiffness and density, characteristic (5 %) bending and shear strength "
              "in place of yield stresses; in tension wood breaks without yielding",
          .source =
              "EN 338:2016, class C24: E_0,mean, G_mean, rho_mean, f_m,k, f_v,k; Poisson's "
              "ratio nu_LR of Sitka spruce, USDA Wood Handbook (2010), table 5-2, rounded"};
}

std::vector<NamedMaterial> build_table() {
  const std::string steel_elastic = "; E and nu: EN 1993-1-1, 3.2.6; density: usual for steel";
  const std::string structural = "EN 10025-2: minimum ReH, thickness up to 16 mm" + steel_elastic;
  const std::string typical =
      "typical 0.2 % yield, modulus, density: Aluminum Association, Aluminum Standards and Data, "
      "also in ASM Metals Handbook vol. 2; nu = 0.33, usual for the alloy";
  std::vector<NamedMaterial> t;
  t.push_back(metal("S235", 210e9, 0.3, 7850.0, 235e6,
                    "unalloyed structural steel, minimum upper yield strength", structural));
  t.push_back(metal("S275", 210e9, 0.3, 7850.0, 275e6,
                    "unalloyed structural steel, minimum upper yield strength", structural));
  t.push_back(metal("S355", 210e9, 0.3, 7850.0, 355e6,
                    "unalloyed structural steel, minimum upper yield strength", structural));
  t.push_back(metal("42CrMo4", 210e9, 0.3, 7850.0, 750e6,
                    "quenched and tempered steel (+QT), diameter 16 to 40 mm, minimum yield "
                    "strength",
                    "EN 10083-3: minimum Re" + steel_elastic));
  t.push_back(metal("1.4301", 200e9, 0.3, 7900.0, 210e6,
                    "austenitic stainless steel X5CrNi18-10 (AISI 304), hot rolled, minimum 0.2 % "
                    "proof strength",
                    "EN 10088-2: minimum Rp0.2; E and density: EN 10088-1, annex; nu: "
                    "EN 1993-1-4"));
  t.push_back(metal("6061-T6", 68.9e9, 0.33, 2700.0, 276e6,
                    "aluminium alloy, typical 0.2 % yield strength", typical));
  t.push_back(metal("6082-T6", 70e9, 0.3, 2700.0, 260e6,
                    "aluminium alloy, sheet up to 6 mm, minimum 0.2 % proof strength",
                    "EN 485-2: minimum Rp0.2; E, nu and density: EN 1999-1-1, 3.2.5"));
  t.push_back(metal("2024-T3", 73.1e9, 0.33, 2780.0, 345e6,
                    "aluminium alloy, typical 0.2 % yield strength", typical));
  t.push_back(metal("7075-T6", 71.7e9, 0.33, 2810.0, 503e6,
                    "aluminium alloy, typical 0.2 % yield strength", typical));
  t.push_back(spruce_c24());
  return t;
}

}  // namespace

std::span<const NamedMaterial> material_table() {
  static const std::vector<NamedMaterial> table = build_table();
  return table;
}

const NamedMaterial& named_material(std::string_view name, const SourceLocation& where,
                                    std::string_view field) {
  std::string names;
  for (const NamedMaterial& entry : material_table()) {
    if (entry.material.name == name) return entry;
    names += (names.empty() ? "" : ", ") + entry.material.name;
  }
  throw InputError(where, field, name, "must be one of " + names);
}

}  // namespace plastica
