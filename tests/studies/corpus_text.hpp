#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

/// Pieces of scene files, put together as a user would write them.
namespace plastica::studies {

inline constexpr std::string_view kStart = "\"start\"";
inline constexpr std::string_view kEnd = "\"end\"";

/// A steel whose numbers the closed forms take.
struct CorpusMetal {
  double youngs_modulus = 200e9;  ///< [Pa]
  double poisson_ratio = 0.3;
  double yield_stress = 250e6;  ///< [Pa]
  double density = 7850.0;      ///< [kg/m^3]
  std::string more{};           ///< further keys of [material]

  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }
};

inline std::string metal(const CorpusMetal& of) {
  return fmt::format(
      "[material]\nyoungs_modulus = \"{} Pa\"\npoisson_ratio = {}\nyield_stress = \"{} Pa\"\n"
      "density = \"{} kg/m^3\"\n{}\n",
      of.youngs_modulus, of.poisson_ratio, of.yield_stress, of.density, of.more);
}

/// @param more  further keys of [beam]
inline std::string beam(double length, std::string_view section, std::string_view more = "") {
  return fmt::format("[beam]\nlength = \"{} m\"\nsection = {{ {} }}\nsegments = 32\n{}\n", length,
                     section, more);
}

inline std::string rectangle(double width, double height) {
  return fmt::format("shape = \"rectangle\", width = \"{} m\", height = \"{} m\"", width, height);
}

inline std::string circle(double radius) {
  return fmt::format("shape = \"circle\", radius = \"{} m\"", radius);
}

/// @param more  further keys of [rules]
inline std::string rules(std::string_view yield_model, std::string_view more = "") {
  return fmt::format("[rules]\nyield_model = \"{}\"\n{}\n", yield_model, more);
}

/// @param more  further keys of [solver]
inline std::string at_rest(int steps, std::string_view more = "") {
  return fmt::format("[solver]\nsteps = {}\n{}\n", steps, more);
}

/// @param more  further keys of [solver]
inline std::string in_motion(double duration, int steps, std::string_view more = "") {
  return fmt::format(
      "[solver]\nanalysis = \"dynamics\"\nduration = \"{} s\"\nsteps = {}\nframes = 1\n"
      "time_step = \"1 ms\"\n{}\n",
      duration, steps, more);
}

/// @param place  `"start"`, `"end"` or a fraction, as a file has it
inline std::string support(std::string_view place, std::string_view kind,
                           std::string_view more = "") {
  return fmt::format("[[support]]\nat = {}\nkind = \"{}\"\n{}\n", place, kind, more);
}

inline std::string clamp() { return support(kStart, "clamp"); }

inline std::string vector_text(double x, double y, double z, std::string_view unit) {
  return fmt::format("[\"{} {}\", \"{} {}\", \"{} {}\"]", x, unit, y, unit, z, unit);
}

inline std::string force(std::string_view place, double x, double y, double z,
                         std::string_view more = "") {
  return fmt::format("[[load]]\nat = {}\nforce = {}\n{}\n", place, vector_text(x, y, z, "N"), more);
}

inline std::string moment(std::string_view place, double x, double y, double z,
                          std::string_view more = "") {
  return fmt::format("[[load]]\nat = {}\nmoment = {}\n{}\n", place, vector_text(x, y, z, "N m"),
                     more);
}

/// Over the whole beam, across it.
inline std::string even_load(double y) {
  return fmt::format("[[load]]\nat = \"start\"\nto = \"end\"\nforce = {}\n\n",
                     vector_text(0.0, y, 0.0, "N/m"));
}

inline std::string probe(std::string_view name, std::string_view kind, std::string_view place,
                         std::string_view component) {
  return fmt::format("[[probe]]\nname = \"{}\"\nkind = \"{}\"\nat = {}\ncomponent = \"{}\"\n\n",
                     name, kind, place, component);
}

/// The probe that most scenes have.
inline std::string tip(std::string_view component = "y") {
  return probe("tip", "displacement", kEnd, component);
}

}  // namespace plastica::studies
