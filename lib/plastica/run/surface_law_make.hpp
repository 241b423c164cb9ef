#pragma once

#include "plastica/law/gauge_form.hpp"
#include "plastica/run/surface_law.hpp"

/// Defines `make_yield_surface`; for the files that instantiate it, a hardening law each.
namespace plastica {
namespace detail {

template <class S, class Section>
class SurfaceOf final : public YieldSurface<S> {
 public:
  using State = typename YieldSurface<S>::State;

  explicit SurfaceOf(const Section& section) : section_(section) {}

  law::SectionResponse<S> respond(const State& before, State& after,
                                  const law::SectionStrain<S>& strain) const override {
    typename Section::State now;
    const auto response = law::respond(section_, typename Section::State(before), now, strain);
    after = State(now);
    return response;
  }

  void set_time(double seconds) override { law::set_time(section_, seconds); }

 private:
  Section section_;
};

}  // namespace detail

template <class Uniaxial, class S>
std::shared_ptr<YieldSurface<S>> make_yield_surface(const law::GaugeForm& gauge,
                                                    const law::SectionForm& form,
                                                    const MaterialValues<S>& material,
                                                    std::optional<std::size_t> bending) {
  std::shared_ptr<YieldSurface<S>> made;
  law::with_gauge<S>(gauge, [&]<class Gauge>(const Gauge& surface) {
    auto section = law::interaction_section<Uniaxial>(form, surface, material);
    if (bending) {
      auto& compliance = section.compliance;
      compliance[law::kBendingX] = compliance[law::kBendingY] = compliance[*bending];
    }
    made = std::make_shared<detail::SurfaceOf<S, law::InteractionSection<S, Gauge, Uniaxial>>>(
        section);
  });
  return made;
}

/// Instantiates it for a hardening law with numbers of a type.
#define PLASTICA_YIELD_SURFACES(S, ...)                                         \
  template std::shared_ptr<YieldSurface<S>> make_yield_surface<__VA_ARGS__, S>( \
      const law::GaugeForm&, const law::SectionForm&, const MaterialValues<S>&, \
      std::optional<std::size_t>)

}  // namespace plastica
