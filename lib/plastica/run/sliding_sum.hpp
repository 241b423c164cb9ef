#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace plastica {

/// Sums over a window that slides along an array, with two additions a value on the whole way
/// however long the window is. Nothing is subtracted: a sum of zeros is 0, and a sum is as exact as
/// if it were added up alone.
///
/// The window is split at a place that was its end once: sums up to there are kept for all of its
/// beginnings, what came behind is added up. Once it begins behind that place, it is split at its
/// end anew.
class SlidingSum {
 public:
  using Value = std::array<double, 4>;

  /// Makes room for arrays of a length.
  void resize(std::size_t length) { front_.resize(length); }

  /// Goes back to the begin of an array, which must outlive the calls of `over`.
  void begin(const std::vector<Value>& values) {
    values_ = &values;
    split_ = end_ = 0;
    back_ = {};
  }

  /// The sum over values first … end - 1; neither number falls from call to call.
  Value over(std::size_t first, std::size_t end) {
    for (; end_ < end; ++end_) add((*values_)[end_], back_);
    if (first >= split_) split(first);
    Value sum = back_;
    if (first < split_) add(front_[first], sum);
    return sum;
  }

 private:
  static void add(const Value& value, Value& sum) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += value[k];
  }

  void split(std::size_t first) {
    Value sum{};
    for (std::size_t i = end_; i-- > first;) {
      add((*values_)[i], sum);
      front_[i] = sum;
    }
    split_ = end_;
    back_ = {};
  }

  const std::vector<Value>* values_ = nullptr;
  std::vector<Value> front_;  ///< sums of i … split - 1
  Value back_{};              ///< of split … end - 1
  std::size_t split_ = 0, end_ = 0;
};

}  // namespace plastica
