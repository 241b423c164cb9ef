#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// Tables of files that were read to find out what their columns are, for the import that follows:
/// each is read once. What does not fit into its memory is read again. For several threads.
class KeptTables {
 public:
  /// @param most  that the tables may take of memory, about [bytes]
  explicit KeptTables(std::size_t most = std::size_t{64} << 20U) : room_(most) {}

  /// Keeps a table, or lets go of it where there is no room.
  /// @param options  that it was read with
  void keep(const io::CsvOptions& options, io::CsvTable table);

  /// Hands out the table of a file, if it is kept and was read with the same options.
  std::optional<io::CsvTable> take(const std::string& file, const io::CsvOptions& options);

 private:
  std::mutex mutex_;
  std::size_t room_;
  std::map<std::string, std::pair<io::CsvOptions, io::CsvTable>> tables_;
};

}  // namespace plastica::calibrate
