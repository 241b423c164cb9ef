#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "plastica/law/fibre_grid.hpp"
#include "tests/lib/law/section_of.hpp"

namespace plastica::law::testing {

/// A fibre section with the states of one joint, whatever it sees.
template <class S, class Uniaxial>
class FibreJoint {
 public:
  FibreJoint(const Section& section, const Material& material, FibrePlane plane, int fibres)
      : FibreJoint(section, material, plane, fibres, values_of<S>(material)) {}
  FibreJoint(const Section& section, const Material& material, FibrePlane plane, int fibres,
             const MaterialValues<S>& values)
      : layout_(std::make_shared<const FibreLayout>(
            fibre_layout(section, section_properties(section, 0.3), plane, fibres))) {
    const SectionForm form = form_of(section, material);
    if (plane == FibrePlane::Both) {
      grid_ = fibre_grid<Uniaxial>(*layout_, form, values);
      grid_states_.resize(layout_->states());
    } else {
      layers_ = fibre_section<Uniaxial>(*layout_, form, values);
      layer_states_.resize(layout_->states());
    }
  }

  SectionResponse<S> operator()(const SectionStrain<S>& strain) {
    if (grid_) {
      const auto before = grid_states_;
      return respond(*grid_, before.data(), grid_states_.data(), strain);
    }
    return respond(*layers_, layer_states_.data(), layer_states_.data(), strain);
  }
  const FibreLayout& layout() const { return *layout_; }

 private:
  std::shared_ptr<const FibreLayout> layout_;  ///< to which the laws point
  std::optional<FibreSection<S, Uniaxial>> layers_;
  std::optional<FibreGrid<S, Uniaxial>> grid_;
  std::vector<typename FibreSection<S, Uniaxial>::State> layer_states_;
  std::vector<typename FibreGrid<S, Uniaxial>::State> grid_states_;
};

/// Whether a plane of fibres sees a component.
inline bool sees(FibrePlane plane, std::size_t axis) {
  switch (plane) {
    case FibrePlane::AboutX: return axis == kBendingX || axis == kAxial;
    case FibrePlane::AboutY: return axis == kBendingY || axis == kAxial;
    case FibrePlane::Torsion: return axis == kTorsion;
    case FibrePlane::Both: break;
  }
  return true;
}

}  // namespace plastica::law::testing
