#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/problem/parameter.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/check.hpp"
#include "plastica/model/material.hpp"

namespace plastica::calibrate {

/// The laws that a fit can choose among, in the order in which they are offered.
enum class Law {
  Ideal,        ///< nothing beyond the yield stress
  Linear,       ///< tangent modulus; of cyclic curves the kinematic fraction, too
  Voce,         ///< Q and b of isotropic hardening that saturates
  Chaboche,     ///< Voce and two back-stresses: C and gamma of each
  Multilinear,  ///< the scene's table; its stresses where they are parameters
};

/// "ideal", "linear", "voce", "chaboche", "multilinear"; empty beyond the last.
std::string_view name_of(Law law);
/// All of them.
std::span<const std::string_view> law_names();
/// "ideal plasticity", "linear hardening", …
std::string_view phrase_of(Law law);

/// The laws of a list of words, each once, in their order.
/// @throws InputError for a word that is none, naming those that are, and for one that comes twice
std::vector<Law> laws_of(std::span<const std::string> words, std::string_view key,
                         const SourceLocation& where = {});

/// Which law a material has; with Voce's parameters alone that is Voce.
/// @param parameters  of the fit: a back-stress that is one of them is there
Law law_of(const Hardening& hardening, std::span<const Parameter> parameters);

/// The parameters of a fit that compares laws: those given, then what the laws free by themselves.
std::vector<Parameter> parameters_of(std::span<const Law> laws, std::vector<Parameter> given);

/// Those of them that one law has. Hardening parameters of other laws are left out; so is, of a
/// monotonic curve, a kinematic fraction that was not given, because it has no effect there.
/// @param all  as `parameters_of` gives them
/// @param given  of the fit
std::vector<Parameter> parameters_of(Law law, Loading loading, std::span<const Parameter> all,
                                     std::span<const Parameter> given);

/// Refuses parameters of hardening and rate laws that no law of the fit has, which would move
/// nothing, and a comparison with multilinear hardening without a table.
/// @param laws  that are compared; empty: that of `material` alone
/// @throws InputError naming the parameter
void check_law_parameters(std::span<const Parameter> parameters, const Material& material,
                          std::span<const Law> laws);

/// A material's hardening, turned into a law: back-stresses that the law does not have are taken
/// off.
Hardening hardening_of(Law law, const Hardening& given);

/// Where, between two bounds, a hardening parameter has the least effect: a stress or modulus at
/// the lower one, the rate of a back-stress, which caps it, at the upper one, that of Voce at the
/// lower one. Empty for others.
std::optional<double> min_effect_value(const Parameter& parameter, double lower, double upper);

/// Whether a law can do all that another one does: all contain ideal plasticity, Chaboche Voce.
bool contains(Law law, Law simpler);

/// The simpler law that a law contains. @return false for ideal plasticity, which contains none
bool has_simpler(Law law, Law& simpler);

/// The laws worth a trial where one does not describe a curve, itself among them: "ideal,linear,
/// voce". Empty where none is left.
/// @param tried  laws that the fit compares anyway
std::string laws_to_try(Law law, Loading loading, std::span<const Law> tried);

}  // namespace plastica::calibrate
