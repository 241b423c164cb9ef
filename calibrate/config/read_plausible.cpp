#include "calibrate/config/read_plausible.hpp"

#include <string_view>
#include <utility>

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

double positive(const TomlValue& value, Dimension dimension) {
  const double si = value.quantity(dimension);
  if (!(si > 0.0)) throw value.error("must be above 0");
  return si;
}

/// [least, most]
void read_bounds(const TomlTable& table, std::string_view key, Dimension dimension, double& least,
                 double& most) {
  const auto value = table.find(key);
  if (!value) return;
  const auto ends = value->array();
  if (ends.size() != 2) throw value->error("must be two values, [least, most]");
  least = positive(ends[0], dimension);
  most = positive(ends[1], dimension);
  if (!(least < most)) throw value->error("must rise");
}

void read_bound(const TomlTable& table, std::string_view key, Dimension dimension, double& bound) {
  if (const auto value = table.find(key)) bound = positive(*value, dimension);
}

}  // namespace

void read_plausible(const TomlTable& table, TargetOptions& options) {
  PlausibleBounds& bounds = options.plausible;
  read_bounds(table, "youngs_modulus", Dimension::Stress, bounds.min_modulus, bounds.max_modulus);
  read_bounds(table, "yield_strain", Dimension::Strain, bounds.min_yield_strain,
              bounds.max_yield_strain);
  read_bound(table, "elastic_strain", Dimension::Strain, bounds.max_elastic_strain);
  read_bound(table, "soft_yield_strain", Dimension::Strain, bounds.min_soft_yield_strain);
  read_bound(table, "strain", Dimension::Strain, bounds.max_strain);
  read_bound(table, "strong_strain", Dimension::Strain, bounds.max_strong_strain);
  read_bound(table, "ductile_modulus", Dimension::Stress, bounds.max_ductile_modulus);
  read_bound(table, "modulus_factor", Dimension::None, bounds.modulus_factor);
  read_bound(table, "group_factor", Dimension::None, bounds.group_factor);
  for (const auto& [key, factor] : {std::pair("modulus_factor", bounds.modulus_factor),
                                    std::pair("group_factor", bounds.group_factor)}) {
    if (!(factor > 1.0)) throw table.at(key).error("must be above 1");
  }
  if (const auto modulus = table.find("expected_modulus")) {
    options.expected_modulus = positive(*modulus, Dimension::Stress);
  }
  if (table.contains("accept")) options.accept = table.is_set("accept");
}

}  // namespace plastica::calibrate
