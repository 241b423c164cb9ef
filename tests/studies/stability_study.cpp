// Stability at the extremes: every point of the scans (sweeps/stability) is valid, says that it is
// not, or is refused; none is an undetected error. PLASTICA_STUDY=full runs all, =sample a
// seeded 100 of the cheap ones. With PLASTICA_STABILITY_OUT=NAME in the environment NAME.csv,
// NAME.md and NAME.svg hold the points, the tables and the map.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "plastica/report/picture.hpp"
#include "sweeps/stability/stability.hpp"
#include "sweeps/stability/stability_map.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::sweeps::stability {
namespace {

void write_results(const std::vector<StabilityRow>& rows, const std::string& name) {
  std::ofstream(name + ".csv") << rows_csv(rows);
  std::ofstream(name + ".md") << summary_text(rows);
  report::draw_picture(stability_map(rows), name + ".svg", std::cout);
}

TEST(Stability, IsNowhereWrongWithoutSayingSo) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool full = study != nullptr && std::string(study) == "full";
  StabilityOptions options;
  if (!full) {
    options.sample = 60;
    options.max_segment_steps = 2e4;
    options.min_segment_steps = 5e4;
  }
  options.progress = [](const StabilityRow& row, std::size_t finished, std::size_t all) {
    if (finished % 500 == 0) std::fprintf(stderr, "%zu of %zu points\n", finished, all);
    if (row.verdict.validity != Validity::Undetected) return;
    std::fprintf(stderr, "%s: %s\n", row.id.c_str(), row.verdict.reason.c_str());
  };
  const std::vector<StabilityRow> rows = run_stability(options);
  EXPECT_EQ(rows.size() >= 2000, full);
  for (const StabilityRow& row : rows) {
    EXPECT_TRUE(row.begun) << row.id;
    EXPECT_NE(row.verdict.validity, Validity::Undetected) << row.id << ": " << row.verdict.reason;
  }
  std::puts(summary_text(rows).c_str());
  if (const char* name = std::getenv("PLASTICA_STABILITY_OUT")) write_results(rows, name);
}

}  // namespace
}  // namespace plastica::sweeps::stability
