#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "calibrate/inference/bootstrap.hpp"
#include "tests/cli/command.hpp"

// Which law `plastica calibrate --laws` advises, and what the elastic slope does to the modulus.

namespace plastica::testing {
namespace {

using Json = nlohmann::json;

const char* const kColumns[] = {"--strain", "Strain:1", "--stress", "Stress:MPa"};

/// A steel of 205 GPa and 370 MPa by Ramberg and Osgood: no law that can be fitted follows it.
std::string without_a_knee(double exponent) {
  std::string text = "Strain,Stress\n";
  for (int i = 0; i <= 300; ++i) {
    const double stress = 450.0 * i / 300.0;
    const double strain = stress / 205e3 + 0.002 * std::pow(stress / 370.0, exponent);
    text += fmt::format("{:.9g},{:.9g}\n", strain, stress);
  }
  return text;
}

/// 200 GPa, a yield stress [MPa] and a tangent of 600 MPa, with a noise of 1 MPa.
std::string hardening(double yield, std::uint64_t seed) {
  calibrate::Draws draws(seed, 0);
  std::string text = "Strain,Stress\n";
  for (int i = 0; i < 400; ++i) {
    const double strain = i < 100 ? 2e-5 * i : 0.002 + 1e-4 * (i - 100);
    const double knee = yield / 200e3;
    const double stress = strain < knee ? 200e3 * strain : yield + 600.0 * (strain - knee);
    text += fmt::format("{:.9g},{:.9g}\n", strain, stress + draws.normal());
  }
  return text;
}

CommandResult calibrate_csv(const Workplace& place, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "calibrate");
  arguments.insert(arguments.end(), std::begin(kColumns), std::end(kColumns));
  arguments.insert(arguments.end(), {"-o", "fit.h5", "--json", "fit.json", "--force"});
  return place.run(arguments);
}

double modulus_of(const Workplace& place) {
  const Json fit = Json::parse(place.read("fit.json")).at("fits").at(0);
  return fit.at("parameters").at("youngs_modulus").at("value").get<double>();
}

TEST(LawChoiceCommand, WeighsTheModulusWithTheElasticSlope) {
  const Workplace place;
  place.write("a.csv", without_a_knee(12.0));
  const CommandResult with = calibrate_csv(place, {"a.csv"});
  EXPECT_EQ(with.code, 0) << with.err;
  EXPECT_NE(with.out.find("weighed with the elastic slope, "), std::string::npos) << with.out;
  EXPECT_NEAR(modulus_of(place), 205e9, 0.03 * 205e9);
  EXPECT_EQ(place.run({"show", "fit.h5"}).out, with.out);

  const CommandResult without = calibrate_csv(place, {"a.csv", "--no-modulus-prior"});
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(without.out.find("weighed"), std::string::npos);
  EXPECT_LT(modulus_of(place), 0.9 * 205e9) << "what the law makes of it";
  const std::string file =
      "[fit]\nmodulus_prior = {}\n[[target]]\nfiles = 'a.csv'\n"
      "strain = {{ column = 'Strain', unit = '1' }}\nstress = {{ column = 'Stress', unit = 'MPa' "
      "}}\n";
  place.write("fit.toml", fmt::format(fmt::runtime(file), "false"));
  const double by_option = modulus_of(place);
  EXPECT_EQ(place.run({"calibrate", "fit.toml", "--json", "fit.json", "--force"}).code, 0);
  EXPECT_EQ(modulus_of(place), by_option);
  place.write("fit.toml", fmt::format(fmt::runtime(file), "3"));
  const CommandResult wrong = place.run({"calibrate", "fit.toml", "--force"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(wrong.err.starts_with("plastica: fit.toml:2: fit.modulus_prior")) << wrong.err;
}

TEST(LawChoiceCommand, RanksLawsByWhatTheyHaveNotSeenWhereNoneFollows) {
  const Workplace place;
  place.write("a.csv", without_a_knee(8.0));
  const CommandResult result = calibrate_csv(place, {"a.csv", "--laws", "ideal,linear,voce"});
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* said : {"Laws for a, by parts of the curve held out", "of parts held out",
                           "too few to compare by information", "voce: parts of the curve held"}) {
    EXPECT_NE(result.out.find(said), std::string::npos) << said << '\n' << result.out;
  }
  EXPECT_EQ(result.out.find("BIC "), std::string::npos) << result.out;
  const Json all = Json::parse(place.read("fit.json")).at("laws").at("all");
  EXPECT_EQ(all.at("ranked_by"), "parts of the curve held out");
  EXPECT_EQ(all.at("comparable_by_information"), false);
  EXPECT_EQ(all.at("advised"), "voce");
  EXPECT_GT(all.at("laws").at(2).at("held_out").get<double>(),
            2.0 * all.at("laws").at(0).at("held_out").get<double>());
  EXPECT_EQ(place.run({"show", "fit.h5"}).out, result.out);
}

/// Specimens that differ by 20 % must not hide that one law follows each of them.
TEST(LawChoiceCommand, AdvisesTheLawOfSpecimensThatDiffer) {
  const Workplace place;
  place.write("a.csv", hardening(270.0, 1));
  place.write("b.csv", hardening(300.0, 2));
  place.write("c.csv", hardening(340.0, 3));
  const CommandResult result =
      calibrate_csv(place, {"a.csv", "b.csv", "c.csv", "--laws", "ideal,linear"});
  EXPECT_EQ(result.code, 0) << result.err;
  const Json laws = Json::parse(place.read("fit.json")).at("laws");
  EXPECT_EQ(laws.at("all").at("advised"), "linear");
  for (const Json& law : laws.at("all").at("laws")) {
    EXPECT_GT(law.at("unseen").get<double>(), 0.05) << "what the specimens differ by";
  }
}

}  // namespace
}  // namespace plastica::testing
