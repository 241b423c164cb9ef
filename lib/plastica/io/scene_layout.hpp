#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "plastica/io/event_table.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/model/support_kind.hpp"

/// What of a simulated scene stands where in its file; not installed. Documented in docs/hdf5.md.
namespace plastica::io::scene_layout {

using Shape = std::vector<std::size_t>;

/// The element type of a number in the file.
template <class T>
using Stored = std::conditional_t<
    std::is_floating_point_v<T>, double,
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
                       std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>>;

/// The words of a field that is a choice, in the order of its enumerators.
std::span<const std::string_view> choices_of(std::string_view field);

#define PLASTICA_MEMBER(member) \
  [](auto& row) -> auto& { return row.member; }

/// The numbers of each item of a list, a column or three each.
template <class Store, class Rows, class Field>
void traverse_fields(Store& store, const std::string& list, Rows& rows,
                     std::span<const Field> fields) {
  for (const Field& field : fields) {
    const std::string path = list + '/' + std::string(field.key);
    std::visit(
        [&](auto member) {
          const auto of_row = [member](auto& row) -> auto& { return row.*member; };
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(of_row(rows[0]))>, double>) {
            store.column(path, rows, of_row, field.unit(), &field.range);
          } else {
            store.vectors(path, rows, of_row, field.unit(), &field.range);
          }
        },
        field.member);
  }
}

template <class Store, class Scene>
void traverse_actions(Store& store, Scene& scene) {
  auto& supports = scene.supports;
  store.words("supports/kind", supports, PLASTICA_MEMBER(kind), support_kinds());
  store.column("supports/at", supports, PLASTICA_MEMBER(at.fraction), "1");
  store.held("supports/held", supports);
  store.optional_places("supports/to", supports);
  traverse_fields(store, "supports", supports, support_fields());
  store.histories("supports/history", supports);

  auto& loads = scene.loads;
  store.column("loads/at", loads, PLASTICA_MEMBER(at.fraction), "1");
  store.optional_places("loads/to", loads);
  traverse_fields(store, "loads", loads, load_fields());
  store.column("loads/follows", loads, PLASTICA_MEMBER(follows), "");
  store.histories("loads/history", loads);

  auto& masses = scene.masses;
  if (store.has_rows("masses", masses)) {
    store.column("masses/at", masses, PLASTICA_MEMBER(at.fraction), "1");
    traverse_fields(store, "masses", masses, mass_fields());
  }

  store.numbers("gravity/acceleration", scene.gravity, "m/s^2");
  store.array("gravity/history_time", scene.gravity_history.time, {}, "s");
  store.array("gravity/history_factor", scene.gravity_history.factor,
              {scene.gravity_history.time.size()}, "1");
  store.slopes("gravity/history_slope", scene.gravity_history);
  store.goes_on("gravity/history_continues", scene.gravity_history);

  auto& motions = scene.initial_motions;
  store.column("initial_motions/from", motions, PLASTICA_MEMBER(from.fraction), "1");
  store.column("initial_motions/to", motions, PLASTICA_MEMBER(to.fraction), "1");
  traverse_fields(store, "initial_motions", motions, initial_motion_fields());
  store.column("initial_motions/about", motions, PLASTICA_MEMBER(about.fraction), "1");
  store.column("cuts/at", scene.cuts, PLASTICA_MEMBER(at.fraction), "1");
  store.column("cuts/time", scene.cuts, PLASTICA_MEMBER(time), "s");
}

/// What the table of fields does not have of the axis and of the path's control.
template <class Store, class Setup>
void traverse_rest_of_setup(Store& store, Setup& setup) {
  auto& beam = setup.scene.beam;
  store.array("options/beam/segment_fractions", beam.segment_fractions, {}, "1");
  store.array("options/beam/joint_lengths", beam.joint_lengths, {}, "m");
  store.numbers("options/beam/arc_towards", beam.arc_towards, "1");
  store.points("options/beam/points", beam.points, "m");
  store.optional_place("options/control/at", setup.solver.control_at);
  store.numbers("options/control/motion", setup.solver.control_motion, "m");
}

