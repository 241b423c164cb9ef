#include "plastica/report/format.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "plastica/base/utf8.hpp"

namespace plastica::report {
namespace {

/// Decimal exponent of a number: 2 for 281.
int exponent_of(double value) {
  return value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::fabs(value))));
}

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Position behind the first `count` code points.
std::size_t behind(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  while (at < text.size() && count > 0) {
    ++at;
    while (at < text.size() && continues(text[at])) ++at;
    --count;
  }
  return at;
}

}  // namespace

DisplayUnit display_unit(Dimension dimension, double magnitude, bool modulus) {
  const double size = std::fabs(magnitude);
  switch (dimension) {
    case Dimension::None: return {"", 1.0};
    case Dimension::Strain: return {"%", 0.01};
    case Dimension::Stress:
      if (size >= (modulus ? 1e9 : 1e10)) return {"GPa", 1e9};
      if (size >= 1e4 || size == 0.0) return {"MPa", 1e6};
      if (size >= 1e2) return {"kPa", 1e3};
      return {"Pa", 1.0};
    default: return {si_unit(dimension), 1.0};
  }
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const int exponent = exponent_of(value);
  if (exponent < -4 || exponent > 7) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::string brief(double value) { return fmt::format("{:.5g}", value); }

int decimals_for(double value, double error, int digits) {
  const int wanted = std::max(0, digits - 1 - exponent_of(error));
  return std::min(wanted, std::max(0, 6 - exponent_of(value)));
}

std::string with_error(double value, double error) {
  if (!(error > 0.0) || !std::isfinite(error)) return significant(value) + " ± " + brief(error);
  const int exponent = exponent_of(value);
  if (exponent < -4 || exponent > 7) return fmt::format("{:.4e} ± {:.1e}", value, error);
  const int decimals = decimals_for(value, error);
  // An error that these decimals would round off.
  if (error < std::pow(10.0, -decimals)) {
    return fmt::format("{:.{}f} ± {:.1e}", value, decimals, error);
  }
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
}

std::string quantity(std::string_view number, std::string_view unit) {
  return unit.empty() ? std::string(number) : fmt::format("{} {}", number, unit);
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string csv_cell(std::string_view name) {
  std::string text(name);
  // A spreadsheet takes these for the beginning of a formula.
  constexpr std::string_view kFormula = "=+-@\t\r";
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = read.ptr == text.data() + text.size();
  if (text.size() > 1 && kFormula.find(text.front()) != std::string_view::npos && !number) {
    text.insert(0, 1, '\'');
  }
  if (text.find_first_of(",;\t\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c;
  }
  return cell + '"';
}

std::string printable(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto next = length == 2 ? static_cast<unsigned char>(text[at + 1]) : 0U;
    if (length == 0) {
      line += '?';
    } else if (byte < 0x20U || byte == 0x7FU || (byte == 0xC2U && next < 0xA0U)) {
      line += ' ';  // C0 and C1 controls: a terminal would obey them, XML forbids them
    } else if (text.substr(at, 3) == "\xEF\xBF\xBE" || text.substr(at, 3) == "\xEF\xBF\xBF") {
      line += '?';  // U+FFFE and U+FFFF are no characters of XML
    } else {
      line += text.substr(at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  return line;
}

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

double round_step(double range, int most) {
  const double least = range / std::max(most, 2);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-12)) return factor * power;
  }
  return 10.0 * power;
}

std::string wrapped(std::string_view first, std::string_view text, std::size_t width) {
  const std::size_t indent = width_of(first);
  const std::size_t room = width > indent + 20 ? width - indent : 20;
  std::string all(first);
  std::size_t used = 0;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    std::string_view word = text.substr(0, blank);
    text.remove_prefix(std::min(blank + 1, text.size()));
    while (!word.empty()) {
      if (used > 0 && used + 1 + width_of(word) > room) {
        all += '\n' + std::string(indent, ' ');
        used = 0;
      }
      if (used > 0) {
        all += ' ';
        ++used;
      }
      const std::size_t end = behind(word, room - used);
      all += word.substr(0, end);
      used += width_of(word.substr(0, end));
      word.remove_prefix(end);
    }
  }
  return all + '\n';
}

std::string cut(std::string_view text, std::size_t width) {
  if (width_of(text) <= width) return std::string(text);
  return std::string(text.substr(0, behind(text, width == 0 ? 0 : width - 1))) + "…";
}

}  // namespace plastica::report
