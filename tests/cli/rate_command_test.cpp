#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/command.hpp"

/// What the command does with materials whose yield stress depends on the strain rate.
namespace plastica::testing {
namespace {

std::string coupon_at(const std::string& rate, const std::string& law) {
  return "[material]\nyoungs_modulus = '200 GPa'\nyield_stress = '300 MPa'\n"
         "[material.rate]\n" +
         law + "strain_rate = '" + rate +
         " 1/s'\n"
         "[section]\nshape = 'rectangle'\nwidth = '10 mm'\nheight = '10 mm'\n"
         "[drive]\ndeformation = 'tension'\nstrain = { turning_points = ['2 %'] }\n"
         "[[probe]]\nname = 'stress'\nkind = 'stress'\n";
}

/// Fits through three tests at rates five decades apart, whose curves are those of a law.
/// @param law         the rate law's keys of a scene
/// @param parameters  lines of the fit's parameters
/// @param factor      of the yield stress, 300 MPa, at a rate
/// @return the fit's parameters
nlohmann::json fit_at_three_rates(const std::string& law, const std::string& parameters,
                                  const std::function<double(double)>& factor) {
  const Workplace place;
  std::string fit =
      "[fit]\n[fit.parameters]\n"
      "yield_stress = { start = '250 MPa', bounds = ['100 MPa', '600 MPa'] }\n" +
      parameters;
  for (const std::string rate : {"0.001", "1", "100"}) {
    const double yield = 300.0 * factor(std::stod(rate));
    std::string curve = "Strain,Stress (MPa)\n";
    for (int i = 0; i <= 100; ++i) {
      const double strain = 0.0002 * i;
      curve +=
          std::to_string(strain) + "," + std::to_string(std::min(200e3 * strain, yield)) + "\n";
    }
    place.write("at-" + rate + ".csv", curve);
    place.write("at-" + rate + ".toml", coupon_at(rate, law));
    fit += "[[target]]\nfiles = 'at-" + rate + ".csv'\nscene = 'at-" + rate +
           ".toml'\nabscissa = { column = 'Strain', drive = 'strain' }\n"
           "ordinate = { column = 'Stress', probe = 'stress' }\n";
  }
  place.write("fit.toml", fit);
  const CommandResult result = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(result.code, 0) << result.err;
  return nlohmann::json::parse(place.read("fit.json")).at("fits").at(0).at("parameters");
}

double value_of(const nlohmann::json& parameters, const char* name) {
  return parameters.at(name).at("value").get<double>();
}

TEST(RateCommand, FitsCowperAndSymondsThroughTestsAtSeveralRates) {
  const auto fitted = fit_at_three_rates(
      "law = 'cowper_symonds'\nreference_rate = '100 1/s'\nexponent = 4\n",
      "reference_rate = { start = '100 1/s', bounds = ['0.1 1/s', '10000 1/s'] }\n"
      "exponent = { start = 4, bounds = [1, 20] }\n",
      [](double rate) { return 1.0 + std::pow(rate / 40.4, 0.2); });
  EXPECT_NEAR(value_of(fitted, "yield_stress"), 300e6, 3e3);
  EXPECT_NEAR(value_of(fitted, "reference_rate"), 40.4, 4e-3);
  EXPECT_NEAR(value_of(fitted, "exponent"), 5.0, 1e-4);
}

/// The reference rate is a convention of the laboratory: with the yield stress free it is not
/// identifiable.
TEST(RateCommand, FitsJohnsonAndCookThroughTestsAtSeveralRates) {
  const auto fitted =
      fit_at_three_rates("law = 'johnson_cook'\nreference_rate = '0.001 1/s'\ncoefficient = 0.01\n",
                         "coefficient = { start = 0.01, bounds = [0, 0.2] }\n",
                         [](double rate) { return 1.0 + 0.025 * std::log(rate / 0.001); });
  EXPECT_NEAR(value_of(fitted, "yield_stress"), 300e6, 3e3);
  EXPECT_NEAR(value_of(fitted, "coefficient"), 0.025, 1e-6);
}

TEST(RateCommand, FitsACurveAtTheRateOfItsSpecimen) {
  const Workplace place;
  std::string curve = "Strain,Stress (MPa)\n";
  for (int i = 0; i <= 100; ++i) {
    const double strain = 0.0002 * i;
    const double yield = 300.0 * (1.0 + 0.02 * std::log(50.0));
    curve += std::to_string(strain) + "," + std::to_string(std::min(200e3 * strain, yield)) + "\n";
  }
  place.write("curve.csv", curve);
  place.write("info.csv", "id,rate (1/s)\ncurve,50\n");
  const auto fit = [&](const std::string& rate) {
    place.write("fit.toml",
                "[fit.parameters]\nyield_stress = {}\n"
                "[material]\nyoungs_modulus = '200 GPa'\n"
                "[material.rate]\nlaw = 'johnson_cook'\nreference_rate = '1 1/s'\n"
                "coefficient = 0.02\n"
                "[[target]]\nfiles = 'curve.csv'\nstrain = 'Strain'\nstress = 'Stress (MPa)'\n"
                "table = { file = 'info.csv', key = 'id' }\n" +
                    rate);
    return place.run({"calibrate", "fit.toml", "--force", "--json", "fit.json"});
  };
  for (const char* rate :
       {"strain_rate = '50 1/s'\n", "strain_rate = { from = 'rate (1/s)', unit = '1/s' }\n"}) {
    const CommandResult result = fit(rate);
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(place.read("fit.json"));
    EXPECT_NE(json.dump().find("\"strain_rate\":50.0"), std::string::npos);
    EXPECT_NE(result.out.find("300.0"), std::string::npos) << result.out;
  }
  const CommandResult without = fit("");
  EXPECT_EQ(without.code, 1);  // a specimen that failed is a row with its reason
  EXPECT_NE(without.out.find("material.rate.strain_rate: is missing"), std::string::npos)
      << without.out;
}

constexpr const char* kPushed = R"([beam]
length = "1 m"
segments = 4
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material.rate]
law = "cowper_symonds"
reference_rate = "40.4 1/s"
exponent = 5
[solver]
analysis = "dynamics"
duration = "2 ms"
time_step = "50 us"
steps = 4
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "1 kN", "0 N"]
history = "constant"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
)";

TEST(RateCommand, SaysTheRateLawOfAScene) {
  const Workplace place;
  place.write("push.toml", kPushed);
  const CommandResult result =
      place.run({"simulate", "push.toml", "-o", "push.h5", "--json", "push.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("rate cowper_symonds of each joint"), std::string::npos) << result.out;
  const auto rate = nlohmann::json::parse(place.read("push.json")).at("material").at("rate");
  EXPECT_EQ(rate.at("reference_rate"), 40.4);
  EXPECT_TRUE(rate.at("strain_rate").is_null());
  const CommandResult beam =
      place.run({"export", "push.h5", "--what", "beam", "--to", "mjcf", "-o", "beam.xml"});
  ASSERT_EQ(beam.code, 0) << beam.err;
  EXPECT_NE((beam.out + beam.err + place.read("beam.xml")).find("the rate law is left out"),
            std::string::npos);
}

}  // namespace
}  // namespace plastica::testing
