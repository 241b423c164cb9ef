#include "plastica/model/item_field.hpp"

#include "plastica/model/field_table.hpp"

namespace plastica {

using enum VectorSense;
using model_detail::kNotNegative;

std::span<const ItemField<Load>> load_fields() {
  static constexpr std::array<ItemField<Load>, 2> kFields{
      {{"force", &Load::force, Dimension::Force, Dimension::ForcePerLength, {}, "F_", Push},
       {"moment", &Load::moment, Dimension::Moment, Dimension::MomentPerLength, {}, "M_", Rotate}}};
  return kFields;
}

std::span<const ItemField<PointMass>> mass_fields() {
  static constexpr std::array<ItemField<PointMass>, 2> kFields{
      {{"mass", &PointMass::mass, Dimension::Mass, {}, kNotNegative},
       {"inertia", &PointMass::inertia, Dimension::MomentOfInertia, {}, kNotNegative, "I_"}}};
  return kFields;
}

std::span<const ItemField<InitialMotion>> initial_motion_fields() {
  static constexpr std::array<ItemField<InitialMotion>, 2> kFields{
      {{"velocity", &InitialMotion::velocity, Dimension::Velocity, {}, {}, "v_", Push},
       {"spin", &InitialMotion::spin, Dimension::AngularVelocity, {}, {}, "w_", Rotate}}};
  return kFields;
}

}  // namespace plastica
