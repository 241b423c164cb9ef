#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/scene.hpp"

/// A batch gives each case the same bits whatever its order, threads and company, on each
/// instruction set.
namespace plastica {
namespace {

/// Coupons, paths at rest and motions of all schemes, each with numbers of its own.
BatchCase mixed_case(std::size_t i, InstructionSet isa) {
  const double x = static_cast<double>(i);
  BatchCase one;
  one.id = std::to_string(i);
  if (i % 10 == 0) {
    one.scene = testing::coupon_scene(static_cast<Deformation>(i / 10 % 3), {0.001, 0.02, -0.01});
    one.scene.material.yield_stress = 200e6 + 1e5 * x;
    return one;
  }
  const bool yields = i % 4 == 1;
  one.scene = testing::struck_scene(3 + static_cast<int>(i % 4), 5.0 + 0.01 * x,
                                    yields ? YieldModel::PerAxis : YieldModel::Elastic);
  testing::add_probe(one.scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  testing::add_probe(one.scene, ProbeQuantity::Moment, Place::start(), Component::X);
  if (i % 10 == 1 || i % 10 == 4) {
    one.scene.initial_motions.clear();
    one.options.steps = 2;
    one.options.duration = 1.0;
    one.options.isa = isa;
    // Followed in lanes; those of 4 in space, and some of the others through a limit load.
    Load push;
    push.force = {i % 10 == 4 ? 20.0 : 0.0, -270.0 - 0.1 * x, 0.0};
    one.scene.loads.push_back(push);
    return one;
  }
  if (i % 50 == 7) one.scene.initial_motions[0].velocity[1] = -800.0;  // shorter steps
  const Scheme scheme = i % 10 == 2   ? Scheme::EnergyMomentum
                        : i % 10 == 3 ? Scheme::ArticulatedEuler
                                      : Scheme::ArticulatedMidpoint;
  one.options = testing::motion_options(scheme, 1e-4, 3);
  one.options.duration = 1e-3;
  one.options.isa = isa;
  return one;
}

/// FNV-1a over the bits of all probes, and the status, in the order of the ids.
std::uint64_t hash_of(const std::vector<BatchRow>& rows) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      hash = (hash ^ (bits >> (8 * byte) & 0xffU)) * 0x100000001b3U;
    }
  };
  for (const BatchRow& row : rows) {
    add(static_cast<std::uint64_t>(row.response.status));
    for (const std::vector<double>& probe : row.response.probes) {
      for (const double value : probe) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof(bits));
        add(bits);
      }
    }
  }
  return hash;
}

TEST(SameBits, AreThoseOfALevelInTwentyOrdersAndOnOneToEightThreads) {
  constexpr std::size_t kCases = 1000;
  std::mt19937 random(20);
  for (const InstructionSet level :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (!has_instruction_set(level)) continue;
    std::vector<BatchCase> cases;
    for (std::size_t i = 0; i < kCases; ++i) cases.push_back(mixed_case(i, level));
    std::vector<BatchRow> alone;
    for (const BatchCase& one : cases) alone.push_back(run_case(one));
    std::set<std::uint64_t> hashes{hash_of(alone)};
    std::vector<std::size_t> order(kCases);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int k = 0; k < 20; ++k) {
      std::shuffle(order.begin(), order.end(), random);
      std::vector<BatchRow> rows(kCases);
      BatchOptions options;
      options.threads = 1 + k % 8;
      run_batch(
          kCases, [&](std::size_t i) { return cases[order[i]]; },
          [&](std::size_t i, BatchRow&& row) { rows[order[i]] = std::move(row); }, options);
      hashes.insert(hash_of(rows));
    }
    EXPECT_EQ(hashes.size(), 1U) << name_of(level);
    EXPECT_GT(std::count_if(alone.begin(), alone.end(),
                            [](const BatchRow& row) { return row.response.counters.cutbacks > 0; }),
              5);
    int yielding_paths = 0;
    for (std::size_t i = 1; i < kCases; i += 10) {
      yielding_paths += alone[i].response.permanent_strain > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(yielding_paths, 5);
    EXPECT_EQ(std::count_if(alone.begin(), alone.end(),
                            [](const BatchRow& row) { return usable(row.response.status); }),
              static_cast<std::ptrdiff_t>(kCases));
  }
}

}  // namespace
}  // namespace plastica
