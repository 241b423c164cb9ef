#include "sweeps/advise/word_axes.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <variant>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/solve/scheme.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kCostInSpace = 4.0;
constexpr double kCostOfStretch = 2.0;
constexpr double kCostOfFibre = 0.03;
/// In space the section has as many fibres across as along its depth.
constexpr double kCostOfFibreInSpace = 0.11;
constexpr double kCostOfArticulated = 0.1;

std::string word_in(const Setup& setup, const Field& field) {
  return std::get<std::string>(field.get(setup));
}

WordChoice choice_of(std::string_view path, std::string_view word) {
  return {{{&find_field(path), std::string(word)}}};
}

void apply(Setup& setup, const WordChoice& choice) {
  for (const auto& [field, word] : choice.values) set_field(setup, *field, word);
}

bool is_own(const Setup& setup, const WordChoice& choice) {
  return std::ranges::all_of(choice.values, [&](const auto& value) {
    return word_in(setup, *value.first) == value.second;
  });
}

/// The scene with a scheme that takes every model.
Setup with_any_model(Setup setup) {
  if (is_articulated(setup.solver.scheme)) {
    setup.solver.scheme = Scheme::LinearlyImplicitMidpoint;
  }
  return setup;
}

/// The choices that the checks accept, each once; the file's own is always one of them.
WordAxis axis_of_words(const Setup& setup, WordKind kind, const std::vector<WordChoice>& wanted) {
  WordAxis axis;
  axis.kind = kind;
  for (const WordChoice& choice : wanted) {
    const bool own = is_own(setup, choice);
    Setup with = kind == WordKind::Model ? with_any_model(setup) : setup;
    apply(with, choice);
    if (!own && !is_accepted(with)) continue;
    if (own) axis.own = axis.choices.size();
    axis.choices.push_back(choice);
  }
  axis.richest = kind == WordKind::Model ? axis.choices.size() - 1 : axis.own;
  return axis;
}

WordAxis level_axis(const Setup& setup) {
  const Field& field = find_field("solver.level");
  SolverOptions any = setup.solver;
  any.level = Level::Auto;
  const Level least = choose_level(setup.scene, any).level;
  const std::string_view word = field.choices[static_cast<std::size_t>(least)];
  const bool own_is_least = choose_level(setup.scene, setup.solver).level == least;
  std::vector<WordChoice> wanted{
      choice_of(field.path, own_is_least ? word_in(setup, field) : std::string(word))};
  if (!own_is_least && setup.solver.level != Level::Spatial) {
    wanted.push_back(choice_of(field.path, word_in(setup, field)));
  }
  if (least != Level::Spatial) wanted.push_back(choice_of(field.path, "spatial"));
  return axis_of_words(setup, WordKind::Model, wanted);
}

WordChoice yield_choice(std::string_view model, std::string_view cap) {
  WordChoice choice = choice_of("rules.yield_model", model);
  choice.values.emplace_back(&find_field("rules.yield_cap"), std::string(cap));
  return choice;
}

WordAxis yield_axis(const Setup& setup) {
  const YieldModel own = setup.scene.yield_model;
  const std::string cap = word_in(setup, find_field("rules.yield_cap"));
  const WordChoice of_file = yield_choice(word_in(setup, find_field("rules.yield_model")), cap);
  // What its file calls elastic shall not yield; that is no approximation of the same problem.
  if (own == YieldModel::Elastic) return axis_of_words(setup, WordKind::Model, {of_file});
  Setup fibres = with_any_model(setup);
  fibres.scene.yield_model = YieldModel::Fibre;
  fibres.scene.yield_cap = YieldCap::FirstYield;
  std::vector<WordChoice> wanted{yield_choice("elastic", cap)};
  const bool has_fibres = own == YieldModel::Fibre || is_accepted(fibres);
  const WordChoice capped = yield_choice("interaction", "fully_plastic");
  if (has_fibres && own != YieldModel::Fibre && !is_own(setup, capped)) wanted.push_back(of_file);
  if (has_fibres) {
    wanted.push_back(capped);
    wanted.push_back(yield_choice("fibre", "first_yield"));
  } else {
    wanted.push_back(of_file);
  }
  WordAxis axis = axis_of_words(setup, WordKind::Model, wanted);
  if (!has_fibres) axis.note = "the checks refuse fibres here: what they would change is not in it";
  return axis;
}

