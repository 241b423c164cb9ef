#include <gtest/gtest.h>

#include "tests/sweeps/check/check_fixture.hpp"

namespace plastica::sweeps {
namespace {

const std::string kHalf = "where = { rules.end_rule = 'half_joint' }\n";

TEST_F(CheckTest, JudgesTheOrder) {
  EXPECT_TRUE(verdict(kHalf + "order = { at_least = 1.98, at_most = 2.02 }\n").holds);
  const ClaimVerdict of_both = verdict("order = { at_least = 1.98 }\n");
  EXPECT_FALSE(of_both.holds);
  EXPECT_NEAR(of_both.number.value_or(0.0), 0.95, 0.05);  // the worst: that of the rigid clamp
}

TEST_F(CheckTest, JudgesErrorsOfTheChosenCases) {
  EXPECT_TRUE(verdict("where = { rules.end_rule = 'half_joint', beam.segments = [8, 16] }\n"
                      "error = { at_most = '1 %' }\n")
                  .holds);
  EXPECT_FALSE(verdict(kHalf + "error = { at_most = '1 %' }\n").holds);
}

TEST_F(CheckTest, JudgesWhatElseASweepSays) {
  EXPECT_TRUE(verdict(kHalf + "extrapolated_error = { at_most = 1e-5 }\n").holds);
  EXPECT_FALSE(verdict("extrapolated_error = { at_most = 1e-5 }\n").holds);
  EXPECT_TRUE(verdict(kHalf + "gci = { at_most = '1 %' }\n").holds);
  EXPECT_FALSE(verdict("gci = { at_most = '1 %' }\n").holds);
  EXPECT_TRUE(verdict("correlation = { at_least = 0.999 }\n").holds);
  EXPECT_TRUE(verdict("work = { at_most = 1000 }\n").holds);
  EXPECT_FALSE(verdict("work = { at_most = 100 }\n").holds);
  EXPECT_TRUE(verdict("failed = { at_most = 0 }\n").holds);
  EXPECT_TRUE(verdict(kHalf + "spread = { at_most = '3 %' }\n").holds);
  EXPECT_FALSE(verdict("spread = { at_most = '3 %' }\n").holds);
  EXPECT_TRUE(verdict(kHalf + "value = { at_least = '-800 mm', at_most = '-700 mm' }\n").holds);
  EXPECT_FALSE(verdict("value = { at_most = '-700 mm' }\n").holds);
}

TEST_F(CheckTest, JudgesScansToTheEdge) {
  write("check.toml",
        "[[claim]]\nname = 'a'\nstability = { only = ['coupon'], max_work = 1e3 }\n"
        "undetected = { at_most = 0 }\n"
        "[[claim]]\nname = 'b'\nstability = { only = ['none of them'] }\n"
        "invalid = { at_most = 0 }\n");
  const auto verdicts = run_check(read_check_file(folder_.file("check.toml")), {});
  EXPECT_TRUE(verdicts[0].holds);
  EXPECT_FALSE(verdicts[1].holds);
  EXPECT_EQ(verdicts[1].reason, "no case is chosen");
}

TEST_F(CheckTest, TakesAnOldKeyAndNamesTheNewOne) {
  const auto read = [&](const std::string& work) {
    write("check.toml",
          "[[claim]]\nname = 'a'\nstability = { " + work + " }\nundetected = { at_most = 0 }\n");
    return read_check_file(folder_.file("check.toml"));
  };
  const CheckFile now = read("max_work = 1e3");
  EXPECT_TRUE(now.notes.empty());
  const CheckFile old = read("most_work = 1e3");
  ASSERT_EQ(old.notes.size(), 1u);
  EXPECT_EQ(old.notes[0], folder_.file("check.toml") + ":3: most_work is now max_work");
  EXPECT_EQ(old.claims[0].scan->max_segment_steps, now.claims[0].scan->max_segment_steps);
  EXPECT_EQ(now.claims[0].scan->max_segment_steps, 1e3);
  EXPECT_THROW(read("max_work = 1e3, most_work = 1e3"), InputError);
}

TEST_F(CheckTest, TakesOldClaimsOfTheStudyAtTheExtremes) {
  const auto read_claim = [&](const std::string& claim) {
    write("check.toml", "[[claim]]\nname = 'a'\nstability = {}\n" + claim + " = { at_most = 0 }\n");
    return read_check_file(folder_.file("check.toml"));
  };
  EXPECT_EQ(read_claim("undetected").claims.at(0).kind, ClaimKind::Undetected);
  EXPECT_EQ(read_claim("invalid").claims.at(0).kind, ClaimKind::Invalid);
  EXPECT_TRUE(read_claim("invalid").notes.empty());
  EXPECT_EQ(read_claim("silent").claims.at(0).kind, ClaimKind::Undetected);
  EXPECT_EQ(read_claim("unsound").claims.at(0).kind, ClaimKind::Invalid);
  EXPECT_EQ(read_claim("silent").notes,
            std::vector{folder_.file("check.toml") + ":4: silent is now undetected"});
}

TEST_F(CheckTest, TakesAnOldClaimAndNamesTheNewOne) {
  const CheckFile old = read("ledger = { at_most = 0.01 }");
  EXPECT_EQ(old.claims[0].kind, ClaimKind::EnergyBalance);
  ASSERT_EQ(old.notes.size(), 1u);
  EXPECT_EQ(old.notes[0], folder_.file("check.toml") + ":4: ledger is now energy_balance");
  EXPECT_TRUE(read("energy_balance = { at_most = 0.01 }").notes.empty());
}

TEST_F(CheckTest, RefusesTwoClaimsOfOneName) {
  const std::string claim =
      "[[claim]]\nname = 'a'\nsweep = 'sweep.toml'\nfailed = { at_most = 0 }\n";
  write("check.toml", claim + claim);
  const std::string line =
      plastica::testing::message_of([&] { read_check_file(folder_.file("check.toml")); });
  EXPECT_EQ(line,
            folder_.file("check.toml") +
                ":6: claim[2].name = a: is the name of the claim in line 1: each has its own");
}

TEST_F(CheckTest, DoesNotHoldWhereThereIsNoNumber) {
  const ClaimVerdict found = verdict(
      "where = { rules.end_rule = 'equal', beam.segments = [4] }\norder = { at_most = 9 }\n");
  EXPECT_FALSE(found.holds);
  EXPECT_EQ(found.at, "at rules.end_rule = equal");
  EXPECT_EQ(found.reason, "there is no order");
}

TEST_F(CheckTest, SaysWhichCaseIsTheWorst) {
  const ClaimVerdict found = verdict(kHalf + "error = { at_most = '1 %' }\n");
  EXPECT_EQ(found.at, "at beam.segments = 4, rules.end_rule = half_joint");
  EXPECT_EQ(found.beside.substr(0, 20), "tip, end -0.757694 m") << found.beside;
  const ClaimVerdict low = verdict(kHalf + "error = { at_least = '0.5 %' }\n");
  EXPECT_EQ(low.at, "at beam.segments = 16, rules.end_rule = half_joint");
  const ClaimVerdict order = verdict("order = { at_least = 1.98 }\n");
  EXPECT_EQ(order.at, "at rules.end_rule = equal");
}

TEST_F(CheckTest, KeepsWhatItWasJudgedByTheWorstFirst) {
  const ClaimVerdict found = verdict(kHalf + "error = { at_most = '1 %' }\n");
  EXPECT_EQ(found.judged, 3U);
  ASSERT_EQ(found.worst.size(), 3U);
  EXPECT_EQ("at " + found.worst[0].of, found.at);
  EXPECT_EQ(found.worst[0].number, found.number);
  EXPECT_GT(found.worst[0].number, found.worst[1].number);
  EXPECT_GT(found.worst[1].number, found.worst[2].number);
  const ClaimVerdict low = verdict(kHalf + "error = { at_least = '0.5 %' }\n");
  EXPECT_EQ(low.worst[0].of, found.worst[2].of);
  const ClaimVerdict order = verdict("order = { at_least = 1.98 }\n");
  ASSERT_EQ(order.worst.size(), 2U);
  EXPECT_EQ(order.worst[0].of, "rules.end_rule = equal");
  EXPECT_EQ(order.errors.over, "beam.segments");
  ASSERT_EQ(order.errors.points.size(), 3U);
  EXPECT_DOUBLE_EQ(order.errors.points[2][0], 16.0);
  EXPECT_TRUE(found.errors.points.empty());
}

TEST_F(CheckTest, KeepsNoMoreThanAFew) {
  SweepRecord record;
  constexpr std::size_t kCases = 100;
  record.results.resize(kCases);
  record.ids.resize(kCases);
  for (std::size_t i = 0; i < kCases; ++i) {
    record.results[i].status = Status::Completed;
    record.results[i].value = static_cast<double>(i * 37 % kCases);
  }
  record.results[50].value.reset();
  record.results[50].reason = "has none";
  record.comparison.lacks.resize(kCases);
  record.comparison.reason.resize(kCases);
  Claim claim;
  claim.kind = ClaimKind::Value;
  claim.at_most = 2.0;
  const ClaimVerdict found = judge(claim, record);
  EXPECT_EQ(found.judged, kCases);
  ASSERT_EQ(found.worst.size(), kMostJudged);
  EXPECT_EQ(found.worst[0].remark, "has none");
  for (std::size_t k = 1; k < kMostJudged; ++k) {
    EXPECT_EQ(found.worst[k].number, 100.0 - static_cast<double>(k));
  }
}

TEST_F(CheckTest, SharesTheTimeOfASweepAmongItsClaims) {
  write("check.toml",
        "[[claim]]\nname = 'a'\nsweep = 'sweep.toml'\nfailed = { at_most = 0 }\n"
        "[[claim]]\nname = 'b'\nsweep = 'sweep.toml'\nwork = { at_most = 1e9 }\n");
  const auto verdicts = run_check(read_check_file(folder_.file("check.toml")), {});
  EXPECT_GT(verdicts[0].seconds, 0.0);
  EXPECT_EQ(verdicts[0].seconds, verdicts[1].seconds);
}

TEST_F(CheckTest, TakesNoValueOfAMotionThatIsNotBalanced) {
  // Its energy is off by more than 1 %: it went to its end and has values, not to be trusted.
  SweepRecord record;
  record.ids = {"a"};
  record.results.resize(1);
  record.results[0].status = Status::NotBalanced;
  record.results[0].value = 1.0;
  record.comparison.lacks.resize(1);
  record.comparison.reason.resize(1);
  record.comparison.reference.resize(1);
  record.comparison.error = {0.0};
  record.comparison.reference_error.resize(1);
  for (const ClaimKind kind : {ClaimKind::Value, ClaimKind::Error, ClaimKind::Spread}) {
    Claim claim;
    claim.kind = kind;
    claim.at_most = 2.0;
    EXPECT_FALSE(judge(claim, record).holds);
    record.results[0].status = Status::Completed;
    // Of one case there is no spread, which a limit could not but hold.
    EXPECT_EQ(judge(claim, record).holds, kind != ClaimKind::Spread);
    record.results[0].status = Status::NotBalanced;
  }
}

TEST_F(CheckTest, SaysWhichCaseFailed) {
  write("sweep.toml", std::string("scene = '") + PLASTICA_SOURCE_DIR +
                          "/data/scenes/cantilever.toml'\n[set]\nsolver.steps = 1\n"
                          "solver.smallest_step = 1\n"
                          "[[axis]]\nfield = 'solver.max_iterations'\nvalues = [25, 1]\n"
                          "[error]\nprobe = 'tip'\n");
  const ClaimVerdict failed = verdict("failed = { at_most = 0 }\n");
  EXPECT_EQ(failed.number, 1.0);
  EXPECT_EQ(failed.beside.substr(0, 52), "solver.max_iterations = 1 ended as not-converged: ta")
      << failed.beside;
  ASSERT_EQ(failed.worst.size(), 1U);
  EXPECT_EQ(failed.worst[0].of, "solver.max_iterations = 1");
  EXPECT_TRUE(failed.worst[0].remark.starts_with("ended as not-converged"))
      << failed.worst[0].remark;
  const ClaimVerdict value = verdict("value = { at_least = '-9 m' }\n");
  EXPECT_EQ(value.at, "at solver.max_iterations = 1");
  EXPECT_FALSE(value.number);
  EXPECT_EQ(value.reason.substr(0, 22), "ended as not-converged") << value.reason;
}

TEST_F(CheckTest, DoesNotHoldWhereACaseFails) {
  // The finest case does not converge in one iteration.
  const std::string scenes = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/";
  write("sweep.toml", "scene = '" + scenes +
                          "cantilever.toml'\n[set]\nsolver.steps = 1\n"
                          "solver.smallest_step = 1\n"
                          "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8, 16, 32]\nzip = 'a'\n"
                          "[[axis]]\nfield = 'solver.max_iterations'\n"
                          "values = [25, 25, 25, 1]\nzip = 'a'\n[error]\nprobe = 'tip'\n"
                          "against = 'theory:elastica'\nalong = 'beam.segments'\n");
  for (const std::string claim :
       {"order = { at_least = 0 }", "gci = { at_most = '900 %' }", "work = { at_most = 1e9 }",
        "error = { at_most = '900 %' }", "failed = { at_most = 0 }"}) {
    EXPECT_FALSE(verdict("where = { solver.max_iterations = [25, 1] }\n" + claim + "\n").holds)
        << claim;
  }
}

TEST_F(CheckTest, RefusesBadClaimsInOneLine) {
  EXPECT_EQ(message(""),
            ":1: claim[1]: claims nothing: it needs one of order, correlation, error, "
            "extrapolated_error, gci, work, spread, value, energy_balance, failed, status");
  EXPECT_EQ(
      message("undetected = { at_most = 0 }\n"),
      ":4: claim[1].undetected = { at_most = 0 }: is about stability = { … }, not about a sweep");
  EXPECT_EQ(message("order = {}\n"), ":4: claim[1].order = {}: needs at_least or at_most");
  EXPECT_EQ(message("order = { at_least = 1 }\nerror = { at_most = 1 }\n"),
            ":5: claim[1].error = { at_most = 1 }: is a second claim: one table makes one");
  EXPECT_EQ(message("order = { at_least = 2, at_most = 1 }\n"),
            ":4: claim[1].order = { at_least = 2, at_most = 1 }: at_least must not be above "
            "at_most");
  EXPECT_EQ(message("order = { at_least = 2 }\nwhere = { beam.length = '1 m' }\n"),
            ":5: claim[1].where.beam.length = 1 m: is not the field of an axis of the sweep");
  EXPECT_EQ(message("order = { at_least = 2 }\nwhere = { beam.segments = 5 }\n"),
            ":5: claim[1].where.beam.segments = 5: is not a value of the axis");
}

}  // namespace
}  // namespace plastica::sweeps
