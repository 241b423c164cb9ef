#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "plastica/io/journal.hpp"

namespace plastica::io {

/// Where process `rank` of a team keeps its cases: process 0 in the journal of the output, the
/// others beside it, "OUT.h5.journal.3".
std::string team_journal_path(const std::string& path, std::size_t rank);

/// Paths of the journals of other processes than 0 that stand beside a journal, in the order of
/// their numbers.
std::vector<std::string> team_journals_beside(const std::string& path);

/// A journal that was found, and where.
struct FoundJournal {
  std::string path;
  JournalContent content;
};

/// Reads a journal and those of the other processes that wrote beside it. The journal itself comes
/// first, be it there or not.
/// @throws as `read_journal`
std::vector<FoundJournal> read_team_journals(const std::string& path, std::uint64_t run_digest);

}  // namespace plastica::io
