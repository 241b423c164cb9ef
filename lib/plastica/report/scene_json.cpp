#include "plastica/report/scene_json.hpp"
#include "plastica/model/support_kind.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "plastica/model/rate_kind.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/report/json_values.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_spectrum.hpp"

namespace plastica::report {
namespace {

Json level_word(Level level) {
  return find_field_or_null("solver.level")->choices[static_cast<std::size_t>(level)];
}

Json limit_of(const Response& response) {
  if (!response.limit) return nullptr;
  return {{"below", number(response.limit->below)},
          {"above", number(response.limit->above)},
          {"mode", numbers(response.limit->mode)}};
}

/// A list of modes, each with what else is known of it.
template <class Describe>
Json modes_of(std::span<const double> all, std::size_t count, const Describe& describe) {
  Json modes = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t each = all.size() / count;
    Json mode = describe(i);
    mode["mode"] = numbers(all.subspan(i * each, each));
    modes.push_back(std::move(mode));
  }
  return modes;
}

Json critical_points_of(const Response& response) {
  if (!response.critical) return Json::array();
  const CriticalPoints& critical = *response.critical;
  return modes_of(critical.mode, critical.factor.size(), [&](std::size_t i) {
    return Json{{"factor", number(critical.factor[i])},
                {"below", number(critical.below[i])},
                {"above", number(critical.above[i])},
                {"unstable_modes", critical.unstable_modes[i]},
                {"out_of_plane", critical.out_of_plane[i] != 0}};
  });
}

Json buckling_of(const Response& response) {
  if (!response.buckling) return nullptr;
  const BucklingModes& modes = *response.buckling;
  return {{"about", number(modes.about)},
          {"modes", modes_of(modes.mode, modes.factor.size(), [&](std::size_t i) {
             return Json{{"factor", number(modes.factor[i])},
                         {"rotation", number(modes.rotation[i])},
                         {"out_of_plane", modes.out_of_plane[i] != 0}};
           })}};
}

Json vibration_of(const Response& response) {
  if (!response.vibration) return nullptr;
  const VibrationModes& modes = *response.vibration;
  return modes_of(modes.mode, modes.frequency.size(), [&](std::size_t i) {
    return Json{{"frequency", number(modes.frequency[i])}};
  });
}

Json coupon_break_of(const Response& response) {
  if (!response.event) return nullptr;
  const BreakEvent& event = *response.event;
  return {{"sample", event.sample},
          {"strain", number(event.strain)},
          {"stress", number(event.stress)},
          {"permanent_strain", number(event.permanent_strain)},
          {"dissipation", number(event.dissipation)}};
}

Json joints_of(const io::SceneRecord& record, const ChainBreak& event) {
  Json joints = Json::array();
  for (const BrokenJoint& joint : event.joints) {
    joints.push_back({{"joint", joint.joint},
                      {"at", record.outline.ends[static_cast<std::size_t>(joint.joint)]},
                      {"cause", kBreakCauses[static_cast<std::size_t>(joint.cause)]},
                      {"cut", joint.cut},
                      {"strain", number(joint.strain)},
                      {"limit", number(joint.limit)},
                      {"moment", numbers(joint.moment)},
                      {"plastic_angle", numbers(joint.angle)},
                      {"dissipation", number(joint.dissipation)}});
  }
  return joints;
}

Json fragments_of(const io::SceneRecord& record, const ChainBreak& event) {
  const std::vector<double>& ends = record.outline.ends;
  const double length = record.setup.scene.beam.length;
  Json fragments = Json::array();
  for (const Fragment& fragment : event.fragments) {
    const double from = ends[static_cast<std::size_t>(fragment.first)];
    const double to = ends[static_cast<std::size_t>(fragment.last) + 1];
    fragments.push_back({{"first", fragment.first},
                         {"last", fragment.last},
                         {"from", from},
                         {"to", to},
                         {"length", length * (to - from)}});
  }
  return fragments;
}

Json events_of(const io::SceneRecord& record) {
  Json events = Json::array();
  for (const ChainBreak& event : record.response.chain.events) {
    events.push_back({{"time", number(event.time)},
                      {"factor", number(event.factor)},
                      {"joints", joints_of(record, event)},
                      {"fragments", fragments_of(record, event)}});
  }
  return events;
}

Json material_of(const Material& material) {
  Json all = {{"name", text_or_null(shown_name(material))},
              {"youngs_modulus", number(material.youngs_modulus)},
              {"yield_stress", number(material.yield_stress)},
              {"density", number(material.density)}};
  const RateKind& rate = rate_kind(material.rate.law);
  if (rate.parameters().empty()) return all;
  Setup setup;
  setup.scene.material = material;
  all["rate"] = {{"law", rate.word()}};
  for (const Field& field : rate.parameters()) {
    const FieldValue value = field.get(setup);
    const auto* set = std::get_if<double>(&value);
    all["rate"][field.path.substr(field.path.rfind('.') + 1)] =
        set != nullptr ? number(*set) : Json(nullptr);
  }
  return all;
}

/// The dimensions that the shape has, in SI units.
Json section_of(const Section& section) {
  const SectionKind& kind = section_kind(section);
  Json all = {{"shape", kind.word()}};
  if (!section.name.empty()) all["name"] = section.name;
  Setup setup;
  setup.scene.section = section;
  for (const Field& field : kind.dimensions()) {
    const std::string_view key = field.path.substr(field.path.find('.') + 1);
    all[std::string(key)] = number(std::get<double>(field.get(setup)));
  }
  return all;
}

Json history_of(const History& history) {
  Json all = {{"time", numbers(history.time)},
              {"factor", numbers(history.factor)},
              {"continues", history.continues}};
  if (!history.slope.empty()) all["slope"] = numbers(history.slope);
  return all;
}

Json regions_of(const Scene& scene) {
  Json all = Json::array();
  for (const Region& region : scene.regions) {
    all.push_back({{"from", region.from.fraction},
                   {"to", region.to.fraction},
                   {"section", section_of(region.section)},
                   {"material", material_of(region.material)}});
    if (region.to_section) all.back()["to_section"] = section_of(*region.to_section);
  }
  return all;
}

/// Adds a number, or a vector, of an item.
template <class Item>
void put(Json& all, const ItemField<Item>& field, const Item& item) {
  const double* one = field.number(item);
  all[std::string(field.key)] = one ? number(*one) : numbers(field.values(item));
}

/// What a support holds, what its kind alone has, and how it moves (null: not at all).
Json support_of(const Support& support) {
  Json holds = Json::array();
  for (std::size_t k = 0; k < freedom_names().size(); ++k) {
    if (support.held()[k]) holds.push_back(freedom_names()[k]);
  }
  Json all = {
      {"kind", traits_of(support).word}, {"at", support.at.fraction}, {"holds", std::move(holds)}};
  if (support.to) all["to"] = support.to->fraction;
  Json motion = {{"history", history_of(support.history)}};
  for (const SupportField& field : support_fields()) {
    if (field.belongs_to(support)) put(field.of ? all : motion, field, support);
  }
  all["motion"] = support.moves() ? std::move(motion) : Json(nullptr);
  return all;
}

Json supports_of(const Scene& scene) {
  Json all = Json::array();
  for (const Support& support : scene.supports) all.push_back(support_of(support));
  return all;
}

/// Loads at a point, and per length (`to` is a place): their units say which.
Json loads_of(const Scene& scene) {
  Json all = Json::array();
  for (const Load& load : scene.loads) {
    Json one = {{"at", load.at.fraction},
                {"to", load.to ? Json(load.to->fraction) : Json(nullptr)},
                {"follows", load.follows},
                {"history", history_of(load.history)}};
    for (const auto& field : load_fields()) {
      put(one, field, load);
      one[std::string(field.key) + "_unit"] = si_unit(field.dimension_of(load));
    }
    all.push_back(std::move(one));
  }
  return all;
}

Json masses_of(const Scene& scene) {
  Json all = Json::array();
  for (const PointMass& mass : scene.masses) {
    all.push_back({{"at", mass.at.fraction}});
    for (const auto& field : mass_fields()) put(all.back(), field, mass);
  }
  return all;
}

Json gravity_of(const Scene& scene) {
  if (scene.gravity == std::array<double, 3>{}) return nullptr;
  return {{"acceleration", numbers(scene.gravity)}, {"history", history_of(scene.gravity_history)}};
}

/// How a motion is stepped; null for a path of equilibria and a coupon.
Json motion_of(const io::SceneRecord& record) {
  if (!is_motion(record)) return nullptr;
  const SolverOptions& solver = record.setup.solver;
  return {{"scheme", solver_word(record, "solver.scheme")},
          {"time_step", number(solver.time_step)},
          {"shortest_step", number(record.response.shortest_step)},
          {"longest_step", number(record.response.longest_step)},
          {"step_cut", step_cut(record)},
          {"step_error", number(solver.step_error)},
          {"rho_infinity", number(solver.rho_infinity)},
          {"damping", solver_word(record, "solver.damping")},
          {"damping_time", number(solver.damping_time)}};
}

/// The peaks of each displacement's and velocity's spectrum, the strongest first.
Json frequencies_of(const io::SceneRecord& record) {
  Json all = Json::object();
  for (const std::size_t p : spectral_probes(record)) {
    Json peaks = Json::array();
    for (const theory::SpectralPeak& peak : theory::spectral_peaks(spectrum_of(record, p))) {
      peaks.push_back(
          {{"frequency", number(peak.frequency)}, {"amplitude", number(peak.amplitude)}});
    }
    all[record.setup.scene.probes[p].name] = std::move(peaks);
  }
  return all;
}

Json probes_of(const io::SceneRecord& record) {
  Json all = Json::object();
  const Scene& scene = record.setup.scene;
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    const Probe& probe = scene.probes[p];
    const auto& values = record.response.probes[p];
    Json entry = {{"kind", probe_kinds()[static_cast<std::size_t>(probe.quantity)]},
                  {"unit", si_unit(dimension_of(probe.quantity, scene.drive.deformation))},
                  {"last", nullptr},
                  {"min", nullptr},
                  {"max", nullptr}};
    if (!values.empty()) {
      entry["last"] = number(values.back());
      entry["min"] = number(*std::min_element(values.begin(), values.end()));
      entry["max"] = number(*std::max_element(values.begin(), values.end()));
    }
    all[probe.name] = std::move(entry);
  }
  return all;
}

