#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

namespace plastica::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PLASTICA_SOURCE_DIR;

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

/// The shipped checks with all that they need, in a folder where a test may change them.
class ShippedChecks : public ::testing::Test {
 protected:
  ShippedChecks() {
    for (const std::string folder :
         {"data/checks", "data/sweeps", "data/scenes", "tests/reference/w1-cantilever-history"}) {
      fs::create_directories(place_.path(folder));
      fs::copy(kSource / folder, place_.path(folder), fs::copy_options::recursive);
    }
  }
  void change(const std::string& file, const std::string& from, const std::string& to) {
    place_.write(file, changed(place_.read(file), from, to));
  }
  CommandResult check(const std::string& name) {
    return place_.run({"check", "data/checks/" + name, "--junit", "out.xml", "--force"});
  }

  Workplace place_;
};

// The claims of motion.toml take ten seconds: readme_shows_what_the_command_prints runs them, and
// docs/ci.md shows that all hold.
TEST_F(ShippedChecks, AllHold) {
  std::size_t claims = 0;
  for (const std::string name : {"statics.toml", "yielding.toml"}) {
    const CommandResult result = check(name);
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(count(result.out, "FAIL"), 0U);
    const std::size_t held = count(result.out, "PASS");
    EXPECT_EQ(held, count(text_of(kSource / "data/checks" / name), "[[claim]]"));
    EXPECT_EQ(held, count(place_.read("out.xml"), "<testcase "));
    claims += held;
  }
  EXPECT_GE(claims, 20U);
}

/// A fault in the model of a sweep, which the check must see.
struct Fault {
  std::string name;
  std::string file;   ///< in which it is seeded
  std::string from;   ///< the text there …
  std::string to;     ///< … and what it becomes
  std::string check;  ///< the file of claims
  std::string claim;  ///< one that must not hold then
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

class SeededFault : public ShippedChecks, public ::testing::WithParamInterface<Fault> {};

/// Of a text of claims the one whose name begins so; nothing if there is not exactly one.
std::string claim_alone(const std::string& text, const std::string& name) {
  const std::string begin = "[[claim]]";
  const std::string named = "\nname = \"" + name;
  const std::size_t from = text.rfind(begin, text.find(named));
  if (count(text, named) != 1 || from == std::string::npos) return {};
  return text.substr(from, text.find(begin, from + 1) - from);
}

// The other claims of the file hold or not without being asked: they take most of the time.
TEST_P(SeededFault, IsCaught) {
  const Fault& fault = GetParam();
  change(fault.file, fault.from, fault.to);
  const std::string claims = "data/checks/" + fault.check;
  const std::string claim = claim_alone(place_.read(claims), fault.claim);
  ASSERT_FALSE(claim.empty());
  place_.write(claims, claim);
  const CommandResult result = check(fault.check);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.out.find("  FAIL  " + fault.claim), std::string::npos) << result.out;
}

/// What [set] makes of all cases of a sweep.
Fault setting(std::string name, const std::string& sweep, const std::string& lines,
              std::string check, std::string claim) {
  const std::string set =
      text_of(kSource / "data/sweeps" / sweep).find("[set]") != std::string::npos ? "[set]\n"
                                                                                  : "[[axis]]\n";
  return {std::move(name),
          "data/sweeps/" + sweep,
          set,
          "[set]\n" + lines + (set == "[set]\n" ? "" : set),
          std::move(check),
          std::move(claim)};
}

INSTANTIATE_TEST_SUITE_P(
    Checks, SeededFault,
    ::testing::Values(
        setting("ClampRigid", "cantilever_frequency.toml", "rules.end_rule = 'equal'\n",
                "statics.toml", "the first frequency converges with order 2"),
        setting("FirstOrderJoint", "segment_depth.toml", "rules.end_rule = 'equal'\n",
                "statics.toml", "segments of any depth: order 2 from stocky to slender"),
        // Joints of whole segment lengths, as Wendelius' report prints them, are half as stiff.
        setting("StiffnessFactorOfTheReport", "cantilever_frequency.toml",
                "rules.formulas = 'report'\nrules.end_rule = 'half'\n"
                "rules.yield_model = 'elastic'\n",
                "statics.toml", "20 segments have the first frequency within 0.12 %"),
        Fault{"StiffnessTwoPercentLow", "data/scenes/bathe_bolourchi_45.toml", "= \"1e7 psi\"",
              "= \"0.98e7 psi\"", "statics.toml",
              "the bend of Bathe and Bolourchi: 64 segments are within 0.01 %"},
        setting("LooseTolerance", "cantilever_deflection.toml", "solver.tolerance = 1e-2\n",
                "statics.toml", "half joint: the tip converges with order 2"),
        Fault{"FirstYieldForThePlasticHinge", "data/sweeps/limit_load.toml", "\"fully_plastic\"",
              "\"first_yield\"", "yielding.toml",
              "half joint: the limit load is within 0.05 % of M_p/L"},
        Fault{"HalfTheBreakStrain", "data/scenes/breaking_cantilever.toml", "\"10 %\"", "\"5 %\"",
              "yielding.toml", "with a hinge length, the hinge breaks at 0.2 rad"},
        setting("DampingOfNoOnesAsking", "falling_cantilever_step.toml",
                "solver.damping = 'stiffness'\nsolver.damping_time = '1 ms'\n", "motion.toml",
                "the falling cantilever: 64 segments at 1 ms are within 0.35 %"),
        setting("SchemeThatDamps", "falling_cantilever_step.toml", "solver.rho_infinity = 0\n",
                "motion.toml", "the falling cantilever: 64 segments at 1 ms are within 0.35 %")),
    [](const auto& fault) { return fault.param.name; });

}  // namespace
}  // namespace plastica::testing
