#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plastica::io {

/// Number of letters to insert, delete, replace or swap with their neighbour to make one word out
/// of the other; case does not count.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word that a mistyped one most likely stands for: at least two thirds of its letters right.
std::optional<std::string> nearest_word(std::string_view typed, std::span<const std::string> words);

}  // namespace plastica::io
