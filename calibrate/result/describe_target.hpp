#pragma once

#include "calibrate/result/describe.hpp"

/// What is said of a measured curve, see describe.hpp.
namespace plastica::calibrate {

/// Of Characteristics.
inline constexpr auto kDescribeCharacteristics = [](auto& d) {
  d("youngs_modulus", "Pa", PLASTICA_MEMBER(youngs_modulus), "slope of the elastic line");
  d("youngs_modulus_standard_error", "Pa", PLASTICA_MEMBER(youngs_modulus_stderr),
    "of the regression");
  d("modulus_window_low", "Pa", PLASTICA_MEMBER(modulus_window_low),
    "stress where the line begins");
  d("modulus_window_high", "Pa", PLASTICA_MEMBER(modulus_window_high),
    "stress where the line ends");
  d("modulus_method", "", PLASTICA_MEMBER(modulus_method), "regression, chord or given");
  d("proof_offset", "1", PLASTICA_MEMBER(offset), "permanent strain of the proof stress");
  d("proof_stress", "Pa", PLASTICA_MEMBER(proof_stress), "proof stress at that offset");
  d("reh", "Pa", PLASTICA_MEMBER(reh), "upper yield strength");
  d("rel", "Pa", PLASTICA_MEMBER(rel), "lower yield strength");
  d("rm", "Pa", PLASTICA_MEMBER(rm), "largest stress");
  d("strain_at_rm", "1", PLASTICA_MEMBER(strain_at_rm), "total strain at the largest stress");
  d("break_strain", "1", PLASTICA_MEMBER(break_strain), "total strain at break");
  d("break_strain_plastic", "1", PLASTICA_MEMBER(break_strain_plastic),
    "permanent strain at break");
  d("largest_strain", "1", PLASTICA_MEMBER(largest_strain), "of the whole specimen");
  d.optional("broke", PLASTICA_MEMBER(observed_break), [](auto& inner) {
    inner("last_intact_strain", "1", PLASTICA_MEMBER(last_intact_strain),
          "largest strain that still carried load");
    inner("last_intact_stress", "Pa", PLASTICA_MEMBER(last_intact_stress), "stress there");
    inner("first_broken_strain", "1", PLASTICA_MEMBER(first_broken_strain),
          "strain of the first sample after the break, or a step on where that does not say it");
    inner("break_rule", "", PLASTICA_MEMBER(rule), "by which the break was found");
  });
};

/// Of a Target, beside its name and what it has lists of.
inline constexpr auto kDescribeSpecimen = [](auto& d) {
  d("file", "", PLASTICA_MEMBER(file), "of the measured curve");
  d("test", "", PLASTICA_MEMBER(test), "of the specimen");
  d("measure", "", PLASTICA_MEMBER(measure), "of stress and strain");
  d("loading", "", PLASTICA_MEMBER(loading), "monotonic or cyclic");
  d("target_status", "", PLASTICA_MEMBER(status), "whether the curve can be fitted");
  d("target_reason", "", PLASTICA_MEMBER(reason), "why it cannot");
};

/// Of a Repair.
inline constexpr auto kDescribeRepair = [](auto& d) {
  d("kind", "", PLASTICA_MEMBER(kind), "what was mended");
  d("count", "1", PLASTICA_MEMBER(count), "samples touched");
  d("text", "", PLASTICA_MEMBER(text), "in a sentence");
};

/// Of a Correction.
inline constexpr auto kDescribeCorrection = [](auto& d) {
  d("kind", "", PLASTICA_MEMBER(kind), "what was corrected");
  d("applied", "", PLASTICA_MEMBER(applied), "whether it was needed");
  d("amount", "", PLASTICA_MEMBER(amount), "strain shift, stress shift or samples cut");
  d("amount_units", "", PLASTICA_MEMBER(unit), "unit of the amount");
  d("text", "", PLASTICA_MEMBER(text), "the rule that called for it, or why it did not");
};

/// Of a SceneTarget, but for its curve.
inline constexpr auto kDescribeSceneTarget = [](auto& d) {
  d("name", "", PLASTICA_MEMBER(name), "of the target");
  d.since(9, [](auto& later) {
    later("table", "", PLASTICA_MEMBER(table),
          "which [[target]] of the fit file it stands in, from 1 on; 0: not known");
  });
  d("kind", "", PLASTICA_MEMBER(kind), "what its abscissa is in the scene");
  d("driven", "", PLASTICA_MEMBER(driven), "which support or load follows the abscissa");
  d("abscissa_probe", "", PLASTICA_MEMBER(abscissa_probe), "the scene's probe of the abscissa");
  d("ordinate_probe", "", PLASTICA_MEMBER(ordinate_probe), "the scene's probe of the ordinate");
  d("abscissa_dimension", "", PLASTICA_MEMBER(abscissa_is), "what the abscissa measures");
  d("ordinate_dimension", "", PLASTICA_MEMBER(ordinate_is), "what the ordinate measures");
  d("abscissa_factor", "1", PLASTICA_MEMBER(abscissa_factor), "measured over the scene's");
  d("ordinate_factor", "1", PLASTICA_MEMBER(ordinate_factor), "measured over the scene's");
  d("stated_noise", "", PLASTICA_MEMBER(noise), "stated standard deviation of the ordinate");
  d.optional("broke", PLASTICA_MEMBER(broke), [](auto& inner) {
    inner("break_at", "", PLASTICA_MEMBER(at), "abscissa of the break");
    inner("break_half_interval", "", PLASTICA_MEMBER(half_interval),
          "the break is anywhere within this on both sides");
    inner.since(5, [](auto& later) {
      later("rows_after_break", "1", PLASTICA_MEMBER(cut), "measured after it, which do not count");
    });
  });
};

}  // namespace plastica::calibrate
