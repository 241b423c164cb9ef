#include "sweeps/report/markup.hpp"

#include <fmt/format.h>

#include <string_view>

#include "plastica/report/format.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

std::string markdown_text(std::string_view text) {
  std::string out;
  for (const char c : report::printable(text)) {
    if (std::string_view("\\`*_|<>[]#~").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string latex_text(std::string_view text) {
  std::string out;
  for (const char c : report::printable(text)) {
    switch (c) {
      case '\\': out += "\\textbackslash{}"; break;
      case '^': out += "\\textasciicircum{}"; break;
      case '~': out += "\\textasciitilde{}"; break;
      // Two signs in a row would become another one.
      case '<': out += "\\textless{}"; break;
      case '>': out += "\\textgreater{}"; break;
      case '"': out += "''"; break;
      case '-': out += out.ends_with('-') ? "{}-" : "-"; break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        out += '\\';
        out += c;
        break;
      default: out += c;
    }
  }
  return out;
}

/// A number with a sign that is as long as a plus; a dash where there is none.
std::string latex_number(const std::string& cell) {
  if (cell == "-") return "--";
  if (cell.starts_with('-')) return "$-$" + latex_text(cell.substr(1));
  return latex_text(cell);
}

/// Whether any case has a remark.
bool any_remark(const CaseRows& all) {
  for (const CaseBlock& block : all.blocks) {
    for (const auto& row : block.rows) {
      if (!row.back().empty()) return true;
    }
  }
  return false;
}

/// The rows without the column of remarks where all of it is empty.
CaseRows rows_for_page(const SweepRecord& record) {
  CaseRows all = case_rows(record, 0);
  if (any_remark(all)) return all;
  all.columns.pop_back();
  for (CaseBlock& block : all.blocks) {
    for (auto& row : block.rows) row.pop_back();
  }
  return all;
}

std::string markdown_head(const std::vector<CaseColumn>& columns) {
  std::string names = "|";
  std::string rules = "|";
  for (const CaseColumn& column : columns) {
    const std::string name =
        column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    names += " " + markdown_text(name) + " |";
    rules += column.words ? " :-- |" : " --: |";
  }
  return names + "\n" + rules + "\n";
}

std::string latex_head(const std::vector<CaseColumn>& columns) {
  std::string kinds;
  std::string names;
  std::string units;
  bool any_unit = false;
  for (const CaseColumn& column : columns) {
    kinds += column.words ? 'l' : 'r';
    names += (names.empty() ? "" : " & ") + latex_text(column.name);
    units += (&column == columns.data() ? "" : " & ") + latex_text(column.unit);
    any_unit = any_unit || !column.unit.empty();
  }
  std::string text = "\\begin{tabular}{" + kinds + "}\n\\hline\n" + names + " \\\\\n";
  if (any_unit) text += units + " \\\\\n";
  return text + "\\hline\n";
}

}  // namespace

std::string markdown_table(const SweepRecord& record) {
  const CaseRows all = rows_for_page(record);
  std::string text;
  for (const std::string& line : head_lines(record)) {
    text += (text.empty() ? "" : "  \n") + markdown_text(line);
  }
  text += "\n";
  for (const CaseBlock& block : all.blocks) {
    text += "\n";
    if (!block.label.empty()) text += "**" + markdown_text(block.label) + "**\n\n";
    text += markdown_head(all.columns);
    for (const auto& row : block.rows) {
      text += "|";
      for (const std::string& cell : row) text += " " + markdown_text(cell) + " |";
      text += "\n";
    }
    if (!block.notes.empty()) text += "\n";
    for (std::size_t i = 0; i < block.notes.size(); ++i) {
      text += (i == 0 ? "" : "  \n") + markdown_text(block.notes[i]);
    }
    if (!block.notes.empty()) text += "\n";
  }
  return text;
}

std::string latex_table(const SweepRecord& record) {
  const CaseRows all = rows_for_page(record);
  std::string text;
  for (const std::string& line : head_lines(record)) text += "% " + line + "\n";
  text += latex_head(all.columns);
  const auto across = [&](const std::string& line) {
    return fmt::format("\\multicolumn{{{}}}{{l}}{{{}}} \\\\\n", all.columns.size(),
                       latex_text(line));
  };
  for (const CaseBlock& block : all.blocks) {
    if (!block.label.empty()) text += across(block.label);
    for (const auto& row : block.rows) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (c > 0) text += " & ";
        text += all.columns[c].words ? latex_text(row[c]) : latex_number(row[c]);
      }
      text += " \\\\\n";
    }
    for (const std::string& note : block.notes) text += across(note);
    text += "\\hline\n";
  }
  return text + "\\end{tabular}\n";
}

}  // namespace plastica::sweeps
