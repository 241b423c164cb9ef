#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plastica/model/checked_scene.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/rate_kind.hpp"
#include "plastica/model/region.hpp"
#include "plastica/model/shared_moments.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/run/chain_shape.hpp"
#include "plastica/run/check_regions.hpp"
#include "plastica/run/check_support_axes.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/run/response_size.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica {
namespace {

/// What the sections of a level bend about; empty where there is one force: the closest point of
/// any yield surface is then the clipped force.
std::optional<law::GaugePlane> yields_about(const LevelChoice& level) {
  switch (level.level) {
    case Level::Twist: return {};
    case Level::Planar:
      return level.bending == BendingAxis::X ? law::GaugePlane::AboutX : law::GaugePlane::AboutY;
    default: return law::GaugePlane::Both;
  }
}

/// @param nodes  of the joint that each cut of the scene is nearest to
void set_cuts(const std::vector<int>& nodes, ChainModel& chain) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    chain.cuts.push_back({chain.scene.cuts[i].time, static_cast<std::size_t>(nodes[i])});
  }
  std::sort(chain.cuts.begin(), chain.cuts.end(), [](const JointCut& a, const JointCut& b) {
    return a.time != b.time ? a.time < b.time : a.node < b.node;
  });
}

void set_stops(ChainModel& chain) {
  PathStops stops = path_stops(chain.scene, chain.options);
  chain.stops = std::move(stops.time);
  chain.recorded = std::move(stops.recorded);
  // A cut that rounding sets behind its stop would have to wait for the next one.
  for (JointCut& cut : chain.cuts) {
    for (const double stop : chain.stops) {
      if (std::abs(stop - cut.time) < 1e-9 * chain.stops.back()) cut.time = stop;
    }
  }
  chain.samples = response_size(chain).samples;
}

/// The samples whose shape is kept: all, or so many evenly spaced ones and the first.
void set_frames(ChainModel& chain) {
  const auto steps = static_cast<std::size_t>(chain.options.steps);
  const std::size_t frames = response_size(chain).frames - 1;
  for (std::size_t k = 0; k <= frames; ++k) chain.frame_sample.push_back(k * steps / frames);
}

std::shared_ptr<const ChainModel> prepare_chain(const Scene& scene, const SolverOptions& options,
                                                model_detail::CheckedScene checked) {
  check_regions(scene);
  auto chain = std::make_shared<ChainModel>();
  chain->scene = scene;
  chain->options = options;
  chain->level = checked.level.level;
  chain->across = checked.level.bending == BendingAxis::X ? 1 : 0;
  chain->layout = chain::make_layout(scene, std::move(checked.ends), yields_about(checked.level));
  check_support_axes(scene, chain->layout);
  set_cuts(checked.cuts, *chain);
  set_stops(*chain);
  set_frames(*chain);
  return chain;
}

/// Refuses material numbers that a prepared chain does not read: what breaks and what is derived is
/// laid out with the scene.
void check_chain_parameter(const Field& field, const Scene& scene, const SolverOptions& options) {
  const Material& material = scene.material;
  std::string_view why;
  switch (*field.material) {
    case MaterialField::BreakStrain:
    case MaterialField::BreakShearStrain:
      why = "cannot be a parameter of a chain, whose break limits are those of its scene";
      break;
    case MaterialField::ShearModulus:
      if (!material.shear_modulus) why = "must be set in the scene to be a parameter of a chain";
      break;
    case MaterialField::ShearYieldStress:
      if (!material.shear_yield_stress) {
        why = "must be set in the scene to be a parameter of a chain";
      }
      break;
    case MaterialField::PoissonRatio:
      if (options.translation == JointTranslation::Elastic) {
        why =
            "cannot be a parameter of a chain whose joints stretch: its shear coefficient is laid "
            "out with the scene";
      }
      break;
    case MaterialField::TangentModulus:
      if (!(material.hardening.tangent_modulus > 0.0)) {
        why =
            "must be above 0 in the scene to be a parameter of a chain: whether it hardens "
            "decides how strains spread";
      }
      break;
    default: break;
  }
  if (!why.empty()) throw InputError({}, field.path, "", why);
}

/// Refuses a number of a law that the material has not: it would move nothing.
/// @param kinds  of laws, one of which the material has
template <class Kinds, class Kind>
void check_law_has(const Field& field, const Kinds& kinds, const Kind& own, const char* key) {
  const auto has = [&](const Kind& kind) {
    return std::ranges::any_of(kind.parameters(),
                               [&](const Field& other) { return other.path == field.path; });
  };
  const bool is_of_some = std::ranges::any_of(kinds, [&](const Kind* kind) { return has(*kind); });
  if (!is_of_some || has(own)) return;
  throw InputError({}, field.path, "",
                   "would move nothing: " + std::string(key) + " is " + std::string(own.word()) +
                       ", which does not have it");
}

