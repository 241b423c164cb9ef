#include "plastica/io/scene_digest.hpp"

#include <variant>

#include "plastica/base/renamed.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/model/field.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::io {
namespace {

class Feeder {
 public:
  std::uint64_t value() const { return digest_.value(); }

  void put(double value) { digest_.real(value); }
  void put(bool value) { digest_.integer(value ? 1 : 0); }
  void put(int value) { digest_.integer(static_cast<std::uint64_t>(value)); }
  void put(const std::string& text) { digest_.text(text); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put(Enum value) { digest_.integer(static_cast<std::uint64_t>(value)); }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    digest_.integer(values.size());
    for (const T& value : values) put(value);
  }

  void put(const Place& place) { all(place.fraction, place.segment); }
  void put(const History& history) {
    all(history.time, history.factor, history.continues, history.slope);
  }
  void put(const Hardening& h) {
    Setup setup;
    setup.scene.material.hardening = h;
    put(h.law);
    // Of all laws: a fit may choose another one.
    for (const HardeningKind* kind : hardening_kinds()) {
      for (const Field& field : kind->parameters()) put(field.get(setup));
    }
  }
  void put(const Material& m) {
    all(m.youngs_modulus, m.poisson_ratio, m.shear_modulus, m.density, m.yield_stress,
        m.shear_yield_stress, m.break_strain, m.break_shear_strain, m.hardening, m.rate.law,
        m.rate.reference_rate, m.rate.exponent, m.rate.coefficient, m.rate.strain_rate);
  }
  void put(const Section& s) {
    Setup setup;
    setup.scene.section = s;
    put(s.shape);
    for (const Field& field : section_kind(s).dimensions()) put(field.get(setup));
    put(s.shear_coefficient);
  }
  void put(const Region& region) {
    all(region.from, region.to, region.section, region.material, region.to_section, region.own);
  }
  void put(const Support& s) {
    all(s.at, s.to, s.kind, s.hold);
    fields(s, support_fields());
    put(s.history);
  }
  void put(const Load& load) {
    all(load.at, load.to);
    fields(load, load_fields());
    all(load.follows, load.history);
  }
  void put(const PointMass& mass) {
    put(mass.at);
    fields(mass, mass_fields());
  }
  void put(const InitialMotion& m) {
    all(m.from, m.to);
    fields(m, initial_motion_fields());
    put(m.about);
  }
  void put(const Cut& cut) { all(cut.at, cut.time); }
  void put(const Probe& p) { all(p.name, p.quantity, p.at, p.component, p.energy); }
  void put(const Beam& beam) {
    all(beam.segment_fractions, beam.joint_lengths, beam.arc_towards, beam.points);
  }
  void put(const FieldValue& value) {
    digest_.integer(value.index());
    if (const auto* number = std::get_if<double>(&value)) put(*number);
    if (const auto* word = std::get_if<std::string>(&value)) put(*word);
  }

  template <class... T>
  void all(const T&... values) {
    (put(values), ...);
  }

 private:
  template <class Item, class Field>
  void fields(const Item& item, std::span<const Field> all) {
    for (const Field& field : all) {
      for (const double value : field.values(item)) put(value);
    }
  }

  Digest digest_;
};

}  // namespace

std::uint64_t scene_digest(const Setup& setup) {
  Feeder feeder;
  // Fields by their path, so that a field that joins the table later changes every digest. A field
  // that was renamed counts by its former path, so that journals stay usable.
  for (const Field& field : fields()) feeder.all(old_path(field.path), field.get(setup));
  const Scene& scene = setup.scene;
  feeder.all(scene.beam, scene.regions, scene.drive.strain, scene.supports, scene.loads,
             scene.gravity_history, scene.initial_motions, scene.cuts, scene.probes);
  feeder.all(setup.solver.control_at, setup.solver.control_motion);
  // Scenes without masses keep the digest of versions that had none.
  if (!scene.masses.empty()) feeder.put(scene.masses);
  return feeder.value();
}

}  // namespace plastica::io
