#include "plastica/chain/build.hpp"

#include "plastica/chain/builder.hpp"

namespace plastica::chain {

template <class L>
Build<L> build_chain(const Scene& scene, const Layout& layout, const View<L>& view,
                     const BuildOptions& options) {
  return Builder<L>(scene, layout, view, options).build();
}

#define PLASTICA_BUILD_CHAIN(L) \
  template Build<L> build_chain<L>(const Scene&, const Layout&, const View<L>&, const BuildOptions&)

PLASTICA_BUILD_CHAIN(Twist<double>);
PLASTICA_BUILD_CHAIN(Planar<double>);
PLASTICA_BUILD_CHAIN(Spatial<double>);
PLASTICA_BUILD_CHAIN(Twist<float>);
PLASTICA_BUILD_CHAIN(Planar<float>);
PLASTICA_BUILD_CHAIN(Spatial<float>);

}  // namespace plastica::chain
