#include "sweeps/check/report.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sweeps/check/worst.hpp"

namespace plastica::sweeps {
namespace {

/// A file of a claim on an error that does not hold, and one on work that does.
CheckedFile checked() {
  CheckedFile all;
  all.file.path = "checks/a.toml";
  Claim error;
  error.name = "FAIL to PASS & <go>";
  error.where = {"checks/a.toml", 7};
  error.kind = ClaimKind::Error;
  error.at_most = 1e-4;
  Claim work = error;
  work.name = "cheap";
  work.where.line = 12;
  work.kind = ClaimKind::Work;
  work.at_most = 100.0;
  all.file.claims = {error, work};
  ClaimVerdict off;
  off.number = 0.0194859;
  off.at = "at beam.segments = 5";
  off.beside = "tip, end -0.75 m, reference -0.735 m";
  off.seconds = 0.25;
  ClaimVerdict held;
  held.holds = true;
  held.number = 36.0;
  held.seconds = 0.25;
  all.verdicts = {off, held};
  all.seconds = 0.5;
  return all;
}

TEST(CheckReport, SaysOfAFailureTheCaseTheNumberTheLimitAndThePlace) {
  EXPECT_EQ(check_report(checked()),
            "checks/a.toml\n"
            "  FAIL  fail to pass & <go>  error 1.949 % at beam.segments = 5 (tip, end -0.75 m, "
            "reference -0.735 m); wanted at most 0.01 %; checks/a.toml:7\n"
            "  PASS  cheap                work 36, at most 100\n");
}

TEST(CheckReport, SaysWhyThereIsNoNumber) {
  CheckedFile all = checked();
  all.verdicts[0].number.reset();
  all.verdicts[0].beside.clear();
  all.verdicts[0].reason = "ended as not-converged";
  EXPECT_NE(
      check_report(all).find("  error at beam.segments = 5: ended as not-converged; wanted at "
                             "most 0.01 %; checks/a.toml:7\n"),
      std::string::npos)
      << check_report(all);
}

TEST(CheckReport, HasOnlyFailuresWhereNothingElseIsWanted) {
  CheckedFile all = checked();
  const std::string quiet = check_report(all, CheckLines::FailuresOnly);
  EXPECT_EQ(quiet,
            "  FAIL  fail to pass & <go>  error 1.949 % at beam.segments = 5 (tip, end -0.75 m, "
            "reference -0.735 m); wanted at most 0.01 %; checks/a.toml:7\n");
  all.verdicts[0].holds = true;
  EXPECT_EQ(check_report(all, CheckLines::FailuresOnly), "");
}

TEST(CheckReport, CountsWhatHolds) {
  EXPECT_EQ(check_summary(std::vector{checked()}), "1 of 2 claims hold, 0.5 s\n");
}

TEST(CheckReport, HasTimesAndPlacesInJUnitsXml) {
  EXPECT_EQ(
      junit_xml(std::vector{checked()}),
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "  <testsuite name=\"checks/a.toml\" tests=\"2\" failures=\"1\" errors=\"0\" "
      "time=\"0.500\">\n"
      "    <testcase classname=\"checks/a.toml\" name=\"FAIL to PASS &amp; &lt;go&gt;\" "
      "file=\"checks/a.toml\" line=\"7\" time=\"0.250\">\n"
      "      <failure message=\"error 1.949 % at beam.segments = 5 (tip, end -0.75 m, reference "
      "-0.735 m); wanted at most 0.01 %\">error 1.949 % at beam.segments = 5 (tip, end -0.75 m, "
      "reference -0.735 m); wanted at most 0.01 %; checks/a.toml:7</failure>\n"
      "    </testcase>\n"
      "    <testcase classname=\"checks/a.toml\" name=\"cheap\" file=\"checks/a.toml\" "
      "line=\"12\" time=\"0.250\">\n"
      "      <system-out>work 36, at most 100</system-out>\n"
      "    </testcase>\n"
      "  </testsuite>\n</testsuites>\n");
}

TEST(CheckReport, AnnotatesFailuresForGitHub) {
  CheckedFile all = checked();
  all.file.claims[0].name = "50 %, all: well\r\nso";
  all.file.claims[0].where.file = "a,b:c.toml";
  // In properties the signs that part them are codes; in the message only % and line ends.
  EXPECT_EQ(github_annotations(all),
            "::error file=a%2Cb%3Ac.toml,line=7,title=50 %25%2C all%3A well%0D%0Aso::error 1.949 "
            "%25 at beam.segments = 5 (tip, end -0.75 m, reference -0.735 m); wanted at most 0.01 "
            "%25\n");
  all.verdicts[0].holds = true;
  EXPECT_EQ(github_annotations(all), "");
}

TEST(WorstNumber, IsNoneWhereOneIsMissingOrNotFinite) {
  Claim claim;
  claim.at_most = 1.0;
  for (const double number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    Worst worst(claim);
    worst.add(0.5, 0, "");
    worst.add(number, 1, "");
    EXPECT_FALSE(worst.verdict().holds);
    EXPECT_EQ(worst.whose(), 1U);
    EXPECT_EQ(worst.verdict().reason, "there is no number");
  }
  EXPECT_FALSE(Worst(claim).verdict().holds) << "nothing is no number";
}

}  // namespace
}  // namespace plastica::sweeps
