#include "calibrate/target/kept_tables.hpp"

namespace plastica::calibrate {

void KeptTables::keep(const io::CsvOptions& options, io::CsvTable table) {
  const std::scoped_lock lock(mutex_);
  if (table.bytes() > room_) return;
  const std::string file = table.file();
  const std::size_t size = table.bytes();
  if (tables_.try_emplace(file, options, std::move(table)).second) room_ -= size;
}

std::optional<io::CsvTable> KeptTables::take(const std::string& file,
                                             const io::CsvOptions& options) {
  const std::scoped_lock lock(mutex_);
  const auto at = tables_.find(file);
  if (at == tables_.end() || !(at->second.first == options)) return std::nullopt;
  std::optional<io::CsvTable> table(std::move(at->second.second));
  room_ += table->bytes();
  tables_.erase(at);
  return table;
}

}  // namespace plastica::calibrate
