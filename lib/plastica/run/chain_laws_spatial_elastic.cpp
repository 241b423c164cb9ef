#include "plastica/run/chain_laws_make.hpp"

namespace plastica {

using ChainLevel = chain::Spatial<double>;
template std::unique_ptr<chain::SectionJointsBase<ChainLevel, true>> make_joints<ChainLevel, true>(
    const Scene&, const std::vector<chain::BeamPart>&, const std::vector<MaterialValues<double>>&,
    std::vector<chain::SectionJoint<ChainLevel>>, const chain::View<ChainLevel>&, int);

}  // namespace plastica
