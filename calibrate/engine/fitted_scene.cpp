#include "calibrate/engine/fitted_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/model/region.hpp"

namespace plastica::calibrate {
namespace {

/// "310.59 ± 2.4 MPa"; an error that is a NaN is left out.
std::string shown(std::string_view name, Dimension dimension, double value, double error) {
  const bool modulus = name.find("modulus") != std::string_view::npos;
  const report::DisplayUnit unit =
      plastica::report::display_unit(dimension, std::fabs(value), modulus);
  const double number = value / unit.scale;
  return report::quantity(std::isfinite(error) ? report::with_error(number, error / unit.scale)
                                               : report::significant(number),
                          unit.name);
}

/// Whether all targets of a fit have the same law, as where laws are compared.
bool has_one_law(const SceneFitRecord& record) {
  return std::ranges::all_of(record.result.targets, [&](const TargetFit& of_target) {
    return of_target.law == record.result.law;
  });
}

/// What a fit gave to a parameter that it did not search; none if tied to one that it cannot tell.
std::optional<double> held_value(const Parameter& held, const SceneFitRecord& record,
                                 std::span<const Parameter> parameters) {
  if (held.role == ParameterRole::Fixed) return held.value;
  for (const FittedParameter& base : record.result.parameters) {
    if (base.path != held.tied_to->path || base.role != ParameterRole::Free) continue;
    if (base.verdict() == Verdict::NotIdentified) return std::nullopt;
    return held.factor * base.value;
  }
  for (const Parameter& base : parameters) {
    if (base.field == held.tied_to && base.value) return held.factor * *base.value;
  }
  return std::nullopt;
}

/// Takes what the fit was told of the material besides its parameters: what its file says, what is
/// not the default's, and Young's modulus of a fit to normal stresses.
void take_stated(const FitRecord& record, const FitOptions& options, FittedScene& fitted) {
  const Setup defaults;
  Setup out{fitted.scene, {}};
  for (const Field& field : fields()) {
    if (!field.path.starts_with("material.") || field.path == "material.name" ||
        field.path.starts_with("material.hardening.") || field.path.starts_with("material.rate.")) {
      continue;
    }
    if (record.result.find_parameter(field.path) != nullptr) continue;
    const FieldValue stated = field.get(options.setup);
    const bool is_told = field.path == "material.youngs_modulus" &&
                         record.target.test != Test::Torsion && !options.parameters.empty();
    const bool is_said = std::ranges::any_of(options.stated, [&](const std::string& said) {
      // A material that is named says nothing of what it lacks.
      const bool named = said == "material" && !std::holds_alternative<std::monostate>(stated);
      return said == field.path || named;
    });
    if (!is_told && !is_said && stated == field.get(defaults)) continue;
    if (stated == field.get(out)) continue;
    field.set(out, stated);
    const auto* number = std::get_if<double>(&stated);
    fitted.notes.push_back(fmt::format("{} = {}, of the fit's material", last_part(field.path),
                                       number == nullptr
                                           ? "not set"
                                           : shown(field.path, field.dimension, *number,
                                                   std::numeric_limits<double>::quiet_NaN())));
  }
  fitted.scene = std::move(out.scene);
}

/// What an export has of the scene's material that neither the fit nor its file says.
void note_not_fitted(const Scene& scene, const FitRecord& record, FittedScene& fitted) {
  for (const char* path : {"material.density", "material.poisson_ratio"}) {
    const std::string name(last_part(path));
    const bool is_said = std::ranges::any_of(
        fitted.notes, [&](const std::string& note) { return note.starts_with(name + " = "); });
    const bool is_idle =  // beside a shear modulus of its own
        name == "poisson_ratio" && fitted.scene.material.shear_modulus.has_value();
    if (is_said || is_idle || record.result.find_parameter(path) != nullptr) continue;
    const Field& field = find_field(path);
    const FieldValue value = field.get(Setup{fitted.scene, {}});
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr) continue;
    fitted.notes.push_back(fmt::format(
        "{} = {}, of the scene's {}, not of {}", name,
        shown(path, field.dimension, *number, std::numeric_limits<double>::quiet_NaN()),
        scene.material.name.empty() ? "material" : scene.material.name, record.target.name));
  }
}

/// What stands at the head of an export, for whoever gets it without the report.
void note_doubts(const std::string& why_unusable, bool is_poor, std::vector<std::string>& notes) {
  if (!why_unusable.empty()) {
    notes.push_back("NO USABLE FIT: " + why_unusable);
  } else if (is_poor) {
    notes.emplace_back("a poor fit: its law does not describe the curve");
  }
}

}  // namespace