template <class Store, class Outline>
void traverse_outline(Store& store, Outline& outline) {
  store.array("beam/ends", outline.ends, {}, "1");
  const std::size_t joints = outline.ends.size();
  const std::size_t segments = joints == 0 ? 0 : joints - 1;
  store.array("beam/node", outline.node, {joints, 3}, "m");
  store.array("beam/axes", outline.axes, {segments, 3, 3}, "1");
  store.array("beam/joint_length", outline.joint_length, {joints}, "m");
  store.array("beam/width", outline.width, {segments}, "m");
  store.array("beam/height", outline.height, {segments}, "m");
  store.array("beam/round", outline.round, {segments}, "");
  store.array("beam/modulus", outline.modulus, {joints, 3}, "m^3");
  store.array("beam/strain_per_angle", outline.strain_per_angle, {joints, 3}, "1/rad");
}

template <class Store, class Chain>
void traverse_chain(Store& store, Chain& chain, std::size_t joints, std::size_t supports) {
  const std::size_t segments = joints == 0 ? 0 : joints - 1;
  store.array("path/time", chain.time, {}, "s");
  const std::size_t samples = chain.time.size();
  store.array("path/frame_sample", chain.frame_sample, {}, "");
  const std::size_t frames = chain.frame_sample.size();
  store.array("path/factor", chain.factor, {samples}, "1");
  store.array("path/iterations", chain.iterations, {samples}, "1");
  store.column("energy/elastic", chain.energy, PLASTICA_MEMBER(elastic), "J");
  store.column("energy/plastic", chain.energy, PLASTICA_MEMBER(plastic), "J");
  store.column("energy/external", chain.energy, PLASTICA_MEMBER(external), "J");
  store.column("energy/kinetic", chain.energy, PLASTICA_MEMBER(kinetic), "J");
  store.column("energy/damping", chain.energy, PLASTICA_MEMBER(damping), "J");
  store.column("energy/numerical_dissipation", chain.energy, PLASTICA_MEMBER(numerical_dissipation),
               "J");
  store.column("energy/impact", chain.energy, PLASTICA_MEMBER(impact), "J");
  store.column("energy/fracture", chain.energy, PLASTICA_MEMBER(fracture), "J");
  store.column("energy/residual", chain.energy, PLASTICA_MEMBER(residual), "J");
  store.array("joints/position", chain.position, {frames, joints, 3}, "m");
  store.array("joints/moment", chain.moment, {frames, joints, 3}, "N m");
  store.array("joints/force", chain.force, {frames, joints, 3}, "N");
  store.array("joints/angle", chain.angle, {frames, joints, 3}, "rad");
  store.array("joints/plastic_angle", chain.plastic_angle, {frames, joints, 3}, "rad");
  store.array("joints/plastic_strain", chain.plastic_strain, {frames, joints}, "1");
  store.array("joints/stress", chain.stress, {frames, joints}, "Pa");
  store.array("segments/rotation", chain.rotation, {frames, segments, 3}, "rad");
  store.array_since("segments/velocity", chain.velocity, {frames, segments, 3}, "m/s");
  store.array_since("segments/spin", chain.spin, {frames, segments, 3}, "rad/s");
  store.array("reactions/wrench", chain.reaction, {frames, supports, 6}, "");
}

template <class Store, class Response>
void traverse_outcome(Store& store, Response& response, std::size_t joints) {
  store.word("outcome/status", response.status, status_words());
  store.number("outcome/samples", response.samples, "1");
  store.number("outcome/permanent_strain", response.permanent_strain, "1");
  store.number("outcome/energy_balance_error", response.energy_balance_error, "1");
  store.number_since("outcome/momentum_error", response.momentum_error, "1");
  store.number_since("outcome/shortest_step", response.shortest_step, "s");
  store.number_since("outcome/longest_step", response.longest_step, "s");
  store.number("outcome/steps", response.counters.steps, "1");
  store.number("outcome/iterations", response.counters.iterations, "1");
  store.number("outcome/cutbacks", response.counters.cutbacks, "1");
  store.optional("limit_load", response.limit, [&](auto& limit) {
    store.number("limit_load/below", limit.below, "1");
    store.number("limit_load/above", limit.above, "1");
    store.array_since("limit_load/mode", limit.mode, {joints, 3}, "1");
  });
  store.optional("critical_points", response.critical, [&](auto& critical) {
    store.array("critical_points/factor", critical.factor, {}, "1");
    const std::size_t points = critical.factor.size();
    store.array("critical_points/below", critical.below, {points}, "1");
    store.array("critical_points/above", critical.above, {points}, "1");
    store.array("critical_points/unstable_modes", critical.unstable_modes, {points}, "1");
    store.array("critical_points/out_of_plane", critical.out_of_plane, {points}, "");
    store.array("critical_points/mode", critical.mode, {points, joints, 3}, "1");
  });
  store.optional("buckling", response.buckling, [&](auto& buckling) {
    store.number("buckling/about", buckling.about, "1");
    store.array("buckling/factor", buckling.factor, {}, "1");
    const std::size_t modes = buckling.factor.size();
    store.array("buckling/rotation", buckling.rotation, {modes}, "rad");
    store.array("buckling/out_of_plane", buckling.out_of_plane, {modes}, "");
    store.array("buckling/mode", buckling.mode, {modes, joints, 3}, "1");
  });
  store.optional("vibration", response.vibration, [&](auto& vibration) {
    store.array("vibration/frequency", vibration.frequency, {}, "Hz");
    store.array("vibration/mode", vibration.mode, {vibration.frequency.size(), joints, 3}, "1");
  });
  store.optional("coupon_break", response.event, [&](auto& event) {
    store.number("coupon_break/sample", event.sample, "1");
    store.number("coupon_break/strain", event.strain, "1");
    store.number("coupon_break/stress", event.stress, "Pa");
    store.number("coupon_break/permanent_strain", event.permanent_strain, "1");
    store.number("coupon_break/dissipation", event.dissipation, "J/m^3");
  });
}

