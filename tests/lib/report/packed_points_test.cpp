#include "plastica/report/web/packed_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace plastica::report {
namespace {

using Rows = std::vector<std::vector<double>>;

/// The numbers of a column by RFC 4648 and the description of `packed_points`; NaN in gaps.
std::vector<double> column_of(const Json& packed, std::size_t c) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : packed["columns"][c].get<std::string>()) {
    if (digit == '=') break;
    bits = (bits << 6U) | static_cast<std::uint32_t>(kDigits.find(digit));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>((bits >> static_cast<unsigned>(count)) & 255U);
  }
  const double low = packed["low"][c].get<double>();
  const double high = packed["high"][c].get<double>();
  std::vector<double> values;
  for (std::size_t i = 0; 2 * i + 1 < bytes.size(); ++i) {
    const unsigned step = static_cast<unsigned char>(bytes[2 * i]) +
                          256U * static_cast<unsigned char>(bytes[2 * i + 1]);
    const double fraction = step / 65534.0;
    const double value = low * (1.0 - fraction) + high * fraction;
    const bool logarithmic =
        packed.contains("logarithmic") && packed["logarithmic"][c == 0 ? 0 : 1].get<bool>();
    values.push_back(step == 65535U ? std::numeric_limits<double>::quiet_NaN()
                     : logarithmic  ? std::pow(10.0, value)
                                    : value);
  }
  return values;
}

TEST(PackedPoints, AreWithinAStepOfWhatTheyWere) {
  Rows rows;
  for (int i = 0; i <= 100; ++i) rows.push_back({0.01 * i, std::sin(0.3 * i)});
  for (int i = 100; i >= 0; --i) rows.push_back({0.01 * i, -3.0 + 0.02 * i});  // and back
  const Json packed = packed_points(rows);
  ASSERT_EQ(packed["n"], rows.size());
  for (std::size_t c = 0; c < 2; ++c) {
    const auto values = column_of(packed, c);
    ASSERT_EQ(values.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(values[i], rows[i][c], (c == 0 ? 1.0 : 4.0) / 65534.0);
    }
  }
}

TEST(PackedPoints, OnALogarithmicAxisAreOffByTheSameFractionEverywhere) {
  const Rows rows{{1.0, 1e-12}, {10.0, 1.0}, {1e5, 2e-7}, {3e5, 5.0}};
  const Json packed = packed_points(rows, {true, true});
  for (std::size_t c = 0; c < 2; ++c) {
    const auto values = column_of(packed, c);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(values[i] / rows[i][c], 1.0, 5e-4);
    }
  }
}

TEST(PackedPoints, KeepGaps) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto values = column_of(
      packed_points({{0.0, 1.0}, {1.0, kNaN}, {2.0, 3.0}, {3.0, kInfinity}, {4.0, 2.0}}), 1);
  ASSERT_EQ(values.size(), 5U);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[3]));
  EXPECT_NEAR(values[2], 3.0, 1e-12);
  const auto logarithms =
      column_of(packed_points({{0.0, 1.0}, {1.0, 0.0}, {2.0, 100.0}}, {false, true}), 1);
  EXPECT_TRUE(std::isnan(logarithms[1]));
}

// Ten thousand points along a line of two pixels' worth of height.
TEST(PackedPoints, LeaveOutWhatAScreenDoesNotShow) {
  Rows rows;
  for (int i = 0; i < 10'000; ++i) rows.push_back({1e-4 * i, 0.0});
  rows.push_back({0.5, 7.0});
  const Json packed = packed_points(rows);
  EXPECT_LE(packed["n"].get<int>(), 1502);
  EXPECT_NEAR(column_of(packed, 1).back(), 7.0, 1e-3);  // the last one stays
  EXPECT_EQ(packed_points(rows, {}, 0)["n"], rows.size());
}

// Every point of a noisy loop is within half a spot of the line through those that stay.
TEST(PackedPoints, OfALineStayWhereItBends) {
  Rows rows;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.005 * i;
    rows.push_back({std::sin(t), std::sin(2.0 * t) + 1e-5 * (i % 3)});
  }
  const Json packed = packed_points(rows, {}, 200, Thinning::Line);
  EXPECT_LT(packed["n"].get<int>(), 120);
  const auto x = column_of(packed, 0);
  const auto y = column_of(packed, 1);
  for (const auto& row : rows) {
    double least = 1.0;  // over the ranges, which are 2 each
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const double u = x[k + 1] - x[k];
      const double v = y[k + 1] - y[k];
      const double along = ((row[0] - x[k]) * u + (row[1] - y[k]) * v) / (u * u + v * v);
      const double at = std::clamp(along, 0.0, 1.0);
      least = std::min(least, 0.5 * std::hypot(row[0] - x[k] - at * u, row[1] - y[k] - at * v));
    }
    // Half a spot, and what was left out before as a repeated point of a screen four times as fine.
    EXPECT_LT(least, 0.5 / 200 + std::sqrt(2.0) / 800 + 1e-4);
  }
}

TEST(PackedPoints, OfExtremeNumbersAreNone) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const auto values = column_of(packed_points({{0.0, -kMost}, {1.0, kMost}, {2.0, 0.0}}), 1);
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0], -kMost);
  EXPECT_EQ(values[1], kMost);
  EXPECT_NEAR(values[2] / kMost, 0.0, 1e-4);
  EXPECT_EQ(packed_points({})["n"], 0);
  EXPECT_EQ(packed_points({{1.0, 1.0}})["n"], 1);
  EXPECT_NEAR(column_of(packed_points({{5.0, 6.0}, {5.0, 7.0}}), 0)[1], 5.0, 1e-12);
}

}  // namespace
}  // namespace plastica::report
