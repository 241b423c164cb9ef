#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/cli/command.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kOutcomeCurves = "'*-curve.csv'";

void write_good_curves(const Workplace& place) {
  place.write("a-curve.csv", broken_curve(350.0, 1));
  place.write("c-curve.csv", broken_curve(360.0, 2));
  place.write("fit.toml", fit_file(kOutcomeCurves));
}

/// While it lives, no file that this process or its children write may grow beyond a size.
class LimitOfFileSize {
 public:
  explicit LimitOfFileSize(rlim_t bytes) {
    if (getrlimit(RLIMIT_FSIZE, &before_) != 0) throw std::runtime_error("getrlimit");
    handler_ = std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead; children inherit it
    const rlimit limit{bytes, before_.rlim_max};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("setrlimit");
  }
  ~LimitOfFileSize() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  LimitOfFileSize(const LimitOfFileSize&) = delete;
  LimitOfFileSize& operator=(const LimitOfFileSize&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

void expect_machine_failure(const CommandResult& result, const std::string& beginning) {
  EXPECT_EQ(result.code, 3) << result.err;
  EXPECT_EQ(lines_of(result.err), 1U) << result.err;
  EXPECT_TRUE(result.err.starts_with("plastica: " + beginning)) << result.err;
}

TEST(Outcome, IsZeroIfEveryTargetIsFitted) {
  const Workplace place;
  write_good_curves(place);
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(result.out.ends_with("\nfitted 2, rejected 0, failed 0\n")) << result.out;
  EXPECT_EQ(result.err, "wrote fit.h5\n");
}

/// One specimen of three is bad: the others are fitted, and its row says why.
void expect_one_rejected(const std::vector<std::string>& arguments, const std::string& bad,
                         const std::string& reason) {
  const Workplace place;
  write_good_curves(place);
  place.write("b-curve.csv", bad);
  std::vector<std::string> all = arguments;
  all.insert(all.end(), {"-o", "fit.h5", "--json", "fit.json"});
  const CommandResult result = place.run(all);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_EQ(result.err, "wrote fit.h5\n");
  EXPECT_TRUE(result.out.ends_with("\nfitted 2, rejected 1, failed 0\n")) << result.out;
  EXPECT_NE(result.out.find(reason), std::string::npos) << result.out;
  const auto fits = nlohmann::json::parse(place.read("fit.json")).at("fits");
  ASSERT_EQ(fits.size(), 3U);
  for (const auto& fit : fits) {
    const bool is_bad = fit.at("name") == "b-curve";
    EXPECT_EQ(fit.at("status"), is_bad ? "rejected" : "fitted");
    if (is_bad) {
      EXPECT_NE(fit.at("reason").get<std::string>().find(reason), std::string::npos) << fit;
    } else {
      EXPECT_TRUE(fit.at("reason").is_null());
    }
  }
  EXPECT_FALSE(place.has("fit.h5.journal"));
}

TEST(Outcome, OfABadSpecimenAmongGoodOnesIsOne) {
  const std::vector<std::string> fit = {"calibrate", "fit.toml"};
  expect_one_rejected(fit, "", "b-curve.csv: is empty");
  expect_one_rejected(fit, "\"", "b-curve.csv:1: has a quote that is not closed");
  expect_one_rejected(fit, std::string("\0\1\2", 3), "b-curve.csv:1: is not text");
  expect_one_rejected(fit, "Strain (%),Stress (MPa)\n", "b-curve.csv: holds no data row");
  expect_one_rejected(fit, "Strain (%),Stress (MPa)\n0,1\n1\n2,3\n", "b-curve.csv:3: has 1 cell");
  expect_one_rejected(fit, "Strain (%),Stress (MPa)\n0,1\n1,high\n",
                      "b-curve.csv:3: Stress = high");
}

TEST(Outcome, OfABadFileAmongBareCurvesIsOne) {
  const std::vector<std::string> bare = {"calibrate", "a-curve.csv", "b-curve.csv", "c-curve.csv"};
  expect_one_rejected(bare, "", "b-curve.csv: is empty");
  expect_one_rejected(bare, "\"", "b-curve.csv:1: has a quote that is not closed");
  expect_one_rejected(bare, "Strain (%),Stress (MPa)\n0,1\n1,high\n",
                      "b-curve.csv:3: Stress = high");
}

TEST(Outcome, OfSpecimensThatAreAllBadIsOne) {
  const Workplace place;
  place.write("a-curve.csv", "");
  place.write("fit.toml", fit_file(kOutcomeCurves));
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(result.out.ends_with("\nfitted 0, rejected 1, failed 0\n")) << result.out;
  EXPECT_EQ(place.run({"show", "fit.h5"}).code, 0);
}

TEST(Outcome, OfAFullDiskIsThreeAndTheRunCanGoOn) {
  const Workplace place;
  write_good_curves(place);
  {
    const LimitOfFileSize limit(64 * 1024);  // enough for the journal, not for the result
    expect_machine_failure(place.run({"calibrate", "fit.toml"}),
                           "fit.h5: cannot be written: File too large\n");
  }
  EXPECT_FALSE(place.has("fit.h5"));
  EXPECT_FALSE(place.has("fit.h5.part"));
  const CommandResult resumed = place.run({"calibrate", "fit.toml", "--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(resumed.err, "2 fits resumed from the journal\nwrote fit.h5\n");
}

TEST(Outcome, OfAFullDiskKeepsTheOutputThatIsThere) {
  const Workplace place;
  write_good_curves(place);
  place.write("fit.h5", "my own");
  {
    const LimitOfFileSize limit(64 * 1024);
    expect_machine_failure(place.run({"calibrate", "fit.toml", "--force"}), "fit.h5: ");
  }
  EXPECT_EQ(place.read("fit.h5"), "my own");
}

TEST(Outcome, OfAJournalThatCannotGrowIsThree) {
  const Workplace place;
  write_good_curves(place);
  const LimitOfFileSize limit(512);
  expect_machine_failure(place.run({"calibrate", "fit.toml", "--quiet"}), "fit.h5.journal: ");
}

TEST(Outcome, OfAFullStandardOutputIsThree) {
  const Workplace place;
  write_good_curves(place);
  ASSERT_EQ(place.run({"calibrate", "fit.toml", "--quiet"}).code, 0);
  for (const char* command : {"show fit.h5", "export fit.h5", "fields", "inspect a-curve.csv"}) {
    SCOPED_TRACE(command);
    const std::string line = std::string("exec \"$0\" ") + command + " >/dev/full";
    const CommandResult result = place.run_program("/bin/sh", {"-c", line, PLASTICA_COMMAND});
    expect_machine_failure(result, "");
    EXPECT_NE(result.err.find("writ"), std::string::npos) << result.err;
  }
}

TEST(Outcome, WithoutGnuplotIsThreeButTheScriptCanBeWritten) {
  const Workplace place;
  write_good_curves(place);
  ASSERT_EQ(place.run({"calibrate", "fit.toml", "--quiet"}).code, 0);
  expect_machine_failure(place.run({"plot", "fit.h5", "-o", "fit.svg"}, {"PATH="}),
                         "cannot draw: there is no program 'gnuplot' on the PATH");
  EXPECT_FALSE(place.has("fit.svg"));
  EXPECT_EQ(place.run({"plot", "fit.h5", "-o", "fit.gp"}, {"PATH="}).code, 0);
  EXPECT_TRUE(place.has("fit.gp"));
}

}  // namespace
}  // namespace plastica::testing
