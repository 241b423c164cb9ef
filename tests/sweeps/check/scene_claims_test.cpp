#include <gtest/gtest.h>

#include <fstream>

#include "sweeps/check/run_check.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

/// Claims on scenes that no sweep varies.
namespace plastica::sweeps {
namespace {

class SceneClaims : public ::testing::Test {
 protected:
  SceneClaims() {
    for (const std::string name :
         {"cantilever", "breaking_cantilever", "limit_load_cantilever", "column"}) {
      std::ofstream(folder_.file(name + ".toml"))
          << io::content_of(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
    }
  }
  CheckFile read(const std::string& claims) {
    std::ofstream(folder_.file("check.toml")) << claims;
    return read_check_file(folder_.file("check.toml"));
  }
  ClaimVerdict verdict(const std::string& scene, const std::string& claim) {
    return run_check(read("[[claim]]\nname = 'a'\nscene = '" + scene + ".toml'\n" + claim), {})
        .front();
  }
  std::string message(const std::string& claim) {
    const std::string line = plastica::testing::message_of(
        [&] { read("[[claim]]\nname = 'a'\nscene = 'cantilever.toml'\n" + claim); });
    return line.substr(std::min(line.size(), folder_.file("check.toml").size()));
  }

  io::ScratchFolder folder_;
};

TEST_F(SceneClaims, HoldAProbeToLimitsInItsUnit) {
  // The elastica of P L^2/(E I) = 0.571 of 4 m: 735.3 mm.
  const ClaimVerdict held =
      verdict("cantilever", "probe = 'tip'\nvalue = { at_least = '-736 mm', at_most = '-735 mm' }");
  EXPECT_TRUE(held.holds) << held.reason;
  EXPECT_NEAR(held.number.value_or(0.0), -0.7353, 5e-4);
  EXPECT_FALSE(verdict("cantilever", "probe = 'tip'\nvalue = { at_least = '-735 mm' }").holds);
  EXPECT_TRUE(
      verdict("cantilever", "probe = 'tip'\ntake = 'size'\nvalue = { at_most = '736 mm' }").holds);
  EXPECT_FALSE(
      verdict("cantilever", "probe = 'tip'\ntake = 'size'\nvalue = { at_most = '735 mm' }").holds);
}

TEST_F(SceneClaims, HoldAProbeToAClosedFormOrANumber) {
  const std::string tip = "probe = 'tip'\n";
  EXPECT_TRUE(
      verdict("cantilever", tip + "against = 'theory:elastica'\nerror = { at_most = '0.05 %' }")
          .holds);
  const ClaimVerdict off =
      verdict("cantilever", tip + "against = 'theory:elastica'\nerror = { at_most = '0.04 %' }");
  EXPECT_FALSE(off.holds);
  EXPECT_EQ(off.at, "");
  EXPECT_EQ(off.beside, "tip, end -0.735651 m, reference -0.735301 m");
  EXPECT_TRUE(
      verdict("cantilever", tip + "against = 'value:-735.3 mm'\nerror = { at_most = '0.05 %' }")
          .holds);
}

TEST_F(SceneClaims, HoldTheFirstBreakToItsTimeAndPlace) {
  // The hinge at the clamp: joint 0. It breaks at 0.2 rad, the tip at L sin 0.2 beyond first yield.
  EXPECT_TRUE(
      verdict("breaking_cantilever", "quantity = 'break_place'\nvalue = { at_most = 0 }").holds);
  EXPECT_FALSE(
      verdict("breaking_cantilever", "quantity = 'break_place'\nvalue = { at_least = 0.1 }").holds);
  EXPECT_TRUE(verdict("breaking_cantilever",
                      "quantity = 'break_time'\nvalue = { at_least = '0.2 s', at_most = '0.6 s' }")
                  .holds);
  EXPECT_TRUE(verdict("breaking_cantilever", "status = 'broken'").holds);
  const ClaimVerdict otherwise =
      verdict("breaking_cantilever", "status = ['completed', 'limit-load']");
  EXPECT_FALSE(otherwise.holds);
  EXPECT_EQ(otherwise.found, "broken");
}

TEST_F(SceneClaims, DoNotHoldOfWhatTheSceneHasNot) {
  for (const std::string kind : {"break_place", "limit_load", "break_time"}) {
    const std::string unit = kind == "break_time" ? "'9 s'" : "9";
    const ClaimVerdict found =
        verdict("cantilever", "quantity = '" + kind + "'\nvalue = { at_most = " + unit + " }");
    EXPECT_FALSE(found.holds) << kind;
    EXPECT_FALSE(found.number) << kind;
    EXPECT_EQ(found.reason, kind == "limit_load" ? "there is no limit load" : "nothing breaks");
  }
}

TEST_F(SceneClaims, HoldLimitLoadsBucklingFactorsAndFrequencies) {
  // M_p/L = 0.8875 of the first load; the chain is a joint of half a segment off.
  EXPECT_TRUE(verdict("limit_load_cantilever",
                      "quantity = 'limit_load'\nvalue = { at_least = 0.5, at_most = 1.0 }")
                  .holds);
  EXPECT_TRUE(verdict("limit_load_cantilever", "status = 'limit-load'").holds);
  // 1.875104^2/(2 pi) sqrt(EI/(rho A L^4)) = 1.0427 Hz of 20 mm steel over 4 m.
  const ClaimVerdict frequency = verdict("cantilever",
                                         "quantity = 'natural_frequency'\nmode = 1\nvalue = { "
                                         "at_least = '1 Hz', at_most = '1.1 Hz' }");
  EXPECT_TRUE(frequency.holds) << frequency.number.value_or(0.0) << frequency.reason;
  const ClaimVerdict buckling =
      verdict("column", "quantity = 'buckling_factor'\nvalue = { at_least = 0 }");
  EXPECT_TRUE(buckling.number.has_value()) << buckling.reason;
}

TEST_F(SceneClaims, CountWorkAndFailures) {
  EXPECT_TRUE(verdict("cantilever", "failed = { at_most = 0 }").holds);
  EXPECT_TRUE(verdict("cantilever", "work = { at_most = 5000 }").holds);
  EXPECT_FALSE(verdict("cantilever", "work = { at_most = 100 }").holds);
  EXPECT_TRUE(verdict("cantilever", "energy_balance = { at_most = '0.1 %' }").holds);
}

TEST_F(SceneClaims, RunASceneOnceForAllThatIsClaimedOfIt) {
  const CheckFile file = read(
      "[[claim]]\nname = 'a'\nscene = 'cantilever.toml'\nprobe = 'tip'\n"
      "value = { at_most = '0 m' }\n"
      "[[claim]]\nname = 'b'\nscene = 'cantilever.toml'\nprobe = 'clamp_moment'\ntake = 'size'\n"
      "value = { at_least = '300 N m', at_most = '400 N m' }\n"
      "[[claim]]\nname = 'c'\nscene = 'cantilever.toml'\nstatus = 'completed'\n"
      "[[claim]]\nname = 'd'\nscene = 'column.toml'\nfailed = { at_most = 0 }\n"
      "[[claim]]\nname = 'e'\nscene = 'cantilever.toml'\nquantity = 'natural_frequency'\n"
      "value = { at_least = '1 Hz' }\n");
  EXPECT_EQ(cases_of(file), 3U);  // two scenes, and modes of one
  std::size_t done = 0;
  CheckOptions options;
  options.threads = 2;
  options.progress = [&](std::size_t now) { done = now; };
  const auto verdicts = run_check(file, options);
  ASSERT_EQ(verdicts.size(), 5U);
  for (const ClaimVerdict& each : verdicts) EXPECT_TRUE(each.holds) << each.reason;
  EXPECT_EQ(verdicts[0].seconds, verdicts[2].seconds);
  EXPECT_EQ(done, 3U);
}

TEST_F(SceneClaims, AreRefusedOfASceneThatCannotRun) {
  std::ofstream(folder_.file("loose.toml"))
      << "[beam]\nlength = '1 m'\nsegments = 4\n"
         "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
         "[[support]]\nat = 'start'\nkind = 'pin'\n"
         "[[load]]\nat = 'end'\nforce = ['0 N', '-1 N', '0 N']\n"
         "[[probe]]\nname = 'tip'\nkind = 'displacement'\n";
  const std::string line = plastica::testing::message_of(
      [&] { read("[[claim]]\nname = 'a'\nscene = 'loose.toml'\nfailed = { at_most = 0 }\n"); });
  EXPECT_EQ(line, folder_.file("loose.toml") +
                      ":5: support: the supports together leave the beam free to rotate about x "
                      "(level planar)");
}

TEST_F(SceneClaims, AreRefusedInOneLineIfBad) {
  EXPECT_EQ(message("value = { at_most = 1 }"), ":1: claim[1]: needs a probe or a quantity");
  EXPECT_EQ(message("probe = 'top'\nvalue = { at_most = 1 }"),
            ":4: claim[1].probe = top: is not a probe of the scene; it has tip, clamp_moment");
  EXPECT_EQ(message("probe = 'tip'\nvalue = { at_most = '1 s' }").substr(0, 38),
            ":5: claim[1].value.at_most = 1 s: \"s\" ");
  EXPECT_EQ(message("probe = 'tip'\nvalue = {}"),
            ":5: claim[1].value = {}: needs at_least or at_most");
  EXPECT_EQ(message("probe = 'tip'\nerror = { at_most = '1 %' }"),
            ":5: claim[1].error = { at_most = '1 %' }: needs against");
  EXPECT_EQ(message("probe = 'tip'\norder = { at_least = 1 }"),
            ":5: claim[1].order = { at_least = 1 }: is about a sweep, not about a scene");
  EXPECT_EQ(message("probe = 'tip'\nagainst = 'finest'\nerror = { at_most = '1 %' }"),
            ":5: claim[1].against = finest: needs an axis that refines, such as beam.segments");
  EXPECT_EQ(message("status = 'complete'").substr(0, 43),
            ":4: claim[1].status = 'complete': must be o");
  EXPECT_EQ(message("failed = { at_most = 1 }"),
            ":4: claim[1].failed = { at_most = 1 }: holds whatever happens: there are 1");
  EXPECT_EQ(message("work = { at_least = 0 }"),
            ":4: claim[1].work = { at_least = 0 }: holds whatever happens: at_least must be above "
            "0");
  EXPECT_EQ(message("sweep = 'a.toml'\nfailed = { at_most = 0 }").substr(0, 40),
            ":4: claim[1].sweep = a.toml: is not a fi");
  EXPECT_EQ(message("fit = 'cantilever.toml'\nfailed = { at_most = 0 }"),
            ":4: claim[1].fit = cantilever.toml: is a second one that the claim is about");
  EXPECT_EQ(message("probe = 'tip'\ntake = 'curve'\nvalue = { at_most = '1 m' }"),
            ":5: claim[1].take = curve: is no number; a value is one");
}

}  // namespace
}  // namespace plastica::sweeps
