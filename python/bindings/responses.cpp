#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>

#include "plastica/base/status.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/response_view.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

using Size = py::ssize_t;

Size size_of(std::size_t size) { return static_cast<Size>(size); }

constexpr std::array<std::pair<const char*, double Energies::*>, 9> kEnergies{{
    {"elastic", &Energies::elastic},
    {"kinetic", &Energies::kinetic},
    {"plastic", &Energies::plastic},
    {"damping", &Energies::damping},
    {"numerical_dissipation", &Energies::numerical_dissipation},
    {"impact", &Energies::impact},
    {"fracture", &Energies::fracture},
    {"external", &Energies::external},
    {"residual", &Energies::residual},
}};

py::dict probes(const py::object& self) {
  const auto& view = self.cast<const ResponseView&>();
  const Response& response = *view.response;
  py::dict arrays;
  for (std::size_t p = 0; p < response.probes.size(); ++p) {
    arrays[py::str(view.probe_names[p])] =
        view_of(response.probes[p], {size_of(response.samples)}, self);
  }
  return arrays;
}

py::dict energies(const py::object& self) {
  const Response& response = *self.cast<const ResponseView&>().response;
  const auto& energy = response.chain.energy;
  py::dict arrays;
  if (energy.empty()) return arrays;
  for (const auto& [name, member] : kEnergies) {
    arrays[name] = view_of(&(energy.front().*member), {size_of(energy.size())},
                           {static_cast<Size>(sizeof(Energies))}, self);
  }
  return arrays;
}

/// What a chain records of each joint, segment or support, by frame. Without a frame where it does
/// not, as velocities of a path at rest.
template <class Count>
auto by_frame(std::vector<double> ChainHistory::*member, const Count& count, Size columns) {
  return [=](const py::object& self) {
    const ChainHistory& chain = self.cast<const ResponseView&>().response->chain;
    const std::vector<double>& values = chain.*member;
    const Size rows = size_of(count(chain));
    const bool recorded = rows == 0 || !values.empty();
    std::vector<Size> shape{recorded ? size_of(chain.frame_sample.size()) : 0, rows};
    if (columns > 0) shape.push_back(columns);
    return view_of(values, shape, self);
  };
}

template <class T>
auto by_sample(std::vector<T> ChainHistory::*member) {
  return [=](const py::object& self) {
    return view_of(self.cast<const ResponseView&>().response->chain.*member, self);
  };
}

template <class T>
auto number(T Response::*member) {
  return [=](const ResponseView& view) { return (*view.response).*member; };
}

py::array modes(const std::vector<double>& mode, std::size_t count, py::handle owner) {
  const Size joints = count == 0 ? 0 : size_of(mode.size() / (3 * count));
  return view_of(mode, {size_of(count), joints, 3}, owner);
}

/// Critical points, limit load, buckling and vibration: what a path has found, as a dictionary
/// each.
py::object found(const py::object& self, const std::string& what) {
  const Response& response = *self.cast<const ResponseView&>().response;
  py::dict said;
  if (what == "limit" && response.limit) {
    said["below"] = response.limit->below;
    said["above"] = response.limit->above;
    said["mode"] = modes(response.limit->mode, response.limit->mode.empty() ? 0 : 1, self);
  } else if (what == "critical" && response.critical) {
    const CriticalPoints& points = *response.critical;
    said["factor"] = view_of(points.factor, self);
    said["below"] = view_of(points.below, self);
    said["above"] = view_of(points.above, self);
    said["unstable_modes"] = view_of(points.unstable_modes, self);
    said["out_of_plane"] = view_of(points.out_of_plane, self);
    said["mode"] = modes(points.mode, points.factor.size(), self);
  } else if (what == "buckling" && response.buckling) {
    const BucklingModes& buckling = *response.buckling;
    said["about"] = buckling.about;
    said["factor"] = view_of(buckling.factor, self);
    said["rotation"] = view_of(buckling.rotation, self);
    said["out_of_plane"] = view_of(buckling.out_of_plane, self);
    said["mode"] = modes(buckling.mode, buckling.factor.size(), self);
  } else if (what == "vibration" && response.vibration) {
    said["frequency"] = view_of(response.vibration->frequency, self);
    said["mode"] = modes(response.vibration->mode, response.vibration->frequency.size(), self);
  } else {
    return py::none();
  }
  return said;
}

