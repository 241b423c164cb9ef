#include "plastica/run/chain_laws_make.hpp"

namespace plastica {

using ChainLevel = chain::Twist<double>;
template std::unique_ptr<chain::SectionJointsBase<ChainLevel, false>>
make_joints<ChainLevel, false>(const Scene&, const std::vector<chain::BeamPart>&,
                               const std::vector<MaterialValues<double>>&,
                               std::vector<chain::SectionJoint<ChainLevel>>,
                               const chain::View<ChainLevel>&, int);

}  // namespace plastica
