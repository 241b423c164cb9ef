#include "plastica/io/unit_words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace plastica::io {

bool has_factor(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '@' || (c == '%' && i > 0)) return true;
    if (!is_digit(c)) continue;
    if (i == 0) {
      // That of "1/s".
      if (text.substr(0, 2) == "1/") continue;
      return true;
    }
    std::size_t before = i - 1;
    const bool is_signed = (text[before] == '-' || text[before] == '+') && before > 0;
    if (is_signed) --before;
    const char last = text[before];
    const bool is_power = is_letter(last) || is_digit(last) || last == '^' ||
                          (last == '*' && before > 0 && text[before - 1] == '*');
    if (!is_power) return true;
  }
  return false;
}

namespace {

bool is_angular(Dimension dimension) {
  return dimension == Dimension::Curvature || dimension == Dimension::RotationalStiffness ||
         dimension == Dimension::AngularVelocity;
}

}  // namespace

bool has_wrong_word(std::string_view text, Dimension dimension) {
  constexpr std::array<std::string_view, 6> kNumbers{"pi", "ppm", "ppb", "ppv", "dozen", "percent"};
  constexpr std::array<std::string_view, 9> kAngles{"deg",     "degree", "degrees", "rad", "radian",
                                                    "radians", "arcmin", "arcsec",  "turn"};
  constexpr std::array<std::string_view, 3> kFrequencies{"hz", "hertz", "bq"};
  const auto is_among = [](std::string_view word, std::span<const std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t length = 0;
    while (i + length < text.size() && is_letter(text[i + length])) ++length;
    const std::string_view word = text.substr(i, length);
    std::string low(word);
    for (char& c : low) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (is_among(word, kNumbers) || (is_among(word, kAngles) && !is_angular(dimension)))
      return true;
    const bool frequency =
        std::ranges::any_of(kFrequencies, [&](std::string_view f) { return low.ends_with(f); });
    if (frequency && dimension == Dimension::AngularVelocity) return true;
    i += std::max<std::size_t>(length, 1);
  }
  constexpr std::string_view kDegree = "°";
  return !is_angular(dimension) && dimension != Dimension::Temperature &&
         text.find(kDegree) != std::string_view::npos;
}

}  // namespace plastica::io
