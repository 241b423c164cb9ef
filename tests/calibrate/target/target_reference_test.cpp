#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "calibrate/target/make.hpp"
#include "plastica/io/csv.hpp"
#include "tests/calibrate/target/curves.hpp"
#include "tests/support/shared.hpp"

namespace plastica::calibrate {
namespace {

constexpr double kKsi = 6894757.293168361;  // Pa

std::string data(const std::string& path) { return plastica::testing::shared_path("data/" + path); }

ColumnSource column(const std::string& name, const std::string& unit) { return {name, unit, {}}; }

TargetSource aakash_source() {
  TargetSource source;
  for (const auto& entry : std::filesystem::directory_iterator(data("al6061t651-aakash"))) {
    if (entry.path().filename().string().starts_with("test_ID_")) {
      source.files.push_back(entry.path().string());
    }
  }
  std::sort(source.files.begin(), source.files.end());
  source.strain = column("Strain", "1");
  source.stress = column("Stress_MPa", "MPa");
  source.table = TableSource{data("al6061t651-aakash/info.csv"), "test_id", {}, {}};
  source.group = {"temperature"};
  return source;
}

struct Means {
  double modulus = 0.0;
  double yield = 0.0;
  double ultimate = 0.0;
  double break_strain = 0.0;
  double count = 0.0;
};

std::map<std::string, Means> means_by_temperature(const std::vector<Target>& targets) {
  std::map<std::string, Means> groups;
  for (const Target& target : targets) {
    const Characteristics& c = target.characteristics;
    Means& sum = groups[target.group.at(0).second];
    sum.modulus += c.youngs_modulus.value_or(NAN);
    sum.yield += c.proof_stress.value_or(NAN);
    sum.ultimate += c.rm.value_or(NAN);
    sum.break_strain += c.break_strain.value_or(NAN);
    sum.count += 1.0;
  }
  for (auto& [temperature, sum] : groups) {
    for (double* value : {&sum.modulus, &sum.yield, &sum.ultimate, &sum.break_strain}) {
      *value /= sum.count;
    }
  }
  return groups;
}

TEST(TargetReference, NineSpecimensOfAl6061T6MeetThePublishedMetrics) {
  PLASTICA_NEEDS_SHARED("data");
  const std::map<std::string, std::vector<std::string>> labs{
      {"CA", {"01", "02", "03", "04"}}, {"NM", {"01", "02", "06", "07", "08"}}};
  TargetOptions options;
  options.youngs_modulus = 10000.0 * kKsi;
  int met = 0;
  for (const auto& [lab, numbers] : labs) {
    TargetSource source;
    for (const std::string& number : numbers) {
      source.files.push_back(data("al6061t6-matcal/cleaned_" + lab + "-RD-" + number + ".csv"));
    }
    source.strain = column("engineering_strain", "in/in");
    source.stress = column("engineering_stress", "ksi");
    const std::vector<Target> targets = import_targets(source, options);
    const auto published = io::CsvTable::read(
        data("al6061t6-matcal/RD_aluminum_AL_6061_tension_stress_metrics_" + lab + ".csv"));
    ASSERT_EQ(targets.size(), published.rows());
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Characteristics& c = targets[i].characteristics;
      EXPECT_EQ(targets[i].status, TargetStatus::Ready) << targets[i].name << targets[i].reason;
      ASSERT_TRUE(c.proof_stress && c.rm) << targets[i].name;
      EXPECT_NEAR(*c.proof_stress / kKsi, published.number(i, 0), 0.01) << targets[i].name;
      EXPECT_NEAR(c.largest_strain, published.number(i, 1), 1e-5) << targets[i].name;
      EXPECT_NEAR(*c.rm / kKsi, published.number(i, 2), 0.01) << targets[i].name;
      ++met;
    }
  }
  EXPECT_EQ(met, 9);
}

TEST(TargetReference, FortyThreeSpecimensOfAl6061T651HaveThePublishedMeans) {
  PLASTICA_NEEDS_SHARED("data");
  const std::vector<Target> targets = import_targets(aakash_source());
  ASSERT_EQ(targets.size(), 43U);
  for (const Target& target : targets) {
    EXPECT_EQ(target.status, TargetStatus::Ready) << target.name << ": " << target.reason;
    EXPECT_TRUE(target.characteristics.observed_break.has_value()) << target.name;
  }
  const auto groups = means_by_temperature(targets);
  const Means& room = groups.at("20");
  EXPECT_EQ(room.count, 19.0);
  EXPECT_NEAR(room.modulus, 60.1e9, 1.0e9);
  EXPECT_NEAR(room.yield, 258.8e6, 1.0e6);
  EXPECT_NEAR(room.ultimate, 288.3e6, 0.5e6);
  EXPECT_NEAR(room.break_strain, 0.108, 0.001);

  const auto published =
      io::CsvTable::read(data("al6061t651-aakash/published_means_by_temperature.csv"));
  for (const std::size_t row : {std::size_t{1}, std::size_t{2}}) {
    const Means& mean = groups.at(std::string(published.cell(row, 0)));
    const auto within_one_deviation = [&](double value, std::size_t at) {
      EXPECT_NEAR(value, published.number(row, at), published.number(row, at + 1))
          << published.cell(row, 0) << " column " << at;
    };
    within_one_deviation(mean.modulus / 1e9, 1);
    within_one_deviation(mean.yield / 1e6, 3);
    within_one_deviation(mean.ultimate / 1e6, 5);
    within_one_deviation(mean.break_strain * 100.0, 11);
  }
}

TEST(TargetReference, EachRepairOfAl6061T651IsNamedWithACount) {
  PLASTICA_NEEDS_SHARED("data");
  int with_nan = 0;
  int with_reversals = 0;
  for (const Target& target : import_targets(aakash_source())) {
    EXPECT_EQ(target.loading, Loading::Monotonic) << target.name;
    for (const Repair& repair : target.repairs) {
      EXPECT_GT(repair.count, 0U) << target.name;
      EXPECT_FALSE(repair.text.empty()) << target.name;
      if (repair.kind == "nan-rows") {
        EXPECT_EQ(target.name, "test_ID_063");
        EXPECT_EQ(repair.count, 4U);
        ++with_nan;
      }
      if (repair.kind == "foot-reversals") ++with_reversals;
    }
  }
  EXPECT_EQ(with_nan, 1);
  EXPECT_GT(with_reversals, 10);
}

TEST(TargetReference, FourRawMachineFilesOfS355MeetThePublishedValues) {
  PLASTICA_NEEDS_SHARED("data");
  TargetSource source;
  for (const char* name : {"Zx1", "Zx2", "Zx3", "Zx4"}) {
    source.files.push_back(data(std::string("s355-bam/") + name + ".csv"));
  }
  source.strain = ColumnSource{"Extensometer elongation", std::nullopt, {}};
  source.force = ColumnSource{"Load", std::nullopt, {}};
  source.area = SpecimenValue{std::nullopt, "S0_mm2", "mm^2", {}};
  source.table = TableSource{data("s355-bam/published_values.csv"), "specimen", {}, {}};
  const std::vector<Target> targets = import_targets(source);
  const auto published = io::CsvTable::read(data("s355-bam/published_values.csv"));
  ASSERT_EQ(targets.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Target& target = targets[i];
    const Characteristics& c = target.characteristics;
    const auto value = [&](const char* name) { return published.number(i, *published.find(name)); };
    EXPECT_EQ(target.status, TargetStatus::Ready) << target.name << ": " << target.reason;
    ASSERT_TRUE(c.proof_stress && c.reh && c.rm && c.youngs_modulus) << target.name;
    EXPECT_NEAR(*c.proof_stress / 1e6, value("Rp02_MPa"), 1.0) << target.name;
    EXPECT_NEAR(*c.reh / 1e6, value("ReH_MPa"), 1.0) << target.name;
    EXPECT_NEAR(*c.rm / 1e6, value("Rm_MPa"), 0.5) << target.name;
    EXPECT_NEAR(*c.youngs_modulus / 1e9 / value("E_GPa"), 1.0, 0.05) << target.name;
    EXPECT_FALSE(c.strain_at_rm.has_value()) << target.name;
    EXPECT_FALSE(c.break_strain.has_value()) << target.name;
  }
}

TEST(TargetReference, ACyclicCouponKeepsItsSamplesAndItsZero) {
  PLASTICA_NEEDS_SHARED("data");
  TargetSource source;
  source.files = {data("s355j2-resspylab/example_1.csv")};
  source.strain = column("e_true", "1");
  source.stress = column("Sigma_true", "MPa");
  source.measure = Measure::True;
  const Target target = import_targets(source).at(0);
  EXPECT_EQ(target.loading, Loading::Cyclic);
  EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
  // Only samples that equal the one before are dropped: they add nothing to the strain path.
  std::size_t twins = 0;
  for (std::size_t i = 1; i < target.raw.size(); ++i) {
    twins += target.raw.strain[i] == target.raw.strain[i - 1] &&
                     target.raw.stress[i] == target.raw.stress[i - 1]
                 ? 1
                 : 0;
  }
  EXPECT_EQ(target.corrected.size() + twins, target.raw.size());
  EXPECT_EQ(target.corrected.strain.back(), target.raw.strain.back());
  ASSERT_TRUE(target.characteristics.youngs_modulus.has_value());
  EXPECT_NEAR(*target.characteristics.youngs_modulus, 200e9, 30e9);
}

TEST(TargetReference, NoisyBilinearCurvesAreNeitherShiftedNorCalledCoarse) {
  PLASTICA_NEEDS_SHARED("data");
  TargetSource source;
  source.files = {data("synthetic-bilinear/uq_200_samples.csv")};
  source.strain = column("strain", "1");
  source.stress = column("stress_*", "Pa");
  const TargetOptions options = plastica::testing::any_numbers();
  std::vector<Target> targets = import_targets(source, options);
  ASSERT_EQ(targets.size(), 200U);
  for (const char* name : {"bilinear_lownoise", "linear"}) {
    source.files = {data(std::string("synthetic-bilinear/") + name + ".csv")};
    source.stress = column("stress", "Pa");
    targets.push_back(import_targets(source, options).at(0));
  }
  for (const Target& target : targets) {
    EXPECT_EQ(target.status, TargetStatus::Ready) << target.name << ": " << target.reason;
    EXPECT_EQ(target.corrected.size(), target.raw.size()) << target.name;
    EXPECT_EQ(target.corrected.strain, target.raw.strain) << target.name;
  }
  EXPECT_EQ(std::ranges::count(targets.back().warnings,
                               "elastic to its end: the yield stress is not identifiable"),
            1);
}

}  // namespace
}  // namespace plastica::calibrate
