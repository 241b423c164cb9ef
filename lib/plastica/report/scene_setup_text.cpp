#include "plastica/report/scene_setup_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "plastica/model/section_kind.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_words.hpp"

namespace plastica::report {
namespace {

constexpr std::size_t kMostListed = 4;  ///< of supports, loads, masses and regions
constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

std::string section_label(const Section& section) {
  const std::string label = section_kind(section).label(section);
  return section.name.empty() ? label : printable(section.name) + ", " + label;
}

std::string stress_label(double stress, bool modulus) {
  const DisplayUnit unit = display_unit(Dimension::Stress, stress, modulus);
  return quantity(significant(stress / unit.scale, 4), unit.name);
}

std::string material_label(const Material& material, bool yields) {
  // A material of other numbers is not the default one, whose name it has if it has none.
  const Material usual;
  const bool named = !material.name.empty() && (material.name != usual.name ||
                                                (material.youngs_modulus == usual.youngs_modulus &&
                                                 material.yield_stress == usual.yield_stress));
  std::string label = (named ? printable(material.name) + ", " : std::string()) + "E " +
                      stress_label(material.youngs_modulus, true);
  if (yields) label += ", yield stress " + stress_label(material.yield_stress, false);
  return label;
}

std::string yield_label(const io::SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  if (scene.yield_model == YieldModel::Elastic) return "elastic: joints never yield";
  std::string label = solver_word(record, "rules.yield_model");
  if (scene.yield_model != YieldModel::Fibre)
    label += ", cap " + solver_word(record, "rules.yield_cap");
  label += ", hardening " + solver_word(record, "material.hardening.law");
  const RateDependence& rate = scene.material.rate;
  if (rate.law == RateLaw::None) return label;
  label += ", rate " + solver_word(record, "material.rate.law");
  return label + (rate.strain_rate ? fmt::format(" at {:g} 1/s", *rate.strain_rate)
                                   : std::string(" of each joint"));
}

/// "x 3, z -20": the parts of a vector that are not zero, with their unit.
std::string parts_of(const std::array<double, 3>& v, std::string_view symbol,
                     std::string_view unit) {
  std::string text;
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (v[k] == 0.0) continue;
    text +=
        fmt::format("{}{}{} {} {}", text.empty() ? "" : ", ", symbol, kAxes[k], brief(v[k]), unit);
  }
  return text;
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + ", " + b;
}

/// How far a history goes beyond its load, if not to it.
std::string history_label(const History& history, double end) {
  double largest = std::fabs(history.at(end));
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    if (history.time[i] <= end) largest = std::max(largest, std::fabs(history.factor[i]));
  }
  return std::fabs(largest - 1.0) < 1e-9 ? std::string()
                                         : fmt::format(", up to {} times that", brief(largest));
}

std::string support_label(const Support& support, double end) {
  std::string label =
      fmt::format("{} {}", support_kinds()[static_cast<std::size_t>(support.kind)],
                  support.to ? fmt::format("from {} to {}", place_label(support.at.fraction),
                                           place_label(support.to->fraction))
                             : "at " + place_label(support.at.fraction));
  std::string more;
  if (support.kind == SupportKind::Elastic) {
    more = joined(parts_of(support.stiffness, "k_", support.to ? "N/m^2" : "N/m"),
                  parts_of(support.rotational_stiffness, "k_r", "N m/rad"));
  } else if (support.has_normal()) {
    const bool pillar = support.kind == SupportKind::Pillar;
    more = parts_of(support.normal, pillar ? "pushes " : "holds along ", "");
    while (!more.empty() && more.back() == ' ') more.pop_back();
    if (support.gap != 0.0) more += ", gap " + shown(support.gap, Dimension::Length, 4);
    if (support.restitution != 0.0) more += ", restitution " + brief(support.restitution);
  } else {
    HeldFreedoms of_kind = Support{.kind = support.kind}.held();
    if (support.held() != of_kind) {
      std::string held;
      for (std::size_t k = 0; k < 6; ++k) {
        if (support.held()[k]) held += (held.empty() ? "" : " ") + std::string(freedom_names()[k]);
      }
      more = "holds " + (held.empty() ? "nothing" : held);
    }
  }
  if (support.moves()) {
    more = joined(more, "moves by " +
                            joined(parts_of(support.translation, "", "m"),
                                   parts_of(support.rotation, "r", "rad")) +
                            history_label(support.history, end));
  }
  return more.empty() ? label : label + " (" + more + ')';
}

std::string load_label(const Load& load, double end) {
  const bool spread = load.to.has_value();
  std::string label = joined(parts_of(load.force, "F_", spread ? "N/m" : "N"),
                             parts_of(load.moment, "M_", spread ? "N m/m" : "N m"));
  if (label.empty()) label = "none";
  label += spread ? fmt::format(" from {} to {}", place_label(load.at.fraction),
                                place_label(load.to->fraction))
                  : " at " + place_label(load.at.fraction);
  if (load.follows) label += ", follows";
  return label + history_label(load.history, end);
}

std::string mass_label(const PointMass& mass) {
  std::string label = mass.mass > 0.0 ? brief(mass.mass) + " kg" : std::string();
  label = joined(label, parts_of(mass.inertia, "I_", "kg m^2"));
  return label + " at " + place_label(mass.at.fraction);
}

template <class Items, class Label>
std::string listed(const Items& items, const Label& label) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), kMostListed); ++i) {
    text += (i == 0 ? "" : "; ") + label(items[i]);
  }
  if (items.size() > kMostListed) text += fmt::format("; … {} in all", items.size());
  return text;
}

}  // namespace

std::string setup_text(const io::SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  const bool coupon = record.level == Level::Coupon;
  const bool yields = coupon || scene.yield_model != YieldModel::Elastic;
  const auto& time = record.response.chain.time;
  const double end = time.empty() ? record.setup.solver.duration : time.back();
  std::string text = entry("material", material_label(scene.material, yields));
  text += entry("section", section_label(scene.section));
  if (coupon) return text;
  text += entry("yield", yield_label(record));
  if (!scene.regions.empty()) {
    text +=
        entry("regions", listed(scene.regions, [&](const Region& region) {
                const std::string taper =
                    region.to_section ? ", tapered to " + section_label(*region.to_section) : "";
                return fmt::format("{} to {}: {}{}, {}", place_label(region.from.fraction),
                                   place_label(region.to.fraction), section_label(region.section),
                                   taper, material_label(region.material, yields));
              }));
  }
  const std::string supports =
      listed(scene.supports, [&](const Support& support) { return support_label(support, end); });
  text += entry("supports", supports.empty() ? "none" : supports);
  if (!scene.masses.empty()) text += entry("masses", listed(scene.masses, mass_label));
  std::string loads = listed(scene.loads, [&](const Load& load) { return load_label(load, end); });
  const std::string gravity = parts_of(scene.gravity, "g_", "m/s^2");
  if (!gravity.empty()) {
    loads += (loads.empty() ? "" : "; ") + gravity + history_label(scene.gravity_history, end);
  }
  return text + entry("loads", loads.empty() ? "none" : loads);
}

}  // namespace plastica::report
