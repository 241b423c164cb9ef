#include "plastica/base/median.hpp"

#include <algorithm>
#include <bit>

namespace plastica {
namespace {

/// Moves the values that belong to the front. @return where the others begin
template <typename Belongs>
double* move_to_front(double* begin, double* end, const Belongs& belongs) {
  double* others = begin;
  for (double* i = begin; i != end; ++i) {
    const double value = *i;
    *i = *others;
    *others = value;
    others += belongs(value) ? 1 : 0;
  }
  return others;
}

double middle_of(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

}  // namespace

double value_of_rank(std::span<double> values, std::size_t rank) {
  constexpr std::ptrdiff_t kFew = 12;
  double* begin = values.data();
  double* end = begin + values.size();
  double* const wanted = begin + rank;
  // Orders that defeat every pivot are left to the library, as are few values.
  int rounds = 2 * static_cast<int>(std::bit_width(values.size()));
  while (end - begin > kFew && rounds-- > 0) {
    const double pivot = middle_of(*begin, begin[(end - begin) / 2], end[-1]);
    double* const not_below = move_to_front(begin, end, [&](double v) { return v < pivot; });
    if (wanted < not_below) {
      end = not_below;
      continue;
    }
    double* const above = move_to_front(not_below, end, [&](double v) { return v <= pivot; });
    if (wanted < above) return pivot;
    begin = above;
  }
  std::nth_element(begin, wanted, end);
  return *wanted;
}

double median_of(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  const double upper = value_of_rank(values, middle);
  if (values.size() % 2 == 1) return upper;
  const double lower = value_of_rank(values, middle - 1);
  return 0.5 * lower + 0.5 * upper;  // halves: the sum of two may overflow
}

}  // namespace plastica
