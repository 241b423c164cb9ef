#pragma once

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

/// A line a claim: PASS or FAIL, its name, the number that was found, the limit. The two words
/// stand nowhere else: what names have of them is written in lower case.
std::string check_report(const CheckedFile& checked);

/// How many claims hold, of all files, in a line.
std::string check_summary(std::span<const CheckedFile> files);

/// All files in JUnit's XML: a test suite a file, a test case a claim.
std::string junit_xml(std::span<const CheckedFile> files);

}  // namespace plastica::sweeps