/// What broke or was cut, and the fragments after that.
template <class Store, class Chain>
void traverse_events(Store& store, Chain& chain) {
  EventTable table = event_table(chain.events);
  store.array("events/time", table.time, {}, "s");
  store.array("events/factor", table.factor, {table.time.size()}, "1");
  auto& joints = table.joints;
  store.column("events/joints/event", joints, PLASTICA_MEMBER(event), "");
  store.column("events/joints/joint", joints, PLASTICA_MEMBER(broken.joint), "");
  store.words("events/joints/cause", joints, PLASTICA_MEMBER(broken.cause), kBreakCauses);
  store.column("events/joints/cut", joints, PLASTICA_MEMBER(broken.cut), "");
  store.column("events/joints/strain", joints, PLASTICA_MEMBER(broken.strain), "1");
  store.column("events/joints/limit", joints, PLASTICA_MEMBER(broken.limit), "1");
  store.vectors("events/joints/moment", joints, PLASTICA_MEMBER(broken.moment), "N m");
  store.vectors("events/joints/plastic_angle", joints, PLASTICA_MEMBER(broken.angle), "rad");
  store.column("events/joints/dissipation", joints, PLASTICA_MEMBER(broken.dissipation), "J");
  auto& fragments = table.fragments;
  store.column("events/fragments/event", fragments, PLASTICA_MEMBER(event), "");
  store.column("events/fragments/first", fragments, PLASTICA_MEMBER(fragment.first), "");
  store.column("events/fragments/last", fragments, PLASTICA_MEMBER(fragment.last), "");
  if constexpr (!std::is_const_v<Chain>) {
    store.check_events(table);
    chain.events = events_of(table);
  }
}

/// Visits all that a file holds but /options/setup, /regions, /inputs and /meta.
/// @tparam Store  writes or reads
template <class Store, class Record>
void traverse(Store& store, Record& record) {
  auto& scene = record.setup.scene;
  store.text("scene/name", scene.name);
  store.text("scene/material", scene.material.name);
  store.text("scene/section", scene.section.name);
  store.word("scene/level", record.level, choices_of("solver.level"));
  store.text("scene/level_reason", record.level_reason);
  store.texts("scene/warnings", record.warnings);
  store.array("drive/strain", scene.drive.strain, {}, "1");
  traverse_actions(store, scene);
  traverse_rest_of_setup(store, record.setup);
  traverse_outline(store, record.outline);

  auto& probes = scene.probes;
  store.names("probes/name", probes);
  store.words("probes/kind", probes, PLASTICA_MEMBER(quantity), probe_kinds());
  store.column("probes/at", probes, PLASTICA_MEMBER(at.fraction), "1");
  store.words("probes/component", probes, PLASTICA_MEMBER(component), kComponents);
  store.words("probes/energy", probes, PLASTICA_MEMBER(energy), kEnergyKinds);
  store.probe_values(record);

  traverse_outcome(store, record.response, record.outline.ends.size());
  traverse_events(store, record.response.chain);
  traverse_chain(store, record.response.chain, record.outline.ends.size(), scene.supports.size());
}

#undef PLASTICA_MEMBER

}  // namespace plastica::io::scene_layout
