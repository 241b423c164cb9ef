#pragma once

#include <cstddef>
#include <vector>

#include "plastica/run/response.hpp"

/// Events as flat tables, for files; not installed.
namespace plastica::io {

struct EventTable {
  struct Joint {
    int event = 0;  ///< number of its event
    BrokenJoint broken;
  };
  struct FragmentRow {
    int event = 0;
    Fragment fragment;
  };
  std::vector<double> time;            ///< [s] (n_events)
  std::vector<double> factor;          ///< [1] (n_events)
  std::vector<Joint> joints;           ///< (n_broken)
  std::vector<FragmentRow> fragments;  ///< (n_fragments)
};

inline EventTable event_table(const std::vector<ChainBreak>& events) {
  EventTable table;
  for (const ChainBreak& event : events) {
    const int number = static_cast<int>(table.time.size());
    table.time.push_back(event.time);
    table.factor.push_back(event.factor);
    for (const BrokenJoint& joint : event.joints) table.joints.push_back({number, joint});
    for (const Fragment& fragment : event.fragments) table.fragments.push_back({number, fragment});
  }
  return table;
}

/// @param table  all of whose rows are of an event that it has
inline std::vector<ChainBreak> events_of(const EventTable& table) {
  std::vector<ChainBreak> events;
  for (std::size_t e = 0; e < table.time.size(); ++e) {
    ChainBreak event{table.time[e], table.factor[e], {}, {}};
    for (const auto& row : table.joints) {
      if (row.event == static_cast<int>(e)) event.joints.push_back(row.broken);
    }
    for (const auto& row : table.fragments) {
      if (row.event == static_cast<int>(e)) event.fragments.push_back(row.fragment);
    }
    events.push_back(std::move(event));
  }
  return events;
}

}  // namespace plastica::io