Json peak_of(const io::SceneRecord& record, const std::optional<Peak>& peak) {
  if (!peak) return nullptr;
  return {{"value", number(peak->value)},
          {"joint", peak->joint},
          {"at", record.outline.ends[peak->joint]},
          {"sample", peak->sample}};
}

Json peaks_json(const io::SceneRecord& record) {
  const ScenePeaks peaks = peaks_of(record);
  Json moment = peak_of(record, peaks.moment);
  if (peaks.moment) moment["axis"] = axis_name(peaks.moment->axis);
  return {{"displacement", peak_of(record, peaks.displacement)},
          {"moment", std::move(moment)},
          {"bending_stress", peak_of(record, peaks.stress)},
          {"shear_stress", peak_of(record, peaks.shear_stress)},
          {"plastic_strain", peak_of(record, peaks.plastic_strain)}};
}

Json reactions_of(const io::SceneRecord& record) {
  const ChainHistory& chain = record.response.chain;
  Json all = Json::array();
  if (frames_of(record) == 0) return all;
  const std::span<const double> reactions(chain.reaction);
  for (std::size_t s = 0; s < chain.supports; ++s) {
    const Support& support = record.setup.scene.supports[s];
    const std::size_t at = (frame_at(record) * chain.supports + s) * 6;
    all.push_back({{"kind", traits_of(support).word},
                   {"at", support.at.fraction},
                   {"force", numbers(reactions.subspan(at, 3))},
                   {"moment", numbers(reactions.subspan(at + 3, 3))}});
  }
  return all;
}

