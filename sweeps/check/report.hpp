#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sweeps/check/claim.hpp"
#include "sweeps/check/verdict.hpp"

namespace plastica::sweeps {

/// A check file and what became of its claims.
struct CheckedFile {
  CheckFile file;
  std::vector<ClaimVerdict> verdicts;  ///< (n_claims)
  double seconds = 0.0;                ///< that its sweeps took [s]
};

/// How much of a check is printed.
enum class CheckLines {
  All,          ///< the file's name, then a line a claim
  FailuresOnly  ///< the lines of claims that do not hold, and nothing where all do
};

/// A line a claim: PASS or FAIL, its name, the number that was found, the limit; of one that does
/// not hold also the case, what was wanted, and where the claim stands. The two words stand nowhere
/// else: what names have of them is written in lower case.
std::string check_report(const CheckedFile& checked, CheckLines lines = CheckLines::All);

/// What is printed of one claim: its line, then the warnings of what it is about.
std::string claim_report(const CheckedFile& checked, std::size_t claim);

/// What was found of a claim: "0.03047 %", "completed", "265 … 290 MPa"; empty where there is no
/// number.
std::string seen_text(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict);

/// How many claims hold, of all files, in a line.
std::string check_summary(std::span<const CheckedFile> files);

/// All files in JUnit's XML: a test suite a file, a test case a claim, with its time, file and
/// line.
std::string junit_xml(std::span<const CheckedFile> files);

/// An error of GitHub's workflow commands for each claim that does not hold, a line each, which
/// GitHub shows at the claim's line: "::error file=…,line=…,title=…::…".
std::string github_annotations(const CheckedFile& checked);

}  // namespace plastica::sweeps
