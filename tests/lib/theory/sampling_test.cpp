#include "plastica/theory/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include "tests/support/message.hpp"

namespace plastica::theory {
namespace {

std::size_t cell(double coordinate, std::size_t cells) {
  return static_cast<std::size_t>(coordinate * static_cast<double>(cells));
}

/// Square of the L2 star discrepancy, by Warnock's formula.
double discrepancy(const std::vector<double>& points, std::size_t dimensions) {
  const std::size_t count = points.size() / dimensions;
  const auto n = static_cast<double>(count);
  double single = 0.0;
  double pairs = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double product = 1.0;
    for (std::size_t k = 0; k < dimensions; ++k) {
      const double x = points[i * dimensions + k];
      product *= 0.5 * (1.0 - x * x);
    }
    single += product;
    for (std::size_t j = 0; j < count; ++j) {
      double pair = 1.0;
      for (std::size_t k = 0; k < dimensions; ++k) {
        pair *= 1.0 - std::max(points[i * dimensions + k], points[j * dimensions + k]);
      }
      pairs += pair;
    }
  }
  return std::pow(3.0, -static_cast<double>(dimensions)) - 2.0 * single / n + pairs / (n * n);
}

/// The mean of the same over all sets of independent, even random points.
double random_discrepancy(std::size_t count, std::size_t dimensions) {
  const auto d = static_cast<double>(dimensions);
  return (std::pow(2.0, -d) - std::pow(3.0, -d)) / static_cast<double>(count);
}

TEST(LatinHypercube, PutsOnePointIntoEachStratumOfEachAxis) {
  for (const std::size_t count : {1U, 2U, 7U, 100U, 4099U}) {
    const auto points = latin_hypercube(count, 3, 5);
    ASSERT_EQ(points.size(), count * 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::set<std::size_t> strata;
      for (std::size_t i = 0; i < count; ++i) strata.insert(cell(points[i * 3 + axis], count));
      EXPECT_EQ(strata.size(), count);
      EXPECT_EQ(*strata.rbegin(), count - 1);
    }
  }
  EXPECT_TRUE(latin_hypercube(0, 3, 5).empty());
}

TEST(LatinHypercube, GivesTheSameBitsForASeedAndOthersForAnother) {
  const auto points = latin_hypercube(50, 2, 11);
  EXPECT_EQ(points, latin_hypercube(50, 2, 11));
  EXPECT_NE(points, latin_hypercube(50, 2, 12));
}

TEST(Sampling, GivesTheBitsOfEarlierVersions) {
  // The sums of stratum and place, which are exact before the division by the count.
  const std::vector<double> sums{0x1.b4ce6p-2, 0x1.76e368p+0, 0x1.ce6398p+0,
                                 0x1.1c3cdp-1, 0x1.2df424p+1, 0x1.38b68cp+1};
  const auto hypercube = latin_hypercube(3, 2, 1);
  for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(hypercube[i], sums[i] / 3.0);
  EXPECT_EQ(sobol(3, 2, 1),
            (std::vector<double>{0x1.c87954c8p-1, 0x1.55069c4ap-1, 0x1.7d0dfa48p-3, 0x1.7006468p-5,
                                 0x1.85bfbb54p-2, 0x1.b927856ap-1}));
}

TEST(LatinHypercube, KeepsAnAxisWhenOthersAreAdded) {
  const auto two = latin_hypercube(20, 2, 3);
  const auto five = latin_hypercube(20, 5, 3);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(two[i * 2], five[i * 5]);
    EXPECT_EQ(two[i * 2 + 1], five[i * 5 + 1]);
  }
}

TEST(LatinHypercube, OrdersItsAxesIndependently) {
  // The correlation of two random orders of n has the standard deviation 1/sqrt(n - 1).
  constexpr std::size_t kCount = 2000;
  const auto points = latin_hypercube(kCount, 4, 1);
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < kCount; ++i) {
        sum += (points[i * 4 + a] - 0.5) * (points[i * 4 + b] - 0.5);
      }
      EXPECT_LT(std::abs(12.0 * sum / kCount), 4.0 / std::sqrt(kCount - 1.0)) << a << " " << b;
    }
  }
}

TEST(LatinHypercube, FillsTheCubeMoreEvenlyThanRandomPoints) {
  EXPECT_LT(discrepancy(latin_hypercube(256, 2, 1), 2), 0.5 * random_discrepancy(256, 2));
}