FittedScene fitted_scene(const Scene& scene, const FitRecord& record, const FitOptions& options) {
  if (record.result.status != FitStatus::Fitted) {
    throw InputError({}, "--case", record.target.name, "has no fit: " + report::reason_of(record));
  }
  FittedScene fitted{scene, {}};
  Scene& out = fitted.scene;
  fitted.notes.push_back("material fitted to " + record.target.name);
  note_doubts(why_unusable(record.result), record.result.misfit_word == "poor", fitted.notes);

  out.material.name = record.target.name;
  // The numbers of a law hold with that law.
  out.material.hardening = options.setup.scene.material.hardening;
  if (!options.laws.empty()) {
    out.material.hardening = hardening_of(record.result.law, out.material.hardening);
  }
  out.material.rate = options.setup.scene.material.rate;
  if (const auto rate = record.target.property("strain_rate")) {
    out.material.rate.strain_rate = rate;
  }
  take_stated(record, options, fitted);
  for (const FittedParameter& parameter : record.result.parameters) {
    if (parameter.role != ParameterRole::Fixed && !parameter.identified) {
      fitted.notes.push_back(
          fmt::format("{} is not identified by the fit: the scene's own stays", parameter.name()));
      continue;
    }
    Setup setup{out, {}};
    set_field(setup, find_field(parameter.path), parameter.value);
    out = std::move(setup.scene);
    fitted.notes.push_back(fmt::format(
        "{} = {}, {}{}", parameter.name(),
        shown(parameter.name(), parameter.dimension, parameter.value, parameter.standard_error),
        parameter.role == ParameterRole::Free ? "fitted" : word_of(parameter.role),
        parameter.at_lower || parameter.at_upper ? ", at a bound of the fit" : ""));
  }
  note_not_fitted(scene, record, fitted);
  follow_beam(out);
  const Scene& stated = options.setup.scene;
  if (record.target.test != Test::Tension && stated.yield_cap != scene.yield_cap) {
    fitted.notes.emplace_back(
        "the fit and the scene have different rules.yield_cap: the yield stress means another "
        "moment there");
  }
  return fitted;
}

FittedSetup fitted_setup(const Setup& setup, const SceneFitRecord& record, std::optional<Law> law,
                         std::span<const Parameter> parameters) {
  if (record.result.status != FitStatus::Fitted) {
    throw InputError({}, "--case", record.name, "has no fit: " + record.result.reason);
  }
  FittedSetup fitted{setup, {"fitted to " + record.name}};
  const bool is_poor = std::ranges::any_of(record.result.targets, [](const TargetFit& target) {
    return lacks_fit(target.misfit_fraction, target.runs_test_p);
  });
  note_doubts(why_unusable(record.result), is_poor, fitted.notes);
  // The numbers of a law hold with that law.
  if (law) fitted.setup = setup_of(*law, setup);
  if (!has_one_law(record)) {
    fitted.notes.push_back(
        law ? fmt::format("the fit's targets have several laws: this is {}", phrase_of(*law))
            : "the fit's targets have several laws: the scene keeps its own");
  }
  for (const FittedParameter& parameter : record.result.parameters) {
    if (parameter.role != ParameterRole::Free) continue;  // may be of another law: below
    if (parameter.verdict() == Verdict::NotIdentified) {
      fitted.notes.push_back(
          fmt::format("{} is not identified by the fit: the scene's own stays", parameter.path));
      continue;
    }
    set_everywhere(fitted.setup, find_field(parameter.path), parameter.value);
    fitted.notes.push_back(fmt::format(
        "{} = {}, {}", parameter.path,
        shown(parameter.path, parameter.dimension, parameter.value, parameter.standard_error),
        name_of(parameter.verdict())));
  }
  // A comparison leaves those of other laws out, and searches what was tied to them.
  const Law held_by = law.value_or(law_of(fitted.setup.scene.material.hardening, parameters));
  const auto own = parameters_of(held_by, Loading::Cyclic, parameters, parameters);
  for (const Parameter& held : parameters) {
    const bool of_the_law = std::ranges::find(own, held.field, &Parameter::field) != own.end();
    const FittedParameter* made = record.result.find_parameter(held.field->path);
    const bool searched = made != nullptr && made->role == ParameterRole::Free;
    if (!of_the_law || searched || held.role == ParameterRole::Free) continue;
    const std::string path(held.field->path);
    const auto value = held_value(held, record, parameters);
    if (!value) {
      fitted.notes.push_back(path + " is tied to what is not identified: the scene's own stays");
      continue;
    }
    set_everywhere(fitted.setup, *held.field, *value);
    fitted.notes.push_back(fmt::format(
        "{} = {}, {}", path,
        shown(path, held.field->dimension, *value, std::numeric_limits<double>::quiet_NaN()),
        word_of(held.role)));
  }
  fitted.setup.scene.material.name = record.name;
  follow_beam(fitted.setup.scene);
  return fitted;
}

}  // namespace plastica::calibrate