bool is_stiffness(const Field& field) {
  return field.material == MaterialField::YoungsModulus ||
         field.material == MaterialField::ShearModulus;
}

void size_chain(const ChainModel& chain, const ResponseSize& size, Response& response) {
  ChainHistory& history = response.chain;
  history.time.assign(size.samples, 0.0);
  history.factor.assign(size.samples, 0.0);
  history.energy.assign(size.samples, {});
  history.iterations.assign(size.samples, 0);
  history.frame_sample = chain.frame_sample;
  size_shape(size, size.frames, history);
}

}  // namespace

bool is_motion(const Model& model) {
  return model.chain && model.chain->options.analysis == Analysis::Dynamics;
}

Model prepare(const Scene& scene, const SolverOptions& options,
              std::span<const std::string> parameters) {
  model_detail::CheckedScene checked = model_detail::checked_scene(scene, options);

  Model model;
  model.level = checked.level.level;
  model.level_reason = checked.level.reason;
  if (model.level == Level::Coupon) {
    model.coupon = coupon::coupon_shape(scene);
  } else {
    model.chain = prepare_chain(scene, options, std::move(checked));
  }
  model.material = material_values(scene.material);
  model.hardening = scene.material.hardening.law;
  model.drive = scene.drive.strain;
  model.on_break = scene.on_break;
  for (const Probe& probe : scene.probes) model.probes.push_back(probe.quantity);

  for (const std::string& path : parameters) {
    const Field& field = find_field(path);
    if (!field.material) {
      throw InputError(
          {}, field.path, "",
          model.chain ? "cannot be a parameter of a chain" : "cannot be a parameter of a coupon");
    }
    const Material& material = scene.material;
    check_law_has(field, hardening_kinds(), hardening_kind(material.hardening.law),
                  "material.hardening.law");
    check_law_has(field, rate_kinds(), rate_kind(material.rate.law), "material.rate.law");
    if (model.chain) check_chain_parameter(field, scene, options);
    if (model.chain && is_stiffness(field) &&
        model_detail::shares_moments(scene, model.chain->layout.ends)) {
      throw InputError({}, field.path, "",
                       "cannot be a parameter where a moment acts at a rotational spring within "
                       "the beam: both share it by the beam's stiffness, as the scene is laid out");
    }
    if (stands_in_regions(scene, field)) {
      throw InputError(
          {}, field.path, "",
          "cannot be a parameter: a region takes it from the beam; set it in the scene");
    }
    if (std::find(model.parameters.begin(), model.parameters.end(), &field) !=
        model.parameters.end()) {
      throw InputError({}, field.path, "", "is a parameter twice");
    }
    // A parameter is given, even if the scene leaves the field to its default.
    switch (*field.material) {
      case MaterialField::ShearModulus: model.coupon.shear_modulus_given = true; break;
      case MaterialField::ShearYieldStress: model.coupon.shear_yield_given = true; break;
      case MaterialField::BreakStrain: model.coupon.break_given = true; break;
      case MaterialField::BreakShearStrain: model.coupon.break_shear_given = true; break;
      default: break;
    }
    model.parameters.push_back(&field);
  }
  return model;
}

Response make_response(const Model& model) {
  Response response;
  const ResponseSize size = response_size(model);
  response.probes.assign(size.probes, std::vector<double>(size.samples));
  if (model.chain) size_chain(*model.chain, size, response);
  return response;
}

Sensitivity make_sensitivity(const Model& model) {
  Sensitivity sensitivity;
  sensitivity.stress.resize(model.drive.size() * model.parameters.size());
  sensitivity.permanent_strain.resize(model.parameters.size());
  return sensitivity;
}

Workspace make_workspace(const Model& model) {
  Workspace workspace;
  if (!model.chain) return workspace;
  workspace.model = model.chain;
  workspace.chain.reset(make_chain_program(*model.chain).release());
  return workspace;
}

void DeleteProgram::operator()(ChainProgram* program) const { delete program; }

Response simulate(const Scene& scene, const SolverOptions& options, const BreakListener& on_break) {
  check_memory(scene, options);
  const Model model = prepare(scene, options);
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  workspace.on_break = on_break;
  run(model, {}, workspace, response);
  return response;
}

}  // namespace plastica
