#pragma once

#include <cstddef>
#include <vector>

namespace plastica {

/// The numbers 0 … count-1 in parts, large ones first, for workers that each take the next part
/// when they are free: a counter is all that they share. Of what is left, each worker gets half of
/// its share, then half of its share of the rest, down to single numbers: few takings, and all end
/// at about the same time, however unlike the numbers' times are.
/// Source: "factoring" of S. F. Hummel, E. Schonberg, L. E. Flynn, "Factoring: a method for
/// scheduling parallel loops", Communications of the ACM 35 (8), 1992, 90-101.
class GuidedParts {
 public:
  struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  GuidedParts() = default;
  /// @param workers  >= 1
  GuidedParts(std::size_t count, std::size_t workers);

  std::size_t size() const { return begins_.empty() ? 0 : begins_.size() - 1; }
  /// @param k  below `size`
  Part operator[](std::size_t k) const { return {begins_[k], begins_[k + 1]}; }

 private:
  std::vector<std::size_t> begins_;  ///< and the end of the last
};

}  // namespace plastica
