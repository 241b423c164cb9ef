#include "sweeps/plan/kind_axes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/rate_kind.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::sweeps {
namespace {

bool contains(std::span<const Field> fields, const Field& field) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& f) { return f.path == field.path; });
}

/// How the fields of a kind are told from those of others.
struct Shapes {
  using Kind = SectionKind;
  static constexpr std::string_view kChoice = "section.shape";
  static auto all() { return section_kinds(); }
  static const Kind& of(const Setup& setup) { return section_kind(setup.scene.section); }
  static auto fields(const Kind& kind) { return kind.dimensions(); }
};
struct Laws {
  using Kind = HardeningKind;
  static constexpr std::string_view kChoice = "material.hardening.law";
  static auto all() { return hardening_kinds(); }
  static const Kind& of(const Setup& setup) {
    return hardening_kind(setup.scene.material.hardening.law);
  }
  static auto fields(const Kind& kind) { return kind.parameters(); }
};
struct Rates {
  using Kind = RateKind;
  static constexpr std::string_view kChoice = "material.rate.law";
  static auto all() { return rate_kinds(); }
  static const Kind& of(const Setup& setup) { return rate_kind(setup.scene.material.rate.law); }
  static auto fields(const Kind& kind) { return kind.parameters(); }
};

template <class Kinds>
bool is_of_some(const Field& field) {
  const auto kinds = Kinds::all();
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const auto* kind) { return contains(Kinds::fields(*kind), field); });
}

/// Those that the cases have.
template <class Kinds>
std::vector<const typename Kinds::Kind*> kinds_of(const Sweep& sweep) {
  std::vector<const typename Kinds::Kind*> kinds;
  for (const Axis& axis : sweep.axes) {
    if (axis.field->path != Kinds::kChoice) continue;
    for (const FieldValue& value : axis.values) {
      Setup setup = sweep.setup;
      axis.field->set(setup, value);
      kinds.push_back(&Kinds::of(setup));
    }
  }
  if (kinds.empty()) kinds.push_back(&Kinds::of(sweep.setup));
  return kinds;
}

template <class Kinds>
void refuse_axes_that_move_nothing(const Sweep& sweep) {
  const auto kinds = kinds_of<Kinds>(sweep);
  for (const Axis& axis : sweep.axes) {
    if (!is_of_some<Kinds>(*axis.field)) continue;
    const bool moves = std::any_of(kinds.begin(), kinds.end(), [&](const auto* kind) {
      return contains(Kinds::fields(*kind), *axis.field);
    });
    if (moves) continue;
    throw InputError(axis.where, std::string(axis.field->path), "",
                     "moves nothing: " + std::string(Kinds::kChoice) + " is " +
                         std::string(kinds.front()->word()) +
                         (kinds.size() > 1 ? " and others" : "") + ", which does not have it");
  }
}

void require_dimensions(const Sweep& sweep) {
  const SectionKind& base = section_kind(sweep.setup.scene.section);
  for (const Axis& axis : sweep.axes) {
    if (axis.field->path != Shapes::kChoice) continue;
    for (const SectionKind* kind : kinds_of<Shapes>(sweep)) {
      for (const Field& field : kind->dimensions()) {
        if (contains(base.dimensions(), field) || !must_be_said(*kind, field)) continue;
        const bool given = std::any_of(sweep.axes.begin(), sweep.axes.end(),
                                       [&](const Axis& a) { return a.field->path == field.path; });
        if (given) continue;
        throw InputError(axis.where, Shapes::kChoice, std::string(kind->word()),
                         "needs " + std::string(field.path) + ", in [set] or as an axis");
      }
    }
  }
}

}  // namespace

bool is_section_dimension(const Field& field) { return is_of_some<Shapes>(field); }

void check_kind_axes(const Sweep& sweep) {
  refuse_axes_that_move_nothing<Shapes>(sweep);
  refuse_axes_that_move_nothing<Laws>(sweep);
  refuse_axes_that_move_nothing<Rates>(sweep);
  require_dimensions(sweep);
}

}  // namespace plastica::sweeps
