#include "plastica/io/csv_dialect.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>

namespace plastica::io::csv_text {
namespace {

using Cells = std::vector<std::string_view>;

/// Lines that the dialect is judged by: all of a short file, an even choice of a long one.
std::vector<Line> sample_of(const std::vector<Line>& lines) {
  constexpr std::size_t kLines = 600;
  if (lines.size() <= kLines) return lines;
  std::vector<Line> sample;
  for (std::size_t i = 0; i < kLines; ++i) sample.push_back(lines[i * lines.size() / kLines]);
  return sample;
}

bool has_blank_between_digits(std::string_view cell) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    if (cell[i] == ' ' && is_digit(cell[i - 1]) && is_digit(cell[i + 1])) return true;
  }
  return false;
}

/// What speaks for a dialect: numbers in rows of its most usual width; then rows of that width.
struct Evidence {
  long numbers = 0;
  std::size_t lines = 0;
  std::size_t width = 1;
  bool is_full = true;  ///< each cell that begins as a number does is one, whatever the width
};

/// Whether a cell could be a number with one decimal mark or the other.
bool begins_as_number(std::string_view cell) {
  if (cell.size() > 1 && (cell[0] == '-' || cell[0] == '+')) cell.remove_prefix(1);
  return !cell.empty() && ((cell[0] >= '0' && cell[0] <= '9') || cell[0] == '.' || cell[0] == ',');
}

Evidence evidence_for(const std::vector<Line>& sample, char separator, NumberFormat format) {
  std::map<std::size_t, Evidence> by_width;
  bool is_full = true;
  Cells cells;
  for (const Line& line : sample) {
    if (!split(line.text, separator, cells)) continue;
    Evidence& evidence = by_width[cells.size()];
    evidence.width = cells.size();
    ++evidence.lines;
    const bool shows_point = line.text.find('.') != std::string_view::npos;
    for (const std::string_view cell : cells) {
      const bool is_number = read_number(cell, format).kind == CellKind::Number;
      if (is_number) ++evidence.numbers;
      is_full = is_full && (is_number || !begins_as_number(cell));
      // "5;1" between commas: a row of "0,5;1,5" cut at its decimal commas; "10 100" likewise.
      if (separator == ',' && cell.find(';') != std::string_view::npos) --evidence.numbers;
      if (separator == ',' && !shows_point && has_blank_between_digits(cell)) {
        evidence.numbers -= 2;
      }
    }
  }
  Evidence best;
  for (const auto& [width, evidence] : by_width) {
    const bool more = evidence.numbers > best.numbers ||
                      (evidence.numbers == best.numbers && evidence.lines > best.lines);
    if (more) best = evidence;
  }
  best.is_full = is_full;
  return best;
}

/// Whether a number of the lines has a decimal mark that can part no thousands.
bool shows_decimal(const std::vector<Line>& sample, const Dialect& dialect) {
  Cells cells;
  for (const Line& line : sample) {
    if (!split(line.text, dialect.separator, cells) || cells.size() != dialect.width) continue;
    for (const std::string_view cell : cells) {
      const bool has_mark = cell.find(dialect.format.decimal) != std::string_view::npos;
      const bool is_number = read_number(cell, dialect.format).kind == CellKind::Number;
      if (has_mark && is_number && !is_ambiguous(cell)) return true;
    }
  }
  return false;
}

/// Whether a separator cuts any line. A blank stands for tabs, too, and the end of a quote cuts
/// there.
bool cuts(const std::vector<Line>& sample, char separator) {
  const auto cuts_at_blank = [](char c) { return c == '\t' || c == '"'; };
  return std::ranges::any_of(sample, [=](const Line& line) {
    return line.text.find(separator) != std::string_view::npos ||
           (separator == ' ' && std::ranges::any_of(line.text, cuts_at_blank));
  });
}

/// A dialect that lines may have, and what speaks for it.
struct Candidate {
  Dialect dialect;
  Evidence evidence;
};

/// With one decimal mark, and with the other where that may find more numbers.
void add_candidates(const std::vector<Line>& sample, char separator, const CsvOptions& options,
                    std::vector<Candidate>& candidates) {
  for (const char decimal : {'.', ','}) {
    if (options.decimal && *options.decimal != decimal) continue;
    const NumberFormat format{decimal, options.decimal.has_value()};
    const Evidence evidence = evidence_for(sample, separator, format);
    candidates.push_back({{separator, format, evidence.width, {}}, evidence});
    if (evidence.is_full && evidence.width > 1) return;
  }
}

/// In the order of preference when the numbers are equal: "1,5;2,5" has two either way. All
/// separators that cut nothing give the same cells: the lines, which have a number each at most, so
/// that they are not looked at where others find as many.
std::vector<Candidate> candidates_for(const std::vector<Line>& sample, const CsvOptions& options) {
  std::vector<Candidate> candidates;
  std::optional<char> whole;  // the first that cuts nothing
  std::size_t before = 0;     // candidates that go before it
  for (const char separator : {'\t', ';', ',', ' '}) {
    if (options.separator && *options.separator != separator) continue;
    if (cuts(sample, separator)) {
      add_candidates(sample, separator, options, candidates);
    } else if (!whole) {
      whole = separator;
      before = candidates.size();
    }
  }
  const bool found = std::ranges::any_of(candidates, [&](const Candidate& candidate) {
    return candidate.evidence.width > 1 && candidate.evidence.numbers >= std::ssize(sample);
  });
  if (!whole || found) return candidates;
  std::vector<Candidate> of_lines;
  add_candidates(sample, *whole, options, of_lines);
  candidates.insert(candidates.begin() + static_cast<std::ptrdiff_t>(before), of_lines.begin(),
                    of_lines.end());
  return candidates;
}

}  // namespace

Dialect dialect_of(const std::vector<Line>& lines, const CsvOptions& options) {
  const std::vector<Line> sample = sample_of(lines);
  Dialect best;
  Evidence most;
  bool first = true;
  for (const auto& [dialect, evidence] : candidates_for(sample, options)) {
    const bool wider = evidence.numbers == most.numbers && evidence.width > 1 && most.width == 1;
    if (first || evidence.numbers > most.numbers || wider) {
      most = evidence;
      best = dialect;
      first = false;
    }
  }

  best.format.is_certain = options.decimal || shows_decimal(sample, best);

  std::vector<std::size_t> numbers(best.width, 0);
  std::vector<std::size_t> texts(best.width, 0);
  std::vector<CellKind> kinds;
  Cells cells;
  for (const Line& line : sample) {
    if (!split(line.text, best.separator, cells) || cells.size() != best.width) continue;
    kinds.clear();
    for (const std::string_view cell : cells) {
      kinds.push_back(read_number(cell, best.format).kind);
    }
    // Headers and unit rows, which have no number, must not outvote a file of few rows.
    if (std::count(kinds.begin(), kinds.end(), CellKind::Number) == 0) continue;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const CellKind kind = kinds[i];
      if (kind == CellKind::Number) ++numbers[i];
      if (kind == CellKind::Text) ++texts[i];
    }
  }
  for (std::size_t i = 0; i < best.width; ++i) best.numeric.push_back(numbers[i] > texts[i]);
  return best;
}

}  // namespace plastica::io::csv_text
