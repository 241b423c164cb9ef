#pragma once

#include <memory>
#include <vector>

#include "plastica/chain/joint_numbers.hpp"

namespace plastica {

/// Whether a level has one force per section, as twist does: then there is no interaction, for the
/// closest point of any yield surface is the clipped force. Other levels need the regions' yield
/// surfaces.
template <class L, bool kElastic>
inline constexpr bool kOneForce = L::kTranslations == 0 && !kElastic;

/// The joints of a chain with the law that its scene names; regions follow the same law with their
/// own numbers.
///
/// Instantiated for the levels with double (chain_laws_*.cpp) and float (chain_float*.cpp): each
/// combination of level, yield model, yield surface and hardening law is compiled by itself.
/// @param materials  numbers of each region (regions)
/// @param fibres     of a fibre section, along its depth
template <class L, bool kElastic>
std::unique_ptr<chain::SectionJointsBase<L, kElastic>> make_joints(
    const Scene& scene, const std::vector<chain::BeamRegion>& regions,
    const std::vector<MaterialValues<typename L::Scalar>>& materials,
    std::vector<chain::SectionJoint<L>> joints, const chain::View<L>& view, int fibres);

}  // namespace plastica
