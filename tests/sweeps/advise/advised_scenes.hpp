#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "plastica/io/scene_file.hpp"
#include "plastica/model/section.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/advise/advice.hpp"

namespace plastica::sweeps {

inline AdviceOptions asked(double within) {
  AdviceOptions options;
  options.within = within;
  return options;
}

/// A cantilever of S355, 1 m long and of a square section, under a force at its tip, whose
/// displacement is probed.
/// @param height  of the section [m]
/// @param rest    more of the file
inline Setup tip_cantilever(double height, const std::string& force,
                            const std::string& rules = "yield_model = 'elastic'",
                            const std::string& solver = "steps = 1", char component = 'y') {
  const std::string size = "'" + std::to_string(height) + " m'";
  return io::parse_scene_file(
             "material = 'S355'\n[beam]\nlength = '1 m'\nsegments = 16\n"
             "section = { shape = 'rectangle', width = " +
                 size + ", height = " + size +
                 " }\n"
                 "[rules]\n" +
                 rules + "\n[solver]\n" + solver +
                 "\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
                 "[[load]]\nat = 'end'\nforce = " +
                 force +
                 "\n[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = '" +
                 component + "'\n",
             "cantilever.toml")
      .setup;
}

/// Of the deflection of a cantilever under a tip force, over that of bending: 3 E I/(k G A L^2).
inline double shear_ratio(const Setup& setup) {
  const Material& material = setup.scene.material;
  const SectionProperties s = section_properties(setup.scene.section, material.poisson_ratio);
  const double shear_modulus = material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
  return 3.0 * material.youngs_modulus * s.second_moment_x /
         (s.shear_coefficient_y * shear_modulus * s.area * std::pow(setup.scene.beam.length, 2.0));
}

/// Of its tip, by bending alone: P L^3/(3 E I) [m].
inline double bending_deflection(const Setup& setup, double force) {
  const Material& material = setup.scene.material;
  const SectionProperties s = section_properties(setup.scene.section, material.poisson_ratio);
  return force * std::pow(setup.scene.beam.length, 3.0) /
         (3.0 * material.youngs_modulus * s.second_moment_x);
}

/// Where the first probe of the advised scene ends.
inline double end_of(const Setup& setup, const Advice& advice) {
  const Setup at = advised_setup(setup, advice);
  return simulate(at.scene, at.solver).probes[0].back();
}

/// What an advice says of a word; its axis must be there.
struct ToldWord {
  std::string chosen;
  WordLine line;
  const WordAxis* axis = nullptr;

  /// The other word of this text; null: it was not run.
  const OtherWord* other(const std::string& text) const {
    for (const OtherWord& one : line.others) {
      if (axis->choices[one.choice].text() == text) return &one;
    }
    return nullptr;
  }
};

/// Empty word: the scene has no choice there.
inline ToldWord told_of(const Advice& advice, std::string_view path) {
  for (std::size_t w = 0; w < advice.word_axes.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    if (axis.field().path != path) continue;
    return {axis.choices[advice.words[w]].text(),
            advice.word_budget.empty() ? WordLine{} : advice.word_budget[w], &axis};
  }
  return {};
}

}  // namespace plastica::sweeps
