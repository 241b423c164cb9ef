#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

/// The memory of scenarios that are stepped side by side.
namespace plastica {

/// Numbers on a boundary of 64 bytes, as the kernels want them.
template <class Real>
class AlignedNumbers {
 public:
  AlignedNumbers() = default;
  explicit AlignedNumbers(std::size_t size) : size_(size) {
    constexpr std::size_t kLine = 64;
    const std::size_t bytes = (size * sizeof(Real) + kLine - 1) / kLine * kLine;
    at_.reset(static_cast<Real*>(std::aligned_alloc(kLine, std::max(bytes, kLine))));
    if (!at_) throw std::bad_alloc();
    std::fill_n(at_.get(), size, Real(0));
  }

  Real* data() { return at_.get(); }
  const Real* data() const { return at_.get(); }
  std::size_t size() const { return size_; }
  Real& operator[](std::size_t i) { return at_.get()[i]; }
  const Real& operator[](std::size_t i) const { return at_.get()[i]; }

  /// Takes the numbers of another one of the same size.
  void copy(const AlignedNumbers& from) { std::memcpy(data(), from.data(), size_ * sizeof(Real)); }

 private:
  struct Free {
    void operator()(Real* at) const { std::free(at); }
  };
  std::unique_ptr<Real, Free> at_;
  std::size_t size_ = 0;
};

/// Entries of `fields` numbers for each of `width` lanes, of which equal ones are kept once.
template <class Real>
class SharedEntries {
 public:
  /// @param entries  numbers of each entry, field by field and lane by lane (entries x
  ///                 fields x width)
  void set(const std::vector<double>& entries, std::size_t size) {
    const std::size_t count = entries.size() / size;
    index_.clear();
    first_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      index_.push_back(static_cast<std::uint32_t>(find(entries, size, i)));
    }
    numbers_ = AlignedNumbers<Real>(first_.size() * size);
    for (std::size_t k = 0; k < first_.size(); ++k) {
      for (std::size_t j = 0; j < size; ++j) {
        numbers_[k * size + j] = static_cast<Real>(entries[first_[k] * size + j]);
      }
    }
  }

  const std::uint32_t* index() const { return index_.data(); }
  const AlignedNumbers<Real>& numbers() const { return numbers_; }
  AlignedNumbers<Real>& numbers() { return numbers_; }
  /// The entries that the kept ones come from.
  const std::vector<std::size_t>& first() const { return first_; }

 private:
  /// Neighbours are alike: what many kinds ago was the same may be kept twice.
  static constexpr std::size_t kLookBack = 8;

  std::size_t find(const std::vector<double>& entries, std::size_t size, std::size_t i) {
    const std::size_t kinds = first_.size();
    for (std::size_t back = 1; back <= std::min(kinds, kLookBack); ++back) {
      const double* same = entries.data() + first_[kinds - back] * size;
      // To the bit: -0 in place of 0 would show in some other case's company.
      if (std::memcmp(same, entries.data() + i * size, size * sizeof(double)) == 0) {
        return kinds - back;
      }
    }
    first_.push_back(i);
    return kinds;
  }

  std::vector<std::uint32_t> index_;  ///< of each entry
  std::vector<std::size_t> first_;
  AlignedNumbers<Real> numbers_;
};

}  // namespace plastica
