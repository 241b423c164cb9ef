#include "plastica/io/team_journals.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "plastica/io/durable_file.hpp"

namespace plastica::io {
namespace {

/// The number in "NAME.12"; 0: it has none, or not as `team_journal_path` writes it.
std::size_t rank_of(std::string_view file, std::string_view name) {
  if (!file.starts_with(name) || file.size() <= name.size() + 1 || file[name.size()] != '.') {
    return 0;
  }
  const std::string_view digits = file.substr(name.size() + 1);
  std::size_t rank = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), rank);
  const bool whole = error == std::errc{} && end == digits.data() + digits.size();
  return whole && digits.front() != '0' ? rank : 0;
}

}  // namespace

std::string team_journal_path(const std::string& path, std::size_t rank) {
  return rank == 0 ? path : path + "." + std::to_string(rank);
}

std::vector<std::string> team_journals_beside(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  std::vector<std::size_t> ranks;
  std::error_code error;  // what cannot be read has no journal, and none can be written to it
  std::filesystem::directory_iterator entry(folder_of(path), error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::size_t rank = rank_of(entry->path().filename().string(), name);
    if (rank > 0) ranks.push_back(rank);
  }
  std::ranges::sort(ranks);
  std::vector<std::string> paths;
  paths.reserve(ranks.size());
  for (const std::size_t rank : ranks) paths.push_back(team_journal_path(path, rank));
  return paths;
}

std::vector<FoundJournal> read_team_journals(const std::string& path, std::uint64_t run_digest) {
  std::vector<FoundJournal> found{{path, read_journal(path, run_digest)}};
  for (std::string& other : team_journals_beside(path)) {
    JournalContent content = read_journal(other, run_digest);
    found.push_back({std::move(other), std::move(content)});
  }
  return found;
}

}  // namespace plastica::io
