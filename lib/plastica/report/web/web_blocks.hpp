#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "plastica/report/json_values.hpp"
#include "plastica/report/scene_figure.hpp"

/// What a page of HTML is made of: blocks, which the page's own script shows (assets/page.js); not
/// installed.
namespace plastica::report {

/// Text as it is, in letters of one width: a report, an input file.
Json web_text(std::string title, std::string text);

/// A list of sentences. @param tone  "warning" or "note"
Json web_notes(std::string title, const std::vector<std::string>& notes, std::string tone);

/// Names and what they are.
Json web_facts(std::string title, const std::vector<std::pair<std::string, std::string>>& facts);

/// A table that sorts by a click and can be filtered.
class WebTable {
 public:
  explicit WebTable(std::string title) : title_(std::move(title)) {}

  /// @param unit  empty: none
  void add_words(std::string name, std::string unit = {});
  /// @param about   what a pointer over the name is told
  /// @param digits  with which its numbers are shown
  void add_numbers(std::string name, std::string unit = {}, std::string about = {}, int digits = 5);
  /// @param cells  as many as there are columns: texts, numbers or null
  void add_row(Json cells) { rows_.push_back(std::move(cells)); }
  /// @param detail  of the page, which the row opens; all rows of a table have one, or none
  void add_row(Json cells, std::size_t detail) {
    add_row(std::move(cells));
    details_.push_back(detail);
  }
  /// Rows open the page's details: row i, unless it was added with another, detail i.
  void open_details() { opens_ = true; }
  bool is_empty() const { return rows_.empty(); }

  Json block() const;

 private:
  std::string title_;
  Json columns_ = Json::array();
  Json rows_ = Json::array();
  std::vector<std::size_t> details_;
  bool opens_ = false;
};

/// How the axes of a panel run: x, y.
using LogarithmicAxes = std::array<bool, 2>;

/// A curve of a panel, packed (`packed_points`).
/// @param spots   that are told apart along each axis; 0: every point is kept
/// @param labels  what a pointer over each point is told; none: its numbers alone; else `spots` is
/// 0
Json web_curve(const FigureCurve& curve, LogarithmicAxes logarithmic, int spots = 1500,
               const std::vector<std::string>& labels = {});
/// A panel; marks, names and notes are those of the figure's panel, curves are as given.
Json web_panel(const FigurePanel& panel, LogarithmicAxes logarithmic, Json curves);
Json web_panels(std::string title, Json panels);

/// The panels of a figure, their curves packed (`packed_points`).
/// @param spots  that are told apart along each axis
Json web_figure(const Figure& figure, int spots = 1500);

}  // namespace plastica::report
