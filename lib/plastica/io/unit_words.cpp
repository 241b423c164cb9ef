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

bool is_torn(std::string_view text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++open;
    if (text[i] == ')' && --open < 0) return true;
    if (text[i] == '+' && (i == 0 || (text[i - 1] != '^' && text[i - 1] != '*'))) return true;
  }
  return open != 0;
}

namespace {

using Words = std::span<const std::string_view>;
constexpr std::array<std::string_view, 4> kTimes{"x", "×", "*", "·"};

/// Takes one of the words off the begin of a text, if it is there.
std::string_view taken(std::string_view& text, Words words) {
  for (const std::string_view word : words) {
    if (!text.starts_with(word)) continue;
    text.remove_prefix(word.size());
    return word;
  }
  return {};
}

std::string_view taken_digits(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && is_digit(text[length])) ++length;
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

void skip_blanks(std::string_view& text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
}

/// An exponent: "^3", "**-3", "e-3", "⁻³".
bool take_exponent(std::string_view& text) {
  constexpr std::array<std::string_view, 4> kPower{"^", "**", "e", "E"};
  constexpr std::array<std::string_view, 3> kSigns{"-", "+", "−"};
  constexpr std::array<std::string_view, 11> kRaised{"⁻", "⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string_view rest = text;
  const std::string_view power = taken(rest, kPower);
  if (!power.empty()) {
    const bool is_signed = !taken(rest, kSigns).empty();
    // "1E1" is a name.
    const bool is_letter_alone = (power == "e" || power == "E") && !is_signed;
    if (is_letter_alone || taken_digits(rest).empty()) return false;
    text = rest;
    return true;
  }
  bool any = false;
  while (!taken(text, kRaised).empty()) any = true;
  return any;
}

/// Whether digits before and behind a decimal mark are a power of ten, but for 1.
bool is_power_of_ten(std::string_view whole, std::string_view fraction) {
  const auto is_one_and_zeros = [](std::string_view digits) {
    return digits.starts_with('1') && digits.find_first_not_of('0', 1) == std::string_view::npos;
  };
  if (fraction.find_first_not_of('0') == std::string_view::npos) {
    return whole.size() > 1 && is_one_and_zeros(whole);
  }
  const std::size_t first = fraction.find_first_not_of('0');
  return whole.find_first_not_of('0') == std::string_view::npos && first + 1 == fraction.size() &&
         fraction[first] == '1';
}

}  // namespace

std::optional<Factor> factor_at(std::string_view text) {
  Factor factor;
  factor.multiplies = !taken(text, kTimes).empty();
  skip_blanks(text);
  const std::string_view whole = taken_digits(text);
  if (whole.empty()) return std::nullopt;
  std::string_view fraction;
  if (text.size() > 1 && (text[0] == '.' || text[0] == ',') && is_digit(text[1])) {
    text.remove_prefix(1);
    fraction = taken_digits(text);
  }
  factor.is_power = take_exponent(text);
  const bool is_ten = whole == "10" && fraction.empty();
  const bool is_one = whole == "1" && fraction.empty();
  if (factor.is_power ? !(is_ten || is_one) : !is_power_of_ten(whole, fraction))
    return std::nullopt;
  skip_blanks(text);
  std::string_view rest = text;
  const std::string_view sign = taken(rest, kTimes);
  skip_blanks(rest);
  // "10 x 2 mm" is a size, and "10xyz" a name.
  const bool ends = rest.empty() || !is_digit(rest[0]);
  const bool is_apart = sign != "x" || text.size() == 1 || !is_letter(text[1]);
  if (!sign.empty() && ends && is_apart) {
    factor.multiplies = factor.of_what_follows = true;
    text = rest;
  }
  factor.behind = text;
  return factor;
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