void bind_events(py::module_& core) {
  py::class_<BreakEvent>(core, "BreakEvent")
      .def_readonly("sample", &BreakEvent::sample)
      .def_readonly("strain", &BreakEvent::strain)
      .def_readonly("stress", &BreakEvent::stress)
      .def_readonly("permanent_strain", &BreakEvent::permanent_strain)
      .def_readonly("dissipation", &BreakEvent::dissipation)
      .def(py::pickle(
          [](const BreakEvent& event) {
            return py::make_tuple(event.sample, event.strain, event.stress, event.permanent_strain,
                                  event.dissipation);
          },
          [](const py::tuple& state) {
            return BreakEvent{state[0].cast<std::size_t>(), state[1].cast<double>(),
                              state[2].cast<double>(), state[3].cast<double>(),
                              state[4].cast<double>()};
          }));
  py::class_<BrokenJoint>(core, "BrokenJoint")
      .def_readonly("joint", &BrokenJoint::joint)
      .def_property_readonly("cause",
                             [](const BrokenJoint& joint) {
                               return kBreakCauses[static_cast<std::size_t>(joint.cause)];
                             })
      .def_readonly("cut", &BrokenJoint::cut)
      .def_readonly("strain", &BrokenJoint::strain)
      .def_readonly("limit", &BrokenJoint::limit)
      .def_readonly("moment", &BrokenJoint::moment)
      .def_readonly("angle", &BrokenJoint::angle)
      .def_readonly("dissipation", &BrokenJoint::dissipation)
      .def(py::pickle(
          [](const BrokenJoint& joint) {
            return py::make_tuple(joint.joint, static_cast<int>(joint.cause), joint.cut,
                                  joint.strain, joint.limit, joint.moment, joint.angle,
                                  joint.dissipation);
          },
          [](const py::tuple& state) {
            return BrokenJoint{state[0].cast<int>(),
                               static_cast<BreakCause>(state[1].cast<int>()),
                               state[2].cast<bool>(),
                               state[3].cast<double>(),
                               state[4].cast<double>(),
                               state[5].cast<std::array<double, 3>>(),
                               state[6].cast<std::array<double, 3>>(),
                               state[7].cast<double>()};
          }));
  using Fragments = std::vector<std::pair<int, int>>;
  const auto fragments_of = [](const ChainBreak& event) {
    Fragments fragments;
    fragments.reserve(event.fragments.size());
    for (const Fragment& one : event.fragments) fragments.emplace_back(one.first, one.last);
    return fragments;
  };
  py::class_<ChainBreak>(core, "ChainBreak")
      .def_readonly("time", &ChainBreak::time)
      .def_readonly("factor", &ChainBreak::factor)
      .def_readonly("joints", &ChainBreak::joints)
      .def_property_readonly("fragments", fragments_of)
      .def(py::pickle(
          [fragments_of](const ChainBreak& event) {
            return py::make_tuple(event.time, event.factor, event.joints, fragments_of(event));
          },
          [](const py::tuple& state) {
            ChainBreak event{state[0].cast<double>(),
                             state[1].cast<double>(),
                             state[2].cast<std::vector<BrokenJoint>>(),
                             {}};
            for (const auto& [first, last] : state[3].cast<Fragments>()) {
              event.fragments.push_back({first, last});
            }
            return event;
          }));
}

}  // namespace

void bind_responses(py::module_& core) {
  bind_events(core);
  const auto joints = [](const ChainHistory& chain) { return chain.joints; };
  const auto segments = [](const ChainHistory& chain) {
    return chain.joints == 0 ? 0 : chain.joints - 1;
  };
  const auto supports = [](const ChainHistory& chain) { return chain.supports; };
  py::class_<ResponseView>(core, "ResponseView")
      .def_property_readonly(
          "status", [](const ResponseView& view) { return name_of(view.response->status); })
      .def_property_readonly("usable",
                             [](const ResponseView& view) { return usable(view.response->status); })
      .def_property_readonly("samples", number(&Response::samples))
      .def_property_readonly("probes", &probes)
      .def_property_readonly("strain",
                             [](const py::object& self) {
                               const auto& view = self.cast<const ResponseView&>();
                               const Size valid =
                                   size_of(view.drive.empty() ? 0 : view.response->samples);
                               return view_of(view.drive, {valid}, self);
                             })
      .def_property_readonly("permanent_strain", number(&Response::permanent_strain))
      .def_property_readonly("event", number(&Response::event))
      .def_property_readonly("events",
                             [](const ResponseView& view) { return view.response->chain.events; })
      .def_property_readonly("time", by_sample(&ChainHistory::time))
      .def_property_readonly("factor", by_sample(&ChainHistory::factor))
      .def_property_readonly("iterations", by_sample(&ChainHistory::iterations))
      .def_property_readonly("energies", &energies)
      .def_property_readonly("frame_sample", by_sample(&ChainHistory::frame_sample))
      .def_property_readonly("position", by_frame(&ChainHistory::position, joints, 3))
      .def_property_readonly("moment", by_frame(&ChainHistory::moment, joints, 3))
      .def_property_readonly("force", by_frame(&ChainHistory::force, joints, 3))
      .def_property_readonly("angle", by_frame(&ChainHistory::angle, joints, 3))
      .def_property_readonly("plastic_angle", by_frame(&ChainHistory::plastic_angle, joints, 3))
      .def_property_readonly("rotation", by_frame(&ChainHistory::rotation, segments, 3))
      .def_property_readonly("velocity", by_frame(&ChainHistory::velocity, segments, 3))
      .def_property_readonly("spin", by_frame(&ChainHistory::spin, segments, 3))
      .def_property_readonly("plastic_strain", by_frame(&ChainHistory::plastic_strain, joints, 0))
      .def_property_readonly("stress", by_frame(&ChainHistory::stress, joints, 0))
      .def_property_readonly("reaction", by_frame(&ChainHistory::reaction, supports, 6))
      .def_property_readonly("limit", [](const py::object& self) { return found(self, "limit"); })
      .def_property_readonly("critical",
                             [](const py::object& self) { return found(self, "critical"); })
      .def_property_readonly("buckling",
                             [](const py::object& self) { return found(self, "buckling"); })
      .def_property_readonly("vibration",
                             [](const py::object& self) { return found(self, "vibration"); })
      .def_property_readonly("steps",
                             [](const ResponseView& view) { return view.response->counters.steps; })
      .def_property_readonly(
          "newton_iterations",
          [](const ResponseView& view) { return view.response->counters.iterations; })
      .def_property_readonly(
          "cutbacks", [](const ResponseView& view) { return view.response->counters.cutbacks; })
      .def_property_readonly("energy_balance_error", number(&Response::energy_balance_error))
      .def_property_readonly("momentum_error", number(&Response::momentum_error))
      .def_property_readonly("seconds", number(&Response::seconds));
}

}  // namespace plastica::python
