#include "plastica/report/scene_setup_text.hpp"
#include "plastica/model/support_kind.hpp"

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

constexpr std::size_t kMaxListed = 4;  ///< of supports, loads, masses and regions
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
  const std::string name = shown_name(material);
  std::string label = (name.empty() ? name : printable(name) + ", ") + "E " +
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
std::string parts_of(std::span<const double> v, std::string_view symbol, std::string_view unit) {
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

/// "k_x 5 N/m", "gap 2 mm"; empty if zero.
template <class Item>
std::string label_of(const ItemField<Item>& field, const Item& item) {
  const Dimension dimension = field.dimension_of(item);
  const double* number = field.number(item);
  if (!number) return parts_of(field.values(item), field.symbol, si_unit(dimension));
  if (*number == 0.0) return {};
  std::string text = brief(*number);
  if (dimension == Dimension::Length) {
    text = shown(*number, dimension, 4);
  } else if (dimension != Dimension::None) {
    text += ' ' + std::string(si_unit(dimension));
  }
  return std::string(field.symbol) + text;
}

template <class Item, class Field>
std::string labels_of(const Item& item, std::span<const Field> fields) {
  std::string text;
  for (const Field& field : fields) text = joined(text, label_of(field, item));
  return text;
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

/// "y", "-y", "(0, 0.8, -0.6)"
std::string direction_label(const std::array<double, 3>& direction) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::fabs(direction[k]) < 1.0) continue;
    return (direction[k] < 0.0 ? "-" : "") + std::string(kAxes[k]);
  }
  return fmt::format("({}, {}, {})", brief(direction[0]), brief(direction[1]), brief(direction[2]));
}

std::string support_label(const Support& support, double end) {
  const SupportTraits& kind = traits_of(support);
  std::string label =
      fmt::format("{} {}", kind.word,
                  support.to ? fmt::format("from {} to {}", place_label(support.at.fraction),
                                           place_label(support.to->fraction))
                             : "at " + place_label(support.at.fraction));
  std::string more;
  for (const SupportField& field : support_fields()) {
    if (!field.of || !field.belongs_to(support)) continue;
    if (field.of == &SupportTraits::normal) {
      more = (kind.one_sided ? "pushes along " : "holds along ") + direction_label(support.normal);
    } else {
      more = joined(more, label_of(field, support));
    }
  }
  if (kind.no_hold.empty() && support.held() != kind.held) {
    std::string held;
    for (std::size_t k = 0; k < 6; ++k) {
      if (support.held()[k]) held += (held.empty() ? "" : " ") + std::string(freedom_names()[k]);
    }
    more = joined(more, "holds " + (held.empty() ? "nothing" : held));
  }
  if (support.moves()) {
    more = joined(more, "moves by " + labels_of(support, std::span(support_fields()).last(2)) +
                            history_label(support.history, end));
  }
  return more.empty() ? label : label + " (" + more + ')';
}

std::string load_label(const Load& load, double end) {
  const bool spread = load.to.has_value();
  std::string label = labels_of(load, load_fields());
  if (label.empty()) label = "none";
  label += spread ? fmt::format(" from {} to {}", place_label(load.at.fraction),
                                place_label(load.to->fraction))
                  : " at " + place_label(load.at.fraction);
  if (load.follows) label += ", follows";
  return label + history_label(load.history, end);
}

std::string mass_label(const PointMass& mass) {
  return labels_of(mass, mass_fields()) + " at " + place_label(mass.at.fraction);
}

template <class Items, class Label>
std::string listed(const Items& items, const Label& label) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), kMaxListed); ++i) {
    text += (i == 0 ? "" : "; ") + label(items[i]);
  }
  if (items.size() > kMaxListed) text += fmt::format("; … {} in all", items.size());
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
