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
  struct PieceRow {
    int event = 0;
    Piece piece;
  };
  std::vector<double> time;      ///< [s] (n_events)
  std::vector<double> factor;    ///< [1] (n_events)
  std::vector<Joint> joints;     ///< (n_broken)
  std::vector<PieceRow> pieces;  ///< (n_pieces)
};

inline EventTable event_table(const std::vector<ChainBreak>& events) {
  EventTable table;
  for (const ChainBreak& event : events) {
    const int number = static_cast<int>(table.time.size());
    table.time.push_back(event.time);
    table.factor.push_back(event.factor);
    for (const BrokenJoint& joint : event.joints) table.joints.push_back({number, joint});
    for (const Piece& piece : event.pieces) table.pieces.push_back({number, piece});
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
    for (const auto& row : table.pieces) {
      if (row.event == static_cast<int>(e)) event.pieces.push_back(row.piece);
    }
    events.push_back(std::move(event));
  }
  return events;
}

}  // namespace plastica::io
