#include "calibrate/problem/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/rate_kind.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::array<std::string_view, 5> kNames{"ideal", "linear", "voce", "chaboche",
                                                 "multilinear"};

/// A hardening parameter and the laws that have it.
struct LawParameter {
  std::string_view name;
  MaterialField field;
  bool linear, voce, chaboche, multilinear;
  bool freed;  ///< by the laws themselves
};

constexpr std::array<LawParameter, 10> kParameters{{
    {"tangent_modulus", MaterialField::TangentModulus, true, false, false, false, true},
    {"kinematic_fraction", MaterialField::KinematicFraction, true, false, false, true, true},
    {"saturation_stress", MaterialField::SaturationStress, false, true, true, false, true},
    {"saturation_rate", MaterialField::SaturationRate, false, true, true, false, true},
    {"backstress_modulus_1", MaterialField::BackModulus1, false, false, true, false, true},
    {"backstress_rate_1", MaterialField::BackRate1, false, false, true, false, true},
    {"backstress_modulus_2", MaterialField::BackModulus2, false, false, true, false, true},
    {"backstress_rate_2", MaterialField::BackRate2, false, false, true, false, true},
    {"backstress_modulus_3", MaterialField::BackModulus3, false, false, true, false, false},
    {"backstress_rate_3", MaterialField::BackRate3, false, false, true, false, false},
}};

/// Whether a law has the parameter of a fit, if it is one of hardening.
bool has(Law law, const LawParameter& p) {
  switch (law) {
    case Law::Ideal: return false;
    case Law::Linear: return p.linear;
    case Law::Voce: return p.voce;
    case Law::Chaboche: return p.chaboche;
    case Law::Multilinear: return p.multilinear;
  }
  return false;
}

/// Refuses parameters of another rate law.
void check_rate_parameters(std::span<const Parameter> parameters, const RateKind& law) {
  for (const Parameter& p : parameters) {
    const auto has_it = [&](const RateKind* kind) {
      return std::ranges::any_of(kind->parameters(),
                                 [&](const Field& field) { return field.path == p.field->path; });
    };
    if (has_it(&law) || std::ranges::none_of(rate_kinds(), has_it)) continue;
    throw InputError(p.where, p.name(), "",
                     fmt::format("is no parameter of material.rate.law = \"{}\": it would move "
                                 "nothing",
                                 law.word()));
  }
}

const LawParameter* find(const Parameter& parameter) {
  for (const LawParameter& p : kParameters) {
    if (parameter.field->material == p.field) return &p;
  }
  return nullptr;
}

bool contains(std::span<const Parameter> all, const Field* field) {
  return std::ranges::any_of(all, [&](const Parameter& p) { return p.field == field; });
}

}  // namespace

std::string_view name_of(Law law) {
  const auto i = static_cast<std::size_t>(law);
  return i < kNames.size() ? kNames[i] : std::string_view();
}

std::span<const std::string_view> law_names() { return kNames; }

std::string_view phrase_of(Law law) {
  switch (law) {
    case Law::Ideal: return "ideal plasticity";
    case Law::Linear: return "linear hardening";
    case Law::Voce: return "Voce hardening";
    case Law::Chaboche: return "Voce-Chaboche hardening";
    case Law::Multilinear: return "multilinear hardening";
  }
  return "the model";
}

std::vector<Law> laws_of(std::span<const std::string> words, std::string_view key,
                         const SourceLocation& where) {
  std::vector<Law> laws;
  for (const std::string& word : words) {
    const auto found = std::ranges::find(kNames, std::string_view(word));
    if (found == kNames.end()) {
      throw InputError(where, key, word,
                       fmt::format("is no law; there are {}", fmt::join(kNames, ", ")));
    }
    const auto law = static_cast<Law>(found - kNames.begin());
    if (std::ranges::find(laws, law) != laws.end()) {
      throw InputError(where, key, word, "is named twice");
    }
    laws.push_back(law);
  }
  std::ranges::sort(laws);
  return laws;
}

Law law_of(const Hardening& hardening, std::span<const Parameter> parameters) {
  switch (hardening.law) {
    case HardeningLaw::Ideal: return Law::Ideal;
    case HardeningLaw::Linear: return Law::Linear;
    case HardeningLaw::Multilinear: return Law::Multilinear;
    case HardeningLaw::VoceChaboche: break;
  }
  const auto is_there = [](double modulus) { return modulus != 0.0; };
  bool back = std::ranges::any_of(hardening.backstress_modulus, is_there);
  for (const Parameter& parameter : parameters) {
    const LawParameter* p = find(parameter);
    back = back || (p != nullptr && p->chaboche && !p->voce);
  }
  return back ? Law::Chaboche : Law::Voce;
}

std::vector<Parameter> parameters_of(std::span<const Law> laws, std::vector<Parameter> given) {
  for (const LawParameter& p : kParameters) {
    const bool wanted = p.freed && std::ranges::any_of(laws, [&](Law law) { return has(law, p); });
    const Field& field = find_field(fmt::format("material.hardening.{}", p.name));
    if (!wanted || contains(given, &field)) continue;
    given.emplace_back().field = &field;
  }
  return given;
}

