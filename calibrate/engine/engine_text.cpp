#include "calibrate/engine/engine_text.hpp"

#include <array>

#include <fmt/format.h>

#include "calibrate/engine/hinge_numbers.hpp"
#include "calibrate/engine/writers.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {

std::span<const std::string_view> engine_formats() {
  static constexpr std::array<std::string_view, 6> kWords{"csv",    "mjcf",   "agx",
                                                          "bullet", "chrono", "opensees"};
  return kWords;
}

namespace {

/// A bar of OpenSees has its mass evenly.
std::string of_even_segments(const EngineBeam& beam) {
  if (!beam.carries_masses) return opensees_text(beam);
  throw InputError({}, "mass", "",
                   "does not go with opensees, whose segments have their mass evenly: csv, mjcf, "
                   "agx, bullet and chrono take point masses");
}

}  // namespace

std::vector<std::string> engine_notes(const EngineBeam& beam, EngineFormat format) {
  std::vector<std::string> notes = beam.notes;
  if (format == EngineFormat::Mjcf) {
    notes.push_back(mjcf_step_note(beam));
  } else if (format == EngineFormat::Bullet) {
    notes.push_back(bullet_step_note(beam));
  } else if (format == EngineFormat::Chrono) {
    notes.push_back(chrono_step_note(beam));
  } else if (beam.damping_time) {
    notes.push_back(
        fmt::format("the damping of the scene's joints, {:g} s, is left out", *beam.damping_time));
  }
  if (format == EngineFormat::Mjcf && beam.segments.size() > kMujocoSegments) {
    notes.push_back(fmt::format(
        "MuJoCo 2 reads no more than 100 elements inside of each other, so {} segments at most: "
        "this beam has {}",
        kMujocoSegments, beam.segments.size()));
  }
  return notes;
}

std::string engine_text(const EngineBeam& plain, EngineFormat format) {
  EngineBeam beam = plain;
  beam.notes = engine_notes(plain, format);
  switch (format) {
    case EngineFormat::Csv: break;
    case EngineFormat::Mjcf: return mjcf_text(beam);
    case EngineFormat::Agx: return agx_text(beam);
    case EngineFormat::Bullet: return bullet_text(beam);
    case EngineFormat::Chrono: return chrono_text(beam);
    case EngineFormat::OpenSees: return of_even_segments(beam);
  }
  return csv_text(beam);
}

}  // namespace plastica::calibrate
