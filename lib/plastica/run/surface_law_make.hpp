#pragma once

#include "plastica/run/surface_law.hpp"

/// Defines `respond` of a SurfaceLaw; for the files that instantiate it, a hardening law each.
namespace plastica {

template <class Section>
law::SectionResponse<typename SurfaceLaw<Section>::S> respond(
    const SurfaceLaw<Section>& law, const typename Section::State& before,
    typename Section::State& after,
    const law::SectionStrain<typename SurfaceLaw<Section>::S>& strain) {
  return law::respond(law.section, before, after, strain);
}

namespace detail {

template <class Gauge, class Uniaxial>
using SurfaceSection = law::InteractionSection<double, Gauge, Uniaxial>;

}  // namespace detail

/// Instantiates it for one surface and one hardening law.
#define PLASTICA_SURFACE_LAW(Uniaxial, ...)                             \
  template law::SectionResponse<double> respond(                        \
      const SurfaceLaw<detail::SurfaceSection<__VA_ARGS__, Uniaxial>>&, \
      const detail::SurfaceSection<__VA_ARGS__, Uniaxial>::State&,      \
      detail::SurfaceSection<__VA_ARGS__, Uniaxial>::State&, const law::SectionStrain<double>&)

/// The same for every surface of `law::with_gauge`.
#define PLASTICA_SURFACE_LAWS(Uniaxial)                                                       \
  PLASTICA_SURFACE_LAW(Uniaxial, law::FirstYieldGauge<double, law::kPerimeterPoints, false>); \
  PLASTICA_SURFACE_LAW(Uniaxial, law::FirstYieldGauge<double, 1, false>);                     \
  PLASTICA_SURFACE_LAW(Uniaxial, law::FirstYieldGauge<double, 1, true>);                      \
  PLASTICA_SURFACE_LAW(Uniaxial, law::PlasticGauge<double>);                                  \
  PLASTICA_SURFACE_LAW(Uniaxial, law::PlasticCurveGauge<double>)

}  // namespace plastica
