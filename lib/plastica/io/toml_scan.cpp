#include "plastica/io/toml_scan.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

/// Tables and lists around a value, those of its key's names included. No file of ours needs ten;
/// the parsers' recursion takes some kilobytes of the stack for each.
constexpr std::size_t kMaxDepth = 64;

/// Scans a text: over strings and comments, counting names and brackets.
class Scan {
 public:
  Scan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (static_cast<unsigned char>(c) >= 0x80) {
        refuse_character();
      } else {
        ++at_;
        read(c);
      }
      if (c != ' ' && c != '\t' && c != '\r' && c != '\n') line_is_blank_ = false;
    }
  }

 private:
  void read(char c) {
    switch (c) {
      case '\n': end_line(); break;
      case '.': ++names_; break;
      case '=':
        key_ = names_;
        names_ = 1;
        check(around_ + key_);
        break;
      case ',': begin_key(); break;
      case '[':
      case '{': open(c); break;
      case ']':
      case '}': close(c); break;
      default: break;
    }
  }

  void end_line() {
    ++line_;
    line_start_ = at_;
    line_is_blank_ = true;
    in_header_ = false;
    if (outer_.empty()) begin_key();
  }

  void begin_key() {
    key_ = 0;
    names_ = 1;
  }

  void open(char c) {
    const bool of_header = c == '[' && outer_.empty() && key_ == 0;
    if (of_header && line_is_blank_) {
      in_header_ = true;
      of_list_ = 0;
      begin_key();
      check_name();
    } else if (of_header && in_header_) {
      of_list_ = 1;
      check_name();
    } else {
      outer_.push_back({around_, c});
      around_ += key_ + 1;
      begin_key();
      check(around_);
    }
  }

  void close(char c) {
    if (in_header_) {
      around_ = names_ + of_list_;
      in_header_ = false;
      check(around_);
    } else if (!outer_.empty()) {
      const Bracket bracket = outer_.back();
      if ((bracket.open == '[') != (c == ']')) {
        refuse(no_toml(at_ - 1) + "'" + c + "' cannot close '" + bracket.open + "'");
      }
      around_ = bracket.around;
      outer_.pop_back();
    }
    begin_key();
  }

  /// Skips a string with its quotes; one that is not closed ends with its line or the text.
  void skip_string(char quote) {
    if (at_ > 0 &&
        std::string_view(" \t\r\n.=,[{").find(text_[at_ - 1]) == std::string_view::npos) {
      refuse(no_toml(at_) + "a quote amid a word");
    }
    const std::string_view rest = text_.substr(at_);
    const bool of_lines = rest.size() > 2 && rest[1] == quote && rest[2] == quote;
    at_ += of_lines ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!of_lines) return;
        ++line_;
        line_start_ = at_ + 1;
      } else if (c == '\\' && quote == '"') {
        if (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      } else if (c == quote && (!of_lines || text_.substr(at_, 3) == std::string(3, quote))) {
        at_ += of_lines ? 3 : 1;
        // Two quotes more may belong to the text of several lines.
        for (int more = 0; of_lines && more < 2 && at_ < text_.size() && text_[at_] == quote;
             ++more)
          ++at_;
        return;
      }
    }
  }

  /// A header's bracket must be followed by a name, or by the second bracket.
  void check_name() const {
    if (of_list_ == 0 && text_.substr(at_, 1) == "[") return;
    const std::size_t first = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    const char c = first < text_.size() ? text_[first] : '\n';
    const bool is_bare = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '_' || c == '-';
    // What is not ASCII is refused as such.
    if (is_bare || c == '"' || c == '\'' || static_cast<unsigned char>(c) >= 0x80) return;
    refuse(no_toml(first) + "a header needs a name in its brackets");
  }

  void refuse_character() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    const std::string_view character = text_.substr(at_, end - at_);
    if (is_utf8(character)) {
      refuse(no_toml(at_) + "'" + std::string(character) +
             "' outside of quotes; words and quantities stand in quotes, \"355 MPa\"");
    }
    at_ = text_.size();  // where the parser ends, too
  }

  std::string no_toml(std::size_t at) const {
    const auto line = text_.substr(line_start_, at - line_start_);
    const auto column = 1 + std::count_if(line.begin(), line.end(), [](char c) {
                          return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                        });
    return "is not TOML (column " + std::to_string(column) + "): ";
  }

  void check(std::size_t depth) const {
    if (depth <= kMaxDepth) return;
    refuse("is nested in more than " + std::to_string(kMaxDepth) + " tables and lists");
  }

  [[noreturn]] void refuse(const std::string& rule) const {
    std::string_view line = text_.substr(line_start_);
    line = line.substr(0, line.find_first_of("\r\n"));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    // What is not UTF-8 is not shown: the message must be text.
    throw InputError({file_, line_}, "", is_utf8(line) ? line : std::string_view{}, rule);
  }

  struct Bracket {
    std::size_t around = 0;  // tables and lists around it
    char open = '[';
  };

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t line_start_ = 0;
  bool line_is_blank_ = true;  // so far
  bool in_header_ = false;
  std::size_t of_list_ = 0;     // 1 in a header with double brackets
  std::size_t names_ = 1;       // of the key so far
  std::size_t key_ = 0;         // names of the key whose value follows; 0 before its '='
  std::size_t around_ = 0;      // tables and lists around the key
  std::vector<Bracket> outer_;  // the open ones
};

}  // namespace

void scan_toml(std::string_view text, const std::string& file) { Scan(text, file).run(); }

}  // namespace plastica::io
