#include "calibrate/target/curve_spool.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "calibrate/target/import.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/storage_error.hpp"
#include "tests/calibrate/target/curve_files.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::calibrate {
namespace {

Curve numbered_curve(std::size_t samples, double first) {
  Curve curve;
  for (std::size_t i = 0; i < samples; ++i) {
    curve.strain.push_back(first + static_cast<double>(i));
    curve.stress.push_back(-first - 0.5 * static_cast<double>(i));
  }
  return curve;
}

void expect_same(const Curve& a, const Curve& b) {
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.stress, b.stress);
}

/// In memory, in the file, and with a curve that memory has no room left for.
TEST(CurveSpool, GivesBackWhatItTook) {
  const io::ScratchFolder folder;
  for (const std::size_t bytes : {0U, 1000U, 100'000'000U}) {
    const auto spool = std::make_shared<CurveSpool>(folder.file(""), bytes);
    std::vector<Curve> curves(200);
    parallel_for(curves.size(), {4, nullptr}, [&](std::size_t i, int) {
      curves[i] = numbered_curve(i, static_cast<double>(i * i));
      put_aside(curves[i], spool);
    });
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_EQ(curves[i].samples(), i);
      EXPECT_EQ(curves[i].size(), 0U);
      expect_same(with_samples(curves[i]), numbered_curve(i, static_cast<double>(i * i)));
    }
    // What is aside already is left where it is.
    const std::uint64_t before = curves[9].aside.offset;
    put_aside(curves[9], spool);
    EXPECT_EQ(curves[9].aside.offset, before);
    EXPECT_TRUE(folder.names().empty());  // its file has no name
  }
}

TEST(CurveSpool, KeepsEachBit) {
  const io::ScratchFolder folder;
  const auto spool = std::make_shared<CurveSpool>(folder.file(""), 0);
  const double other_nan = std::bit_cast<double>(std::uint64_t{0x7ff8000000000123});
  const std::vector<double> odd{-0.0, 5e-324, INFINITY, other_nan};
  Curve curve{odd, odd};
  put_aside(curve, spool);
  const Curve read = with_samples(curve);
  for (std::size_t i = 0; i < odd.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.strain[i]), std::bit_cast<std::uint64_t>(odd[i]));
  }
}

TEST(CurveSpool, SaysWhichFolderTakesNoFile) {
  const io::ScratchFolder folder;
  CurveSpool spool(folder.file("none"), 0);
  try {
    spool.put(std::vector{1.0}, std::vector{2.0});
    FAIL();
  } catch (const io::StorageError& error) {
    EXPECT_EQ(error.what(), folder.file("none") +
                                ": cannot take the curves of the run (the variable TMPDIR can name "
                                "another folder): No such file or directory");
  }
  EXPECT_THROW(spool.put(std::vector{1.0}, std::vector<double>{}), std::logic_error);
}

TEST(CurveSpool, TargetsOutliveTheirBatch) {
  const io::ScratchFolder folder;
  Target target;
  target.name = "a";
  target.raw = numbered_curve(5, 1.0);
  target.corrected = numbered_curve(3, 2.0);
  const Target before = target;
  {
    const CorrectedTarget here(target);
    EXPECT_EQ(&*here, &target);  // nothing was aside: nothing is copied
  }
  put_aside(target, std::make_shared<CurveSpool>(folder.file(""), 0));
  const CorrectedTarget read(target);
  EXPECT_EQ(read->name, "a");
  expect_same(read->corrected, before.corrected);
  expect_same(with_samples(target.raw), before.raw);
}

/// A corrected curve that is samples of the raw one in a row, shifted, takes no room of its own,
/// wherever the memory ends; one that is not comes back as well.
TEST(CurveSpool, TakesWhatTheRawCurveHasOnce) {
  const io::ScratchFolder folder;
  constexpr std::size_t kNumbers = 40;  // of the raw curve
  for (const std::size_t numbers : {0U, 30U, 39U, 40U, 41U, 79U, 100U}) {
    const auto spool = std::make_shared<CurveSpool>(folder.file(""), numbers * sizeof(double));
    for (const double shift : {0.0, 0.1}) {
      for (const std::size_t changed : {30U, 5U}) {  // one beyond all changes none
        Target target;
        target.raw = numbered_curve(kNumbers / 2, 1.0 / 3.0);
        target.corrections.push_back({"toe", shift != 0.0, shift, "1", ""});
        for (std::size_t i = 3; i < 15; ++i) {
          target.corrected.strain.push_back(target.raw.strain[i] - shift);
          target.corrected.stress.push_back(target.raw.stress[i] *
                                            (i == changed ? 1.0 + 1e-15 : 1.0));
        }
        const Target before = target;
        put_aside(target, spool);
        const std::uint64_t behind = target.raw.aside.offset + kNumbers;
        EXPECT_EQ(target.corrected.aside.offset < behind, changed == 30U);
        EXPECT_EQ(target.corrected.samples(), 12U);
        EXPECT_EQ(bytes_of_curves(target), (kNumbers + (changed == 30U ? 0 : 24)) * sizeof(double));
        EXPECT_EQ(digest_of(target.corrected), digest_of(before.corrected));
        expect_same(with_samples(target.corrected), before.corrected);
        expect_same(with_samples(target.raw), before.raw);
      }
    }
  }
}

TEST(CurveSpool, TakesTheCurvesOfAnImport) {
  const testing::CurveFiles files("spool");
  const TargetSource source = testing::CurveFiles::source(
      {files.write_curve("a.csv", 1.0, 1e-6), files.write("bad.csv", "a,b\n1,2\n3,4\n")});
  const io::ScratchFolder folder;
  const auto spool = std::make_shared<CurveSpool>(folder.file(""), 0);
  const std::vector<Target> here = import_targets(source);
  const std::vector<Target> aside = import_targets(source, {}, 2, spool);
  ASSERT_EQ(here.size(), aside.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(aside[i].name, here[i].name);
    EXPECT_EQ(aside[i].reason, here[i].reason);
    EXPECT_EQ(aside[i].raw.size() + aside[i].corrected.size(), 0U);
    expect_same(with_samples(aside[i].raw), here[i].raw);
    expect_same(with_samples(aside[i].corrected), here[i].corrected);
  }
}

}  // namespace
}  // namespace plastica::calibrate
