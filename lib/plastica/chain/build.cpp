#include "plastica/chain/build.hpp"

#include "plastica/chain/builder.hpp"

namespace plastica::chain {

#define PLASTICA_BUILD_CHAIN(L) \
  template Build<L> build_chain<L>(const Scene&, const Layout&, const View<L>&, const BuildOptions&)

PLASTICA_BUILD_CHAIN(Twist<double>);
PLASTICA_BUILD_CHAIN(Planar<double>);
PLASTICA_BUILD_CHAIN(Spatial<double>);
PLASTICA_BUILD_CHAIN(Twist<float>);
PLASTICA_BUILD_CHAIN(Planar<float>);
PLASTICA_BUILD_CHAIN(Spatial<float>);

}  // namespace plastica::chain
