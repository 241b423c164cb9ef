#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "plastica/law/interaction.hpp"

/// The laws with one yield surface, compiled once for all levels: each of the five surfaces has its
/// return with each of the hardening laws, and they are one type to joints.
namespace plastica {

/// A law::InteractionSection, whatever its surface and its hardening law.
template <class S>
class YieldSurface {
 public:
  using State = law::InteractionState<S, law::kMaxBacks>;

  virtual ~YieldSurface() = default;
  /// See law::respond.
  virtual law::SectionResponse<S> respond(const State& before, State& after,
                                          const law::SectionStrain<S>& strain) const = 0;
  /// The length of the step [s], of laws with a rate.
  virtual void set_time(double seconds) = 0;
};

/// @tparam Uniaxial  the hardening law; surface_law_*.cpp have all that there are
/// @param bending    of a level that bends in one plane: about which axis of the section. A round
///                   surface has the compliance of the resultant, here that of the plane.
template <class Uniaxial, class S>
std::shared_ptr<YieldSurface<S>> make_yield_surface(const law::GaugeForm& gauge,
                                                    const law::SectionForm& form,
                                                    const MaterialValues<S>& material,
                                                    std::optional<std::size_t> bending);

/// The same as the section law of joints. Copies share it.
template <class S>
struct SurfaceLaw {
  using State = typename YieldSurface<S>::State;
  static constexpr bool kSeesAxial = true;
  std::shared_ptr<YieldSurface<S>> surface;

  void set_time(double seconds) const { surface->set_time(seconds); }
};

template <class S>
law::SectionResponse<S> respond(const SurfaceLaw<S>& law,
                                const typename SurfaceLaw<S>::State& before,
                                typename SurfaceLaw<S>::State& after,
                                const law::SectionStrain<S>& strain) {
  return law.surface->respond(before, after, strain);
}

}  // namespace plastica