Json energies_of(const io::SceneRecord& record) {
  const auto& energy = record.response.chain.energy;
  if (energy.empty()) return nullptr;
  Json all = Json::object();
  for (const EnergyEntry& entry : energy_entries()) {
    all[std::string(entry.name)] = number(energy.back().*entry.member);
  }
  all["residual"] = number(energy.back().residual);
  const auto fraction = residual_fraction(record);
  all["residual_fraction"] = fraction ? number(*fraction) : Json(nullptr);
  all["energy_balance_error"] = number(record.response.energy_balance_error);
  all["momentum_error"] = number(record.response.momentum_error);
  all["balanced"] = record.response.balances();
  return all;
}

}  // namespace

std::string scene_json(const io::SceneRecord& record) {
  const Response& response = record.response;
  const PathCounters& counters = response.counters;
  const Scene& scene = record.setup.scene;
  const Json all = {{"name", scene.name},
                    {"status", name_of(response.status)},
                    {"level", level_word(record.level)},
                    {"level_reason", record.level_reason},
                    {"material", material_of(scene.material)},
                    {"section", section_of(scene.section)},
                    {"yield_model", solver_word(record, "rules.yield_model")},
                    {"yield_cap", solver_word(record, "rules.yield_cap")},
                    {"regions", regions_of(scene)},
                    {"supports", supports_of(scene)},
                    {"loads", loads_of(scene)},
                    {"masses", masses_of(scene)},
                    {"gravity", gravity_of(scene)},
                    {"motion", motion_of(record)},
                    {"samples", response.samples},
                    {"frames", frames_of(record)},
                    {"permanent_strain", number(response.permanent_strain)},
                    {"limit_load", limit_of(response)},
                    {"critical_points", critical_points_of(response)},
                    {"buckling", buckling_of(response)},
                    {"vibration", vibration_of(response)},
                    {"coupon_break", coupon_break_of(response)},
                    {"events", events_of(record)},
                    {"probes", probes_of(record)},
                    {"frequencies", frequencies_of(record)},
                    {"peaks", peaks_json(record)},
                    {"reactions", reactions_of(record)},
                    {"energies", energies_of(record)},
                    {"counters",
                     {{"steps", counters.steps},
                      {"iterations", counters.iterations},
                      {"cutbacks", counters.cutbacks}}},
                    {"seconds", number(response.seconds)},
                    {"warnings", record.warnings}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::report
