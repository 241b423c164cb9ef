#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "calibrate/target/curve.hpp"

namespace plastica::calibrate {

struct Target;

/// Keeps curves of large batches: the first of them in memory, the others in a file without a name,
/// which is gone with the process. Several threads may use it at a time.
class CurveSpool {
 public:
  static constexpr std::size_t kInMemory = std::size_t{4} << 20U;  ///< [bytes]

  /// @param folder  takes the file, which is made once memory is full
  explicit CurveSpool(std::string folder, std::size_t bytes_in_memory = kInMemory);
  ~CurveSpool();
  CurveSpool(const CurveSpool&) = delete;
  CurveSpool& operator=(const CurveSpool&) = delete;

  /// @param strain, stress  (n) @throws io::StorageError if the disk does not take them
  PlaceOfCurve put(std::span<const double> strain, std::span<const double> stress);
  /// @param strain, stress  (n), where they are to be written
  /// @throws io::StorageError if the disk does not give them back
  void get(const PlaceOfCurve& place, std::span<double> strain, std::span<double> stress) const;

 private:
  /// Both from the file by one call. @return false if they are not both there now
  bool read_together(const PlaceOfCurve& place, std::span<double> strain,
                     std::span<double> stress) const;
  /// From the file. @param offset  of the first number
  void read(std::uint64_t offset, std::span<double> numbers) const;
  int file();
  [[noreturn]] void fail_to_take(int error) const;
  [[noreturn]] void fail(const char* action, int error) const;

  std::string folder_;
  std::size_t room_;  // numbers in memory
  std::unique_ptr<double[]> memory_;
  std::mutex mutex_;       // of the two below
  std::uint64_t end_ = 0;  // numbers that are there
  int descriptor_ = -1;
};

/// Where the curves of a run stand: the folder that the environment variable TMPDIR names; without
/// one, that of the output.
std::string spool_folder(const std::string& output);

/// Moves the samples of a curve into a spool, unless they are there already; `samples` still counts
/// them. @throws io::StorageError
void put_aside(Curve& curve, const std::shared_ptr<CurveSpool>& spool);
/// The same with both curves of a target; what of the corrected one is the raw one's lies there
/// once.
void put_aside(Target& target, const std::shared_ptr<CurveSpool>& spool);

/// What the curves of a target take, here or aside [bytes].
std::size_t bytes_of_curves(const Target& target);

/// Digest of the bits of a curve's samples, wherever these are: it is kept with those that are put
/// aside.
/// @throws std::logic_error if they were counted, but not read (`FitSamples`)
std::uint64_t digest_of(const Curve& curve);

/// A curve with its samples, wherever these are.
/// @throws io::StorageError; std::logic_error if they were counted, but not read (`FitSamples`)
Curve with_samples(const Curve& curve);

/// A target with the samples of its corrected curve, for as long as this lives.
class CorrectedTarget {
 public:
  /// @throws as `with_samples`
  explicit CorrectedTarget(const Target& target);
  ~CorrectedTarget();
  CorrectedTarget(const CorrectedTarget&) = delete;
  CorrectedTarget& operator=(const CorrectedTarget&) = delete;

  const Target& operator*() const { return *target_; }
  const Target* operator->() const { return target_; }

 private:
  std::unique_ptr<const Target> read_;  // null: the samples were there
  const Target* target_;
};

}  // namespace plastica::calibrate
