#include "plastica/run/fibre_warning.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/law/fibre_layout.hpp"
#include "plastica/model/check_value.hpp"

namespace plastica::run_detail {
namespace {

/// Moments up to so many times that of first yield go without a word.
constexpr double kLate = 1.1;

/// The moment at which the outermost fibre yields, over that at which the surface does.
double late_by(const Section& section, const SectionProperties& properties, bool about_x,
               int fibres) {
  const law::FibreLayout layout = law::fibre_layout(
      section, properties, about_x ? law::FibrePlane::AboutX : law::FibrePlane::AboutY, fibres);
  double outermost = 0.0;
  for (const double depth : layout.depth) outermost = std::max(outermost, std::fabs(depth));
  const double elastic = about_x ? properties.section_modulus_x : properties.section_modulus_y;
  const double second = about_x ? properties.second_moment_x : properties.second_moment_y;
  return second / elastic / outermost;
}

}  // namespace

std::optional<std::string> fibre_warning(const Facts& facts) {
  if (facts.scene.yield_model != YieldModel::Fibre) return std::nullopt;
  const int fibres = facts.options.fibres;
  double late = 1.0;
  for (const auto& region : facts.layout.regions) {
    for (const bool about_x : {true, false}) {
      if (about_x ? !bends_about_x(facts.level) : !bends_about_y(facts.level)) continue;
      late = std::max(late, late_by(region.section, region.properties, about_x, fibres));
    }
  }
  if (late < kLate) return std::nullopt;
  using model_detail::figure;
  return "solver.fibres = " + std::to_string(fibres) + ": the outermost fibres yield at " +
         figure(late) +
         " times the moment of first yield; what less leaves is missed (40 fibres: 1.02)";
}

}  // namespace plastica::run_detail
