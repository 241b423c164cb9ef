#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "plastica/base/quantity.hpp"
#include "plastica/io/scene_store.hpp"

/// Which probes a picture shows; not installed.
namespace plastica::report {

/// The probe of one name of each record of a picture, over one axis.
class ShownProbes {
 public:
  /// @param name  empty: of each the first displacement, or else rotation, or else the first probe
  /// @throws InputError for a record without such a probe, and for probes of unlike dimensions
  ShownProbes(std::span<const io::SceneRecord> records, const std::string& name);

  std::size_t index(std::size_t record) const { return index_[record]; }
  const Probe& probe(std::size_t record) const;
  const std::vector<double>& values(std::size_t record) const {
    return records_[record].response.probes[index_[record]];
  }
  Dimension dimension() const;  ///< that all have
  /// What all are: "tip: displacement y at end"; where they differ, the quantities alone.
  std::string axis() const;
  /// What all are but for their names; empty where they differ.
  std::string title() const { return are_alike_ ? label_of(0) : std::string(); }
  /// The name of a record's curve: of one record that of the probe; with what its probe is, where
  /// they differ.
  /// @param label  what tells the record from the others
  std::string curve_name(std::size_t record, const std::string& label) const;
  /// The names, each once.
  std::string names() const;

 private:
  std::string label_of(std::size_t record) const;

  std::span<const io::SceneRecord> records_;
  std::vector<std::size_t> index_;
  bool are_alike_ = true;
};

}  // namespace plastica::report
