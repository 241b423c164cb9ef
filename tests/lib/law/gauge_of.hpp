#pragma once

#include <string>
#include <vector>

#include "plastica/law/gauge_form.hpp"
#include "tests/lib/law/section_of.hpp"

namespace plastica::law::testing {

/// A section with one of the yield surfaces.
struct SurfaceCase {
  std::string name;
  Section section;
  YieldModel model = YieldModel::Interaction;
  YieldCap cap = YieldCap::FirstYield;
};

/// One case of each kind of surface, and the tubes.
inline std::vector<SurfaceCase> surface_cases() {
  const Section circle{.shape = SectionShape::Circle};
  const Section round_tube{.shape = SectionShape::RoundTube};
  const Section box{.shape = SectionShape::RectangularTube};
  return {{"rectangle", upright()},
          {"corner", upright(), YieldModel::Conservative},
          {"round", circle},
          {"plastic rectangle", upright(), YieldModel::Interaction, YieldCap::FullyPlastic},
          {"plastic circle", circle, YieldModel::Interaction, YieldCap::FullyPlastic},
          {"plastic round tube", round_tube, YieldModel::Interaction, YieldCap::FullyPlastic},
          {"plastic box", box, YieldModel::Interaction, YieldCap::FullyPlastic}};
}

inline GaugeForm gauge_form_of(const SurfaceCase& surface) {
  return gauge_form(surface.section, surface.model, surface.cap, Formulas::Mechanics);
}

/// phi of plain numbers.
inline double gauge_at(const GaugeForm& form, const SectionForce<double>& z) {
  double phi = 0.0;
  with_gauge<double>(form, [&](const auto& gauge) { phi = gauge_value(gauge, z); });
  return phi;
}

}  // namespace plastica::law::testing
