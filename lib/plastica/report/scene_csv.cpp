#include "plastica/report/scene_csv.hpp"

#include <ostream>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_spectrum.hpp"

namespace plastica::report {
namespace {

void refuse_coupon(const io::SceneRecord& record, std::string_view what) {
  if (record.level == Level::Coupon) {
    throw InputError({}, "--what", std::string(what), "is not of a coupon, which has none");
  }
}

/// Headers of the probes, each behind a comma.
std::string probe_headers(const io::SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  std::string headers;
  for (const Probe& probe : scene.probes) {
    headers +=
        ',' + csv_cell(fmt::format("{} [{}]", probe.name,
                                   si_unit(dimension_of(probe.quantity, scene.drive.deformation))));
  }
  return headers;
}

}  // namespace

void write_probes_csv(std::ostream& out, const io::SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  const bool coupon = record.level == Level::Coupon;
  out << (coupon ? "sample,drive [1]" : "sample,time [s],factor [1]");
  out << probe_headers(record) << '\n';
  const ChainHistory& chain = record.response.chain;
  for (std::size_t i = 0; i < record.response.samples; ++i) {
    out << (coupon ? fmt::format("{},{}", i, scene.drive.strain[i])
                   : fmt::format("{},{},{}", i, chain.time[i], chain.factor[i]));
    for (const auto& values : record.response.probes) out << fmt::format(",{}", values[i]);
    out << '\n';
  }
}

void write_joints_csv(std::ostream& out, const io::SceneRecord& record,
                      std::optional<double> time) {
  const ChainHistory& chain = record.response.chain;
  refuse_coupon(record, "joints");
  out << "joint,fraction of length [1],x [m],y [m],z [m],moment x [N m],moment y [N m],"
         "torque z [N m],shear x [N],shear y [N],axial z [N],angle x [rad],angle y [rad],"
         "angle z [rad],plastic angle x [rad],plastic angle y [rad],plastic angle z [rad],"
         "plastic strain [1],bending stress [Pa]\n";
  if (frames_of(record) == 0) return;
  check_time(record, "--time", time);
  const std::size_t frame = frame_at(record, time);
  for (std::size_t i = 0; i < chain.joints; ++i) {
    const std::size_t at = frame * chain.joints + i;
    out << fmt::format("{},{}", i, record.outline.ends[i]);
    for (const auto* values :
         {&chain.position, &chain.moment, &chain.force, &chain.angle, &chain.plastic_angle}) {
      for (std::size_t k = 0; k < 3; ++k) out << fmt::format(",{}", (*values)[3 * at + k]);
    }
    out << fmt::format(",{},{}\n", chain.plastic_strain[at], chain.stress[at]);
  }
}

void write_energies_csv(std::ostream& out, const io::SceneRecord& record) {
  refuse_coupon(record, "energies");
  const ChainHistory& chain = record.response.chain;
  out << "sample,time [s]";
  for (const EnergyEntry& entry : energy_entries()) out << fmt::format(",{} [J]", entry.name);
  out << ",residual [J]\n";
  for (std::size_t i = 0; i < chain.energy.size(); ++i) {
    out << fmt::format("{},{}", i, chain.time[i]);
    for (const EnergyEntry& entry : energy_entries()) {
      out << fmt::format(",{}", chain.energy[i].*entry.member);
    }
    out << fmt::format(",{}\n", chain.energy[i].residual);
  }
}

void write_events_csv(std::ostream& out, const io::SceneRecord& record) {
  refuse_coupon(record, "events");
  out << "event,time [s],factor [1],joint,fraction of length [1],cause,cut,strain [1],limit [1],"
         "moment x [N m],moment y [N m],torque z [N m],plastic angle x [rad],"
         "plastic angle y [rad],plastic angle z [rad],dissipation [J]\n";
  const std::vector<ChainBreak>& events = record.response.chain.events;
  for (std::size_t e = 0; e < events.size(); ++e) {
    for (const BrokenJoint& joint : events[e].joints) {
      out << fmt::format("{},{},{},{},{},{},{},{},{}", e, events[e].time, events[e].factor,
                         joint.joint, record.outline.ends[static_cast<std::size_t>(joint.joint)],
                         kBreakCauses[static_cast<std::size_t>(joint.cause)], joint.cut ? 1 : 0,
                         joint.strain, joint.limit);
      for (const double moment : joint.moment) out << fmt::format(",{}", moment);
      for (const double angle : joint.angle) out << fmt::format(",{}", angle);
      out << fmt::format(",{}\n", joint.dissipation);
    }
  }
}

void write_fragments_csv(std::ostream& out, const io::SceneRecord& record) {
  refuse_coupon(record, "fragments");
  out << "event,time [s],first segment,last segment,from [1],to [1]\n";
  const std::vector<ChainBreak>& events = record.response.chain.events;
  for (std::size_t e = 0; e < events.size(); ++e) {
    for (const Fragment& fragment : events[e].fragments) {
      out << fmt::format("{},{},{},{},{},{}\n", e, events[e].time, fragment.first, fragment.last,
                         record.outline.ends[static_cast<std::size_t>(fragment.first)],
                         record.outline.ends[static_cast<std::size_t>(fragment.last) + 1]);
    }
  }
}

void write_spectrum_csv(std::ostream& out, const io::SceneRecord& record) {
  if (!has_spectra(record)) {
    throw InputError(
        {}, "--what", "spectrum",
        fmt::format("needs a motion of at least {} samples at even times", theory::kFewestSamples));
  }
  std::vector<theory::Spectrum> spectra;
  for (std::size_t p = 0; p < record.setup.scene.probes.size(); ++p) {
    spectra.push_back(spectrum_of(record, p));
  }
  out << "frequency [Hz]" << probe_headers(record) << '\n';
  if (spectra.empty()) return;
  for (std::size_t k = 0; k < spectra.front().frequency.size(); ++k) {
    out << fmt::format("{}", spectra.front().frequency[k]);
    for (const theory::Spectrum& spectrum : spectra) {
      out << fmt::format(",{}", spectrum.amplitude[k]);
    }
    out << '\n';
  }
}

}  // namespace plastica::report