std::vector<Parameter> parameters_of(Law law, Loading loading, std::span<const Parameter> all,
                                     std::span<const Parameter> given) {
  std::vector<Parameter> own;
  for (const Parameter& parameter : all) {
    const LawParameter* p = find(parameter);
    const bool no_effect = p != nullptr && p->field == MaterialField::KinematicFraction &&
                           loading == Loading::Monotonic && !contains(given, parameter.field);
    const bool of_table = parameter.field->material && is_of_table(*parameter.field->material);
    const bool has_it = p == nullptr ? !of_table || law == Law::Multilinear : has(law, *p);
    if (has_it && !no_effect) own.push_back(parameter);
  }
  // A tie to a parameter that this law does not have leaves its own free.
  for (Parameter& parameter : own) {
    if (parameter.role != ParameterRole::Tied || contains(own, parameter.tied_to)) continue;
    Parameter freed;
    freed.field = parameter.field;
    freed.where = parameter.where;
    parameter = std::move(freed);
  }
  return own;
}

void check_law_parameters(std::span<const Parameter> parameters, const Material& material,
                          std::span<const Law> laws) {
  check_rate_parameters(parameters, rate_kind(material.rate.law));
  const Hardening& hardening = material.hardening;
  if (std::ranges::find(laws, Law::Multilinear) != laws.end() &&
      hardening.plastic_strain.front() <= 0.0) {
    throw InputError({}, "laws", std::string(name_of(Law::Multilinear)),
                     "needs a table, and none is made up: material.hardening.plastic_strain and "
                     "flow_stress of a fit file say where its fit begins");
  }
  std::vector<const HardeningKind*> kinds{&hardening_kind(hardening.law)};
  for (const Law law : laws) kinds.push_back(&hardening_kind(hardening_of(law, hardening).law));
  const auto has_it = [](const HardeningKind* kind, const Parameter& p) {
    return std::ranges::any_of(kind->parameters(),
                               [&](const Field& field) { return field.path == p.field->path; });
  };
  for (const Parameter& p : parameters) {
    const auto own = [&](const HardeningKind* kind) { return has_it(kind, p); };
    if (std::ranges::none_of(hardening_kinds(), own)) continue;
    if (std::ranges::none_of(kinds, own)) {
      throw InputError(p.where, p.name(), "",
                       fmt::format("is no parameter of material.hardening.law = \"{}\": it would "
                                   "move nothing",
                                   kinds.front()->word()));
    }
    if (!is_of_table(*p.field->material)) continue;
    const auto points =
        std::ranges::count_if(hardening.plastic_strain, [](double strain) { return strain > 0.0; });
    const auto point = (static_cast<std::size_t>(*p.field->material) -
                        static_cast<std::size_t>(MaterialField::PlasticStrain1)) %
                       Hardening::kTablePoints;
    if (point < static_cast<std::size_t>(points)) continue;
    throw InputError(p.where, p.name(), "",
                     fmt::format("is no point of the table, which has {}", points));
  }
}

Hardening hardening_of(Law law, const Hardening& given) {
  Hardening hardening = given;
  switch (law) {
    case Law::Ideal: hardening.law = HardeningLaw::Ideal; break;
    case Law::Linear: hardening.law = HardeningLaw::Linear; break;
    case Law::Voce: hardening.backstress_modulus = {}; [[fallthrough]];
    case Law::Chaboche: hardening.law = HardeningLaw::VoceChaboche; break;
    case Law::Multilinear: hardening.law = HardeningLaw::Multilinear; break;
  }
  return hardening;
}

std::optional<double> min_effect_value(const Parameter& parameter, double lower, double upper) {
  if (!parameter.field->material) return std::nullopt;
  switch (*parameter.field->material) {
    case MaterialField::TangentModulus:
    case MaterialField::SaturationStress:
    case MaterialField::SaturationRate:
    case MaterialField::BackModulus1:
    case MaterialField::BackModulus2:
    case MaterialField::BackModulus3: return std::clamp(0.0, lower, upper);
    case MaterialField::BackRate1:
    case MaterialField::BackRate2:
    case MaterialField::BackRate3: return upper;
    default: return std::nullopt;
  }
}

bool contains(Law law, Law simpler) {
  for (Law below = law; has_simpler(below, below);) {
    if (below == simpler) return true;
  }
  return false;
}

bool has_simpler(Law law, Law& simpler) {
  simpler = law == Law::Chaboche ? Law::Voce : Law::Ideal;
  return law != Law::Ideal;
}

std::string laws_to_try(Law law, Loading loading, std::span<const Law> tried) {
  // A table is the user's: none is made up.
  const Law last = loading == Loading::Cyclic || law >= Law::Voce ? Law::Chaboche : Law::Voce;
  std::string names(name_of(law));
  bool any = false;
  for (std::size_t i = static_cast<std::size_t>(law) + 1; i < kNames.size(); ++i) {
    const auto next = static_cast<Law>(i);
    if (next > last) break;
    names += fmt::format(",{}", kNames[i]);
    any = any || std::ranges::find(tried, next) == tried.end();
  }
  return any ? names : std::string();
}

}  // namespace plastica::calibrate
