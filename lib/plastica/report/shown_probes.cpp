#include "plastica/report/shown_probes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_facts.hpp"

namespace plastica::report {
namespace {

/// The number of a probe.
std::size_t probe_index(const io::SceneRecord& record, const std::string& name) {
  const auto& probes = record.setup.scene.probes;
  std::string names;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    if (probes[p].name == name) return p;
    names += (names.empty() ? "" : ", ") + probes[p].name;
  }
  if (!name.empty()) throw InputError({}, "--probe", name, "must be a probe of the file: " + names);
  for (const ProbeQuantity wanted : {ProbeQuantity::Displacement, ProbeQuantity::Rotation}) {
    for (std::size_t p = 0; p < probes.size(); ++p) {
      if (probes[p].quantity == wanted) return p;
    }
  }
  return 0;
}

/// Texts one after the other, each once.
std::string listed_once(const std::vector<std::string>& texts) {
  std::vector<std::string> once;
  for (const std::string& text : texts) {
    if (std::ranges::find(once, text) == once.end()) once.push_back(text);
  }
  return fmt::format("{}", fmt::join(once, ", "));
}

}  // namespace

ShownProbes::ShownProbes(std::span<const io::SceneRecord> records, const std::string& name)
    : records_(records) {
  for (const io::SceneRecord& record : records) index_.push_back(probe_index(record, name));
  for (std::size_t r = 1; r < records.size(); ++r) {
    are_alike_ = are_alike_ && label_of(r) == label_of(0) && probe(r).name == probe(0).name;
    const Dimension own = dimension_of(probe(r).quantity, {});
    if (own == dimension()) continue;
    throw InputError({}, "--probe", name.empty() ? probe(0).name : name,
                     fmt::format("is {} of {} and {} of {}, which have no axis in common",
                                 label_of(0), printable(records[0].setup.scene.name), label_of(r),
                                 printable(records[r].setup.scene.name)));
  }
}

const Probe& ShownProbes::probe(std::size_t record) const {
  return records_[record].setup.scene.probes[index_[record]];
}

Dimension ShownProbes::dimension() const { return dimension_of(probe(0).quantity, {}); }

std::string ShownProbes::label_of(std::size_t record) const {
  return probe_label(records_[record], probe(record));
}

std::string ShownProbes::names() const {
  std::vector<std::string> names;
  for (std::size_t r = 0; r < records_.size(); ++r) names.push_back(printable(probe(r).name));
  return listed_once(names);
}

std::string ShownProbes::axis() const {
  if (are_alike_) return fmt::format("{}: {}", names(), label_of(0));
  std::vector<std::string> quantities;
  for (std::size_t r = 0; r < records_.size(); ++r) {
    quantities.emplace_back(probe_kinds()[static_cast<std::size_t>(probe(r).quantity)]);
  }
  return listed_once(quantities);
}

std::string ShownProbes::curve_name(std::size_t record, const std::string& label) const {
  if (records_.size() == 1) return printable(probe(0).name);
  return are_alike_ ? label : fmt::format("{}, {}", label, label_of(record));
}

}  // namespace plastica::report