WordAxis method_axis(const Setup& setup, std::string_view path,
                     std::initializer_list<std::string_view> words) {
  std::vector<WordChoice> wanted;
  const Field& field = find_field(path);
  const std::string own = word_in(setup, field);
  wanted.push_back(choice_of(path, own));
  for (const std::string_view word : words) {
    if (word != own) wanted.push_back(choice_of(path, word));
  }
  return axis_of_words(setup, WordKind::Method, wanted);
}

/// Where the half joint is accepted, what else joins ends with an error of first order, or a larger
/// one of second, is no choice worth a run.
WordAxis end_rule_axis(const Setup& setup) {
  Setup half_joint = setup;
  half_joint.scene.end_rule = EndRule::HalfJoint;
  const bool has_half_joint = is_accepted(half_joint);
  WordAxis axis = has_half_joint
                      ? method_axis(setup, "rules.end_rule", {"half_joint", "half"})
                      : method_axis(setup, "rules.end_rule", {"half", "three_halves", "equal"});
  // "auto" is one of the others.
  const EndRule own = resolved_end_rule(setup.scene);
  std::erase_if(axis.choices, [&](const WordChoice& choice) {
    Setup with = setup;
    apply(with, choice);
    return !is_own(setup, choice) && with.scene.end_rule == own;
  });
  return axis;
}

/// Those of first order are as dear as those of second that solve once a step; those of Newton's
/// method are tried beside each other only where the scene has none of them.
WordAxis scheme_axis(const Setup& setup) {
  const Scheme own = setup.solver.scheme;
  const bool solves_once = solve::claims_of(own, setup.solver.rho_infinity).one_solve;
  return solves_once ? method_axis(setup, "solver.scheme",
                                   {"linearly_implicit_midpoint", "articulated_midpoint",
                                    "energy_momentum", "generalized_alpha"})
                     : method_axis(setup, "solver.scheme",
                                   {"linearly_implicit_midpoint", "articulated_midpoint"});
}

}  // namespace

std::string WordChoice::text() const {
  std::string text;
  const bool has_cap = values.front().second != "elastic" && values.front().second != "fibre";
  for (const auto& [field, word] : values) {
    if (field->path == "rules.yield_cap" && !has_cap) continue;
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::vector<WordAxis> word_axes(const Setup& setup) {
  std::vector<WordAxis> axes{level_axis(setup),
                             axis_of_words(setup, WordKind::Model,
                                           {choice_of("solver.translation", "rigid"),
                                            choice_of("solver.translation", "elastic")}),
                             yield_axis(setup), end_rule_axis(setup)};
  if (setup.solver.analysis == Analysis::Dynamics) {
    axes.push_back(scheme_axis(setup));
  }
  std::erase_if(axes, [](const WordAxis& axis) { return axis.choices.size() < 2; });
  return axes;
}

Words own_words(const std::vector<WordAxis>& axes) {
  Words own;
  for (const WordAxis& axis : axes) own.push_back(axis.own);
  return own;
}

Setup setup_with(const Setup& setup, const std::vector<WordAxis>& axes, const Words& words) {
  Setup with = setup;
  for (std::size_t w = 0; w < axes.size(); ++w) apply(with, axes[w].choices[words[w]]);
  return with;
}

bool is_accepted(const Setup& setup) {
  try {
    check_scene(setup.scene, setup.solver);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

double order_of_method(const Setup& setup, const Field& field) {
  if (field.path == "solver.scheme") {
    return solve::claims_of(setup.solver.scheme, setup.solver.rho_infinity).order;
  }
  // What a clamped segment leaves out is half a segment's bending at the clamp.
  return resolved_end_rule(setup.scene) == EndRule::Equal ? 1.0 : 2.0;
}

double kernel_cost(const Setup& setup) {
  const bool in_space = choose_level(setup.scene, setup.solver).level == Level::Spatial;
  double cost = in_space ? kCostInSpace : 1.0;
  if (setup.solver.translation == JointTranslation::Elastic) cost *= kCostOfStretch;
  if (setup.scene.yield_model == YieldModel::Fibre) {
    const double n = setup.solver.fibres;
    cost += in_space ? kCostOfFibreInSpace * n * n : kCostOfFibre * n;
  }
  if (setup.solver.analysis == Analysis::Dynamics && is_articulated(setup.solver.scheme)) {
    cost *= kCostOfArticulated;
  }
  return cost;
}

}  // namespace plastica::sweeps
