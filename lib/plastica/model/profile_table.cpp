#include "plastica/model/profile_table.hpp"

#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace plastica {
namespace {

/// Dimensions in mm, in the order of the standard.
struct Row {
  int size;
  double height, width, web, flange, fillet;
};

// clang-format off
constexpr std::array<Row, 18> kIpe{{
    {80, 80, 46, 3.8, 5.2, 5},
    {100, 100, 55, 4.1, 5.7, 7},
    {120, 120, 64, 4.4, 6.3, 7},
    {140, 140, 73, 4.7, 6.9, 7},
    {160, 160, 82, 5.0, 7.4, 9},
    {180, 180, 91, 5.3, 8.0, 9},
    {200, 200, 100, 5.6, 8.5, 12},
    {220, 220, 110, 5.9, 9.2, 12},
    {240, 240, 120, 6.2, 9.8, 15},
    {270, 270, 135, 6.6, 10.2, 15},
    {300, 300, 150, 7.1, 10.7, 15},
    {330, 330, 160, 7.5, 11.5, 18},
    {360, 360, 170, 8.0, 12.7, 18},
    {400, 400, 180, 8.6, 13.5, 21},
    {450, 450, 190, 9.4, 14.6, 21},
    {500, 500, 200, 10.2, 16.0, 21},
    {550, 550, 210, 11.1, 17.2, 24},
    {600, 600, 220, 12.0, 19.0, 24},
}};
constexpr std::array<Row, 24> kHea{{
    {100, 96, 100, 5.0, 8.0, 12},
    {120, 114, 120, 5.0, 8.0, 12},
    {140, 133, 140, 5.5, 8.5, 12},
    {160, 152, 160, 6.0, 9.0, 15},
    {180, 171, 180, 6.0, 9.5, 15},
    {200, 190, 200, 6.5, 10.0, 18},
    {220, 210, 220, 7.0, 11.0, 18},
    {240, 230, 240, 7.5, 12.0, 21},
    {260, 250, 260, 7.5, 12.5, 24},
    {280, 270, 280, 8.0, 13.0, 24},
    {300, 290, 300, 8.5, 14.0, 27},
    {320, 310, 300, 9.0, 15.5, 27},
    {340, 330, 300, 9.5, 16.5, 27},
    {360, 350, 300, 10.0, 17.5, 27},
    {400, 390, 300, 11.0, 19.0, 27},
    {450, 440, 300, 11.5, 21.0, 27},
    {500, 490, 300, 12.0, 23.0, 27},
    {550, 540, 300, 12.5, 24.0, 27},
    {600, 590, 300, 13.0, 25.0, 27},
    {650, 640, 300, 13.5, 26.0, 27},
    {700, 690, 300, 14.5, 27.0, 27},
    {800, 790, 300, 15.0, 28.0, 30},
    {900, 890, 300, 16.0, 30.0, 30},
    {1000, 990, 300, 16.5, 31.0, 30},
}};
constexpr std::array<Row, 24> kHeb{{
    {100, 100, 100, 6.0, 10.0, 12},
    {120, 120, 120, 6.5, 11.0, 12},
    {140, 140, 140, 7.0, 12.0, 12},
    {160, 160, 160, 8.0, 13.0, 15},
    {180, 180, 180, 8.5, 14.0, 15},
    {200, 200, 200, 9.0, 15.0, 18},
    {220, 220, 220, 9.5, 16.0, 18},
    {240, 240, 240, 10.0, 17.0, 21},
    {260, 260, 260, 10.0, 17.5, 24},
    {280, 280, 280, 10.5, 18.0, 24},
    {300, 300, 300, 11.0, 19.0, 27},
    {320, 320, 300, 11.5, 20.5, 27},
    {340, 340, 300, 12.0, 21.5, 27},
    {360, 360, 300, 12.5, 22.5, 27},
    {400, 400, 300, 13.5, 24.0, 27},
    {450, 450, 300, 14.0, 26.0, 27},
    {500, 500, 300, 14.5, 28.0, 27},
    {550, 550, 300, 15.0, 29.0, 27},
    {600, 600, 300, 15.5, 30.0, 27},
    {650, 650, 300, 16.0, 31.0, 27},
    {700, 700, 300, 17.0, 32.0, 27},
    {800, 800, 300, 17.5, 33.0, 30},
    {900, 900, 300, 18.5, 35.0, 30},
    {1000, 1000, 300, 19.0, 36.0, 30},
}};
// clang-format on

void add(std::string_view series, std::span<const Row> rows, std::vector<Section>& table) {
  constexpr double kMillimetre = 1e-3;
  for (const Row& row : rows) {
    Section section;
    section.shape = SectionShape::ISection;
    section.height = kMillimetre * row.height;
    section.width = kMillimetre * row.width;
    section.web_thickness = kMillimetre * row.web;
    section.flange_thickness = kMillimetre * row.flange;
    section.fillet_radius = kMillimetre * row.fillet;
    section.name = std::string(series) + ' ' + std::to_string(row.size);
    table.push_back(std::move(section));
  }
}

/// Capitals without blanks; the series first: HE300A is HEA300.
std::string canonical(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c != ' ') text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const bool series_last = text.size() > 3 && text.starts_with("HE") && text[2] >= '0' &&
                           text[2] <= '9' && (text.back() == 'A' || text.back() == 'B');
  if (!series_last) return text;
  const char series = text.back();
  text.pop_back();
  text.insert(2, 1, series);
  return text;
}

}  // namespace

std::span<const Section> profile_table() {
  static const std::vector<Section> table = [] {
    std::vector<Section> all;
    add("IPE", kIpe, all);
    add("HEA", kHea, all);
    add("HEB", kHeb, all);
    return all;
  }();
  return table;
}

const Section& named_profile(std::string_view name, const SourceLocation& where,
                             std::string_view field) {
  const std::string sought = canonical(name);
  for (const Section& profile : profile_table()) {
    if (canonical(profile.name) == sought) return profile;
  }
  throw InputError(where, field, name,
                   "is no profile that is known: IPE 80 to 600, HEA 100 to 1000, HEB 100 to 1000");
}

}  // namespace plastica
