#include "calibrate/target/curve_spool.hpp"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "calibrate/target/target.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/durable_file.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::calibrate {
namespace {

/// Opens a file that has no name, for reading and writing. @return -1 and `errno` if that fails
int open_nameless(const std::string& folder) {
  const int made = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (made >= 0) return made;
  // File systems that know no such files have some with names, which can be taken away. Where there
  // is none of either, the second try says why.
  std::string name = folder + "/.plastica-curves-XXXXXX";
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

bool are_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Where the corrected curve lies in the raw one, if it is some samples of it in a row, to the last
/// bit but for a shift of the strain: most are, and then need no place of their own.
std::optional<PlaceOfCurve> part_of_raw(const Target& target) {
  const Curve &raw = target.raw, &part = target.corrected;
  if (part.strain.empty() || part.size() > raw.size()) return std::nullopt;
  double shift = 0.0;
  for (const Correction& correction : target.corrections) {
    if (correction.applied && correction.unit == "1") shift += correction.amount;
  }
  // `get` gives a shift of 0 back as it is, and else the difference.
  const auto is_at = [&](std::size_t i, std::size_t of_raw) {
    const double strain = shift == 0.0 ? raw.strain[of_raw] : raw.strain[of_raw] - shift;
    return are_same_bits(strain, part.strain[i]) &&
           are_same_bits(raw.stress[of_raw], part.stress[i]);
  };
  std::size_t first = 0;
  while (first + part.size() <= raw.size() && !is_at(0, first)) ++first;
  if (first + part.size() > raw.size()) return std::nullopt;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!is_at(i, first + i)) return std::nullopt;
  }
  return PlaceOfCurve{
      .offset = first, .samples = part.size(), .to_stress = raw.size(), .shift = shift};
}

}  // namespace

std::string spool_folder(const std::string& output) {
  const char* named = std::getenv("TMPDIR");
  return named != nullptr && *named != '\0' ? named : io::folder_of(output);
}

CurveSpool::CurveSpool(std::string folder, std::size_t bytes_in_memory)
    : folder_(std::move(folder)),
      room_(bytes_in_memory / sizeof(double)),
      // Not set to zero: what nobody writes takes no memory.
      memory_(new double[room_]) {}

CurveSpool::~CurveSpool() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

