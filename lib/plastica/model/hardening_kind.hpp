#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "plastica/model/field.hpp"
#include "plastica/model/material_field.hpp"

/// What a hardening law is to scenes, said once for each law, in a file of its own. How it responds
/// is in law/, by the same name.
namespace plastica {

/// What the strain does where one joint of several yields first.
enum class HardeningGrowth {
  None,       ///< the stress stays: all goes on in that joint
  Saturates,  ///< the stress grows to an end
  Goes,       ///< the stress grows for ever
};

/// A parameter of a law that does not fit the others.
struct BrokenRule {
  MaterialField field{};
  std::string rule;  ///< "must be below material.youngs_modulus = 2.1e+11"
};

class HardeningKind {
 public:
  virtual ~HardeningKind() = default;

  virtual HardeningLaw law() const = 0;
  /// The word for it in files.
  virtual std::string_view word() const = 0;
  /// What it is, in a few words: "linear hardening".
  virtual std::string_view phrase() const = 0;
  /// Its parameters, as files name them. Laws may share some.
  virtual std::span<const Field> parameters() const = 0;

  /// What of the numbers, each of which is within its field's range, does not fit together.
  virtual std::optional<BrokenRule> broken_rule(const MaterialValues<double>& values) const = 0;
  virtual HardeningGrowth growth(const Hardening& hardening) const = 0;
  /// Whether the stress of a tension test falls anywhere.
  virtual bool softens(const Material& /*material*/) const { return false; }
  /// Stress of a tension test that goes one way [Pa].
  /// @param plastic_strain  [1], >= 0
  virtual double monotonic_stress(double plastic_strain, const Material& material) const = 0;
};

std::span<const HardeningKind* const> hardening_kinds();
/// @throws InputError if there is no such law
const HardeningKind& hardening_kind(HardeningLaw law);

}  // namespace plastica