TEST(Sobol, BeginsWithThePublishedPoints) {
  // Joe & Kuo's own listing of the first ten points in three dimensions.
  const std::vector<double> published{0,      0,      0,      0.5,    0.5,    0.5,   0.75,  0.25,
                                      0.25,   0.25,   0.75,   0.75,   0.375,  0.375, 0.625, 0.875,
                                      0.875,  0.125,  0.625,  0.125,  0.875,  0.125, 0.625, 0.375,
                                      0.1875, 0.3125, 0.9375, 0.6875, 0.8125, 0.4375};
  EXPECT_EQ(sobol(10, 3, 0), published);
}

TEST(Sobol, PutsOnePointIntoEachElementaryInterval) {
  // The first two dimensions are a (0, 2)-sequence: of 2^m points from a multiple of 2^m on, one
  // lies in each box of 2^k by 2^(m-k) equal ones.
  for (const std::uint64_t seed : {0U, 1U, 77U}) {
    const auto points = sobol(1024, 2, seed);
    for (unsigned m = 1; m <= 9; ++m) {
      const std::size_t count = std::size_t{1} << m;
      for (unsigned k = 0; k <= m; ++k) {
        for (const std::size_t first : {std::size_t{0}, count}) {
          std::set<std::size_t> boxes;
          for (std::size_t i = first; i < first + count; ++i) {
            boxes.insert(cell(points[2 * i], std::size_t{1} << k) * count +
                         cell(points[2 * i + 1], std::size_t{1} << (m - k)));
          }
          EXPECT_EQ(boxes.size(), count) << "m " << m << ", k " << k << ", seed " << seed;
        }
      }
    }
  }
}

TEST(Sobol, PutsOnePointIntoEachStratumOfEachAxis) {
  constexpr std::size_t kCount = 512;
  for (const std::uint64_t seed : {0U, 9U}) {
    const auto points = sobol(kCount, kSobolDimensions, seed);
    for (std::size_t axis = 0; axis < kSobolDimensions; ++axis) {
      std::set<std::size_t> strata;
      for (std::size_t i = 0; i < kCount; ++i) {
        strata.insert(cell(points[i * kSobolDimensions + axis], kCount));
      }
      EXPECT_EQ(strata.size(), kCount) << axis;
    }
  }
}

TEST(Sobol, PutsOnePointIntoEachOrthantOfTheCube) {
  // Sobol's property A, which Joe and Kuo's numbers have: of 2^d points in d dimensions one lies in
  // each of the 2^d halves of halves.
  constexpr std::size_t kMost = 14;
  for (std::size_t d = 1; d <= kMost; ++d) {
    const std::size_t count = std::size_t{1} << d;
    const auto points = sobol(count, d, 4);
    std::vector<bool> taken(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t orthant = 0;
      for (std::size_t axis = 0; axis < d; ++axis) {
        orthant = 2 * orthant + cell(points[i * d + axis], 2);
      }
      taken[orthant] = true;
    }
    EXPECT_EQ(std::count(taken.begin(), taken.end(), true), count) << d;
  }
}

TEST(Sobol, FillsTheCubeFarMoreEvenlyThanRandomPoints) {
  for (const std::size_t d : {2U, 5U}) {
    for (const std::uint64_t seed : {0U, 1U, 2U}) {
      EXPECT_LT(discrepancy(sobol(1024, d, seed), d), 0.1 * random_discrepancy(1024, d))
          << d << " dimensions, seed " << seed;
    }
  }
}

TEST(Sobol, ASeedMovesThePointsWithinTheCube) {
  const auto plain = sobol(64, 4, 0);
  const auto first = sobol(64, 4, 1);
  EXPECT_NE(plain, first);
  EXPECT_NE(first, sobol(64, 4, 2));
  EXPECT_EQ(first, sobol(64, 4, 1));
  EXPECT_GE(*std::min_element(first.begin(), first.end()), 0.0);
  EXPECT_LT(*std::max_element(first.begin(), first.end()), 1.0);
}

TEST(Sobol, RefusesMoreDimensionsThanItHasNumbersFor) {
  EXPECT_EQ(testing::message_of([] { sobol(1, 32, 0); }),
            "dimensions = 32: must be at most 31 for Sobol points");
}

}  // namespace
}  // namespace plastica::theory
