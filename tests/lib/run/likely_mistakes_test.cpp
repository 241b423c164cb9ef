#include "plastica/run/likely_mistakes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "plastica/model/material_table.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using testing::cantilever;

struct Given {
  Scene scene = cantilever();
  SolverOptions options;
};

/// The mistakes of a scene that has run, each in its first words.
std::vector<std::string> mistakes_of(const std::function<void(Given&)>& change) {
  Given given;
  change(given);
  const Model model = prepare(given.scene, given.options);
  return likely_mistakes(given.scene, model, simulate(given.scene, given.options));
}

bool has(const std::vector<std::string>& mistakes, const std::string& words) {
  return mistakes.size() == 1 && mistakes.front().find(words) != std::string::npos;
}

using Texts = std::vector<std::string>;

TEST(LikelyMistakes, AreNoneOfAnyNamedMaterial) {
  for (const NamedMaterial& named : material_table()) {
    EXPECT_EQ(mistakes_of([&](Given& g) {
                g.scene.material = named.material;
                g.scene.gravity = {0.0, -9.81, 0.0};
              }),
              Texts{})
        << named.material.name;
  }
}

TEST(LikelyMistakes, AreYieldStrainsOfNoMaterial) {
  const auto of = [](double modulus, double stress) {
    return mistakes_of([=](Given& g) {
      g.scene.material.youngs_modulus = modulus;
      g.scene.material.yield_stress = stress;
      g.scene.loads[0].force = {0.0, 1e-9, 0.0};
    });
  };
  EXPECT_TRUE(has(of(210e6, 355e6), "material yields at a strain of 1.69"));  // MPa for GPa
  EXPECT_TRUE(has(of(210e9, 355e3), "material yields at a strain of 1.69e-06"));
  EXPECT_EQ(of(0.5e9, 25e6), Texts{});  // a polymer
  EXPECT_EQ(of(70e9, 10e6), Texts{});   // annealed aluminium

  Scene coupon;
  coupon.drive.strain = {0.0, 0.01};
  coupon.material.youngs_modulus = 210e6;
  EXPECT_TRUE(has(likely_mistakes(coupon, prepare(coupon, {}), simulate(coupon, {})),
                  "material yields at a strain of 1.69"));
}

TEST(LikelyMistakes, AreWavesOfNoMaterialWhereMassMatters) {
  const auto of = [](double density, bool weighs) {
    return mistakes_of([=](Given& g) {
      g.scene.material.density = density;
      if (weighs) g.scene.gravity = {0.0, -1e-6, 0.0};
    });
  };
  EXPECT_TRUE(has(of(7.85, true), "waves run through material at 1.64e+05 m/s"));  // of g/cm^3
  EXPECT_EQ(of(7.85, false), Texts{});
  EXPECT_EQ(of(7850.0, true), Texts{});
}

// M c/(E I) of a cantilever: F L c/(E I).
TEST(LikelyMistakes, AreElasticStrainsBeyondHookesLaw) {
  const auto at_strain = [](double strain) {
    return mistakes_of([=](Given& g) {
      g.scene.yield_model = YieldModel::Elastic;
      const SectionProperties section = section_properties(g.scene.section, 0.3);
      const double moment = strain * g.scene.material.youngs_modulus * section.section_modulus_x;
      g.scene.loads[0].force = {};
      g.scene.loads[0].moment = {moment, 0.0, 0.0};
    });
  };
  EXPECT_EQ(at_strain(0.04), Texts{});
  EXPECT_TRUE(has(at_strain(0.06), "the outermost fibres are strained by 6 %"));
}

TEST(LikelyMistakes, AreBreakStrainsOfElasticJoints) {
  EXPECT_TRUE(has(mistakes_of([](Given& g) {
                    g.scene.yield_model = YieldModel::Elastic;
                    g.scene.material.break_strain = 0.01;
                  }),
                  "material.break_strain is a permanent strain"));
  EXPECT_EQ(mistakes_of([](Given& g) { g.scene.material.break_strain = 0.01; }), Texts{});
}

TEST(LikelyMistakes, AreLoadsThatASupportTakesWhole) {
  const auto with = [](Place at, std::array<double, 3> moment, SupportKind kind) {
    return mistakes_of([=](Given& g) {
      Load load;
      load.at = at;
      load.force = {0.0, 1.0, 0.0};
      load.moment = moment;
      g.scene.loads.push_back(load);
      if (kind != SupportKind::Clamp) g.scene.supports.push_back({.at = {0.5, {}}, .kind = kind});
    });
  };
  const std::array<double, 3> none{};
  const std::array<double, 3> some{1.0, 0.0, 0.0};
  EXPECT_TRUE(has(with({0.0, {}}, none, SupportKind::Clamp), "load[2] acts where support[1]"));
  EXPECT_TRUE(has(with({0.0, {}}, some, SupportKind::Clamp), "load[2] acts where support[1]"));
  EXPECT_TRUE(has(with({0.5, {}}, none, SupportKind::Pin), "load[2] acts where support[2]"));
  EXPECT_EQ(with({0.5, {}}, some, SupportKind::Pin), Texts{});
  EXPECT_EQ(with({0.5, {}}, none, SupportKind::Roller), Texts{});  // along the beam it has it
  EXPECT_EQ(with({0.25, {}}, none, SupportKind::Pin), Texts{});
}

}  // namespace
}  // namespace plastica
