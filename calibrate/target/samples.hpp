#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/target/target.hpp"
#include "plastica/io/csv_column.hpp"

/// Repairs that every measured curve gets, whether of a coupon or of a beam.
namespace plastica::calibrate {

/// A measured curve under repair.
struct Samples {
  std::vector<double>& abscissa;  ///< [SI] (n)
  std::vector<double>& ordinate;  ///< [SI] (n)
  std::vector<Repair>& repairs;   ///< takes what was done
  /// Of the file, (n) or more: kept in step with the samples. May be null.
  std::vector<std::size_t>* rows = nullptr;

  std::size_t size() const { return abscissa.size(); }
};

/// Why a curve without any sample is none.
inline constexpr const char* kNoSamples = "no row has both numbers";

/// Those of the corrected curve.
Samples samples_of(Target& target);

/// Warns of a unit of the file that the user's goes before.
void warn_of_unit(const io::CsvTable& table, const io::FoundColumn& column,
                  std::vector<std::string>& warnings);

/// Keeps the samples for which keep(i) holds, in order; returns how many were dropped.
template <typename Keep>
std::size_t filter(const Samples& samples, Keep keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!keep(i)) continue;
    if (kept != i) {
      samples.abscissa[kept] = samples.abscissa[i];
      samples.ordinate[kept] = samples.ordinate[i];
      if (samples.rows != nullptr) (*samples.rows)[kept] = (*samples.rows)[i];
    }
    ++kept;
  }
  const std::size_t dropped = samples.size() - kept;
  samples.abscissa.resize(kept);
  samples.ordinate.resize(kept);
  if (samples.rows != nullptr) samples.rows->resize(kept);
  return dropped;
}

/// Adds a repair, if it touched any sample: the count goes before the text.
void note_repair(std::vector<Repair>& repairs, std::string_view kind, std::size_t count,
                 std::string_view what);

/// "torn-last-row", where the table's last row was cut off.
void report_torn_row(const io::CsvTable& table, std::vector<Repair>& repairs);

/// Of strains that nobody gave a unit, which are taken as fractions: in percent they reach beyond 1
/// at once.
void warn_of_percent(const io::FoundColumn& column, std::span<const double> strains,
                     std::vector<std::string>& warnings);

/// Drops rows without a finite abscissa or ordinate: "nan-rows".
/// @param reported  how many of them another repair reports
void drop_missing(const Samples& samples, std::size_t reported = 0);

/// Drops samples equal to the one before: "duplicates".
void drop_duplicates(const Samples& samples);

/// Drops lone outliers of a curve that goes one way, "outliers": a sample that differs from both
/// neighbours, to the same side, by more than 0.2 of the largest |ordinate| (of the medians of
/// three neighbours) and 8 times the noise, while the neighbours differ by less than a quarter of
/// that. Or, on a rise, one that is off the straight line through its four nearest, over the
/// abscissa and over the rows, by more than 0.03 of the largest, 8 times the noise (about it, over
/// the rows) and four times what these are off their line.
void drop_outliers(const Samples& samples);

/// Drops spikes of a monotonic test of a coupon, "spikes", which would be its Rm or its break:
/// - up to 5 samples whose ordinate is above that of the samples before and behind as a lone
/// outlier
///   is, on level ground, or whose abscissa is so by more than 20 mean steps, 1 % of the range and
///   8 times its noise;
/// - up to 5 samples at the end that leave all before them by a fifth of the largest in one step.
void drop_spikes(const Samples& samples);

/// Makes an abscissa that must not fall beyond the tolerance rise: samples that run back further
/// than 8 standard deviations of its noise are dropped, and where it still does the others are
/// averaged. Dropping noise would keep the samples of positive noise, and the slope would be too
/// small. Repair as `average_reversals`.
void mend_reversals(const Samples& samples, double tolerance, std::string_view name);

/// Averages samples at which the abscissa runs back with those before them, until it never falls:
/// the closest rising abscissa by least squares (pool adjacent violators: Ayer et al., Ann. Math.
/// Stat. 26, 1955, 641). To drop those that fall would keep the samples whose noise is positive,
/// and shift the curve by it. "NAME-reversals".
void average_reversals(const Samples& samples, std::string_view name);

/// The same of an abscissa that goes to and fro, as one that a scene follows: between turns by more
/// than the tolerance, each part by itself. A turn is averaged with its neighbours as far as noise
/// may part them, as in a hold.
void average_small_reversals(const Samples& samples, double tolerance, std::string_view name);

/// Standard deviations that are no noise.
inline constexpr double kNoises = 8.0;

/// How many samples lie where the abscissa turns round by no more than `kNoises` standard
/// deviations of its noise; 0 where these are few (10, or 5 % of all), or what turns it round is no
/// noise, as in small cycles.
/// @param[out] noise  that standard deviation
std::size_t reversed_by_noise(const Samples& samples, double& noise);

/// Median of each value and its neighbours; the first and last value as they are.
std::vector<double> medians_of_three(std::span<const double> values);

}  // namespace plastica::calibrate
