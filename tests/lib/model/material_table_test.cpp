#include "plastica/model/material_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace plastica {
namespace {

TEST(MaterialTable, EveryEntryIsValidNamedOnceAndHasItsSource) {
  std::set<std::string> names;
  for (const NamedMaterial& entry : material_table()) {
    SCOPED_TRACE(entry.material.name);
    EXPECT_NO_THROW(check_material(entry.material));
    EXPECT_TRUE(names.insert(entry.material.name).second);
    EXPECT_FALSE(entry.description.empty());
    EXPECT_FALSE(entry.source.empty());
    EXPECT_FALSE(entry.material.break_strain.has_value());
  }
  EXPECT_GE(names.size(), 9U);
}

TEST(MaterialTable, FindsAMaterialByName) {
  EXPECT_EQ(named_material("6061-T6").material.yield_stress, 276e6);
}

TEST(MaterialTable, DefaultMaterialIsItsS355) {
  const Material table = named_material("S355").material;
  const Material plain;
  EXPECT_EQ(plain.name, table.name);
  EXPECT_EQ(plain.youngs_modulus, table.youngs_modulus);
  EXPECT_EQ(plain.poisson_ratio, table.poisson_ratio);
  EXPECT_EQ(plain.density, table.density);
  EXPECT_EQ(plain.yield_stress, table.yield_stress);
}

TEST(MaterialTable, WoodHasItsOwnShearValues) {
  const Material wood = named_material("C24").material;
  EXPECT_LT(resolved_shear_modulus(wood),
            0.2 * wood.youngs_modulus / (2.0 * (1.0 + wood.poisson_ratio)));
  EXPECT_LT(resolved_shear_yield_stress(wood), 0.2 * wood.yield_stress);
}

TEST(MaterialTable, PageOfSourcesHasTheSameFigures) {
  std::ifstream file(PLASTICA_SOURCE_DIR "/data/materials/README.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const NamedMaterial& entry : material_table()) {
    const Material& m = entry.material;
    std::array<char, 200> row{};
    std::snprintf(row.data(), row.size(), "| %s | %g | %g | %g | %g | ", m.name.c_str(),
                  m.youngs_modulus / 1e9, m.poisson_ratio, m.density, m.yield_stress / 1e6);
    EXPECT_NE(page.find(row.data()), std::string::npos) << row.data();
  }
}

TEST(MaterialTable, UnknownNameIsAnsweredWithAllNames) {
  try {
    named_material("S356", {.file = "scene.toml", .line = 4}, "material.base");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("scene.toml:4: material.base = S356: must be one of S235, "))
        << text;
    for (const NamedMaterial& entry : material_table()) {
      EXPECT_NE(text.find(entry.material.name), std::string::npos) << entry.material.name;
    }
  }
}

}  // namespace
}  // namespace plastica