PlaceOfCurve CurveSpool::put(std::span<const double> strain, std::span<const double> stress) {
  if (strain.size() != stress.size()) {
    throw std::logic_error("CurveSpool: strain and stress must be equally long");
  }
  PlaceOfCurve place{.samples = strain.size(), .to_stress = strain.size()};
  int descriptor = -1;
  {
    const std::lock_guard lock(mutex_);
    place.offset = end_;
    if (end_ + 2 * strain.size() > room_) {
      place.offset = std::max<std::uint64_t>(end_, room_);  // none lies in both
      descriptor = file();
    }
    end_ = place.offset + 2 * strain.size();
  }
  if (descriptor < 0) {
    std::ranges::copy(strain, memory_.get() + place.offset);
    std::ranges::copy(stress, memory_.get() + place.offset + strain.size());
    return place;
  }
  std::vector<double> both(strain.begin(), strain.end());
  both.insert(both.end(), stress.begin(), stress.end());
  const auto* bytes = reinterpret_cast<const char*>(both.data());
  std::size_t left = both.size() * sizeof(double);
  auto at = static_cast<off_t>(place.offset * sizeof(double));
  while (left > 0) {
    const ssize_t written = ::pwrite(descriptor, bytes, left, at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_to_take(written < 0 ? errno : ENOSPC);
    bytes += written;
    at += written;
    left -= static_cast<std::size_t>(written);
  }
  return place;
}

void CurveSpool::get(const PlaceOfCurve& place, std::span<double> strain,
                     std::span<double> stress) const {
  const std::size_t n = place.samples;
  if (strain.size() != n || stress.size() != n) {
    throw std::logic_error("CurveSpool: the curve has another number of samples");
  }
  if (place.offset < room_) {
    std::copy_n(memory_.get() + place.offset, n, strain.begin());
    std::copy_n(memory_.get() + place.offset + place.to_stress, n, stress.begin());
  } else if (!read_together(place, strain, stress)) {
    read(place.offset, strain);
    read(place.offset + place.to_stress, stress);
  }
  if (place.shift == 0.0) return;
  for (double& one : strain) one -= place.shift;
}

bool CurveSpool::read_together(const PlaceOfCurve& place, std::span<double> strain,
                               std::span<double> stress) const {
  constexpr std::size_t kSmall = 512;  // numbers between the two that cost less than another call
  std::array<double, kSmall> between;
  const std::size_t gap = place.to_stress - strain.size();
  if (place.to_stress < strain.size() || gap > kSmall) return false;
  const std::array<iovec, 3> parts{iovec{strain.data(), strain.size_bytes()},
                                   iovec{between.data(), gap * sizeof(double)},
                                   iovec{stress.data(), stress.size_bytes()}};
  const std::size_t all = strain.size_bytes() + gap * sizeof(double) + stress.size_bytes();
  const ssize_t got = ::preadv(descriptor_, parts.data(), static_cast<int>(parts.size()),
                               static_cast<off_t>(place.offset * sizeof(double)));
  return got == static_cast<ssize_t>(all);
}

void CurveSpool::read(std::uint64_t offset, std::span<double> numbers) const {
  auto* to = reinterpret_cast<char*>(numbers.data());
  std::size_t left = numbers.size_bytes();
  auto at = static_cast<off_t>(offset * sizeof(double));
  while (left > 0) {
    const ssize_t got = ::pread(descriptor_, to, left, at);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("cannot give back the curves of the run", got < 0 ? errno : EIO);
    to += got;
    at += got;
    left -= static_cast<std::size_t>(got);
  }
}

int CurveSpool::file() {
  if (descriptor_ < 0) descriptor_ = open_nameless(folder_);
  if (descriptor_ < 0) fail_to_take(errno);
  return descriptor_;
}

void CurveSpool::fail_to_take(int error) const {
  fail("cannot take the curves of the run (the variable TMPDIR can name another folder)", error);
}

void CurveSpool::fail(const char* action, int error) const {
  throw io::StorageError(folder_, std::string(action) + ": " + std::strerror(error));
}

void put_aside(Curve& curve, const std::shared_ptr<CurveSpool>& spool) {
  if (curve.strain.empty()) return;
  const std::uint64_t digest = digest_of(curve);
  curve.aside = spool->put(curve.strain, curve.stress);
  curve.aside.digest = digest;
  curve.spool = spool;
  curve.strain = std::vector<double>();  // with their memory, which {} would keep
  curve.stress = std::vector<double>();
}

void put_aside(Target& target, const std::shared_ptr<CurveSpool>& spool) {
  const std::optional<PlaceOfCurve> part = part_of_raw(target);
  put_aside(target.raw, spool);
  if (!part) return put_aside(target.corrected, spool);
  Curve& curve = target.corrected;
  curve.aside = *part;
  curve.aside.offset += target.raw.aside.offset;
  curve.aside.digest = digest_of({std::move(curve.strain), std::move(curve.stress)});
  curve.spool = spool;
}

std::size_t bytes_of_curves(const Target& target) {
  const Curve &raw = target.raw, &corrected = target.corrected;
  const bool is_part = raw.is_aside() && corrected.is_aside() &&
                       corrected.aside.offset >= raw.aside.offset &&
                       corrected.aside.offset < raw.aside.offset + 2 * raw.samples();
  return 2 * sizeof(double) * (raw.samples() + (is_part ? 0 : corrected.samples()));
}

std::uint64_t digest_of(const Curve& curve) {
  if (curve.is_aside() && !curve.spool)
    throw std::logic_error("digest_of: they were counted alone");
  if (curve.is_aside()) return curve.aside.digest;
  const auto bytes = [](const std::vector<double>& values) {
    return std::as_bytes(std::span(values));
  };
  return io::Digest().block(bytes(curve.strain)).block(bytes(curve.stress)).value();
}

Curve with_samples(const Curve& curve) {
  if (!curve.is_aside()) return curve;
  if (!curve.spool) throw std::logic_error("with_samples: they were counted alone");
  const std::size_t n = curve.samples();
  Curve whole{std::vector<double>(n), std::vector<double>(n)};
  curve.spool->get(curve.aside, whole.strain, whole.stress);
  return whole;
}

CorrectedTarget::CorrectedTarget(const Target& target) : target_(&target) {
  if (!target.corrected.is_aside()) return;
  auto read = std::make_unique<Target>(target);
  read->corrected = with_samples(target.corrected);
  read_ = std::move(read);
  target_ = read_.get();
}

CorrectedTarget::~CorrectedTarget() = default;

}  // namespace plastica::calibrate
