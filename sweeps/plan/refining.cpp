#include "sweeps/plan/refining.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

namespace plastica::sweeps {
namespace {

struct NumberRow {
  std::string_view path;
  Refinement refinement;
};

constexpr std::array<NumberRow, 8> kNumbers{{
    {"beam.segments", Refinement::Count},
    {"beam.segment_depth", Refinement::Size},
    {"solver.fibres", Refinement::Count},
    {"solver.steps", Refinement::Count},
    {"solver.time_step", Refinement::Size},
    {"solver.step_error", Refinement::Size},
    {"solver.tolerance", Refinement::Size},
    {"solver.largest_rotation", Refinement::Size},
}};

struct WordRow {
  std::string_view path;
  bool converge;                           ///< all words to one result
  std::array<std::string_view, 4> finest;  ///< the rest is empty
};

constexpr std::array<WordRow, 7> kWords{{
    {"solver.level", false, {"spatial"}},
    {"solver.translation", false, {"elastic"}},
    {"solver.precision", false, {"double"}},
    {"solver.rotary_inertia", false, {"on"}},
    // Of order two, where the others have order one.
    {"solver.scheme",
     true,
     {"linearly_implicit_midpoint", "generalized_alpha", "energy_momentum",
      "articulated_midpoint"}},
    {"rules.end_rule", true, {"half_joint", "auto"}},
    {"rules.yield_model", false, {"fibre"}},
}};

constexpr std::array<std::string_view, 7> kMethods{
    "rules.yield_cap", "solver.rho_infinity",   "solver.isa",          "solver.frames",
    "solver.control",  "solver.max_iterations", "solver.smallest_step"};

template <class Rows>
const auto* row_of(const Rows& rows, const Field& field) {
  const auto* found = std::find_if(rows.begin(), rows.end(),
                                   [&](const auto& row) { return row.path == field.path; });
  return found == rows.end() ? nullptr : found;
}

}  // namespace

Refinement refinement_of(const Field& field) {
  const NumberRow* row = row_of(kNumbers, field);
  return row == nullptr ? Refinement::None : row->refinement;
}

AxisRole role_of(const Field& field) {
  if (row_of(kNumbers, field) != nullptr) return AxisRole::Number;
  if (row_of(kWords, field) != nullptr) return AxisRole::Word;
  const bool method = std::find(kMethods.begin(), kMethods.end(), field.path) != kMethods.end();
  return method ? AxisRole::Method : AxisRole::Problem;
}

bool is_finest_word(const Field& field, const FieldValue& value) {
  const WordRow* row = row_of(kWords, field);
  const auto* word = std::get_if<std::string>(&value);
  if (row == nullptr || word == nullptr) return false;
  return std::find(row->finest.begin(), row->finest.end(), *word) != row->finest.end();
}

bool words_converge(const Field& field) {
  const WordRow* row = row_of(kWords, field);
  return row != nullptr && row->converge;
}

}  // namespace plastica::sweeps
