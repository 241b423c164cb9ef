#include "cli/find_record.hpp"

#include <fmt/format.h>

#include "plastica/base/check.hpp"

namespace plastica::cli {

const calibrate::FitRecord& find_record(std::span<const calibrate::FitRecord> records,
                                        const std::string& specimen, const std::string& file) {
  constexpr std::size_t kMostNames = 8;
  std::string names;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].target.name == specimen) return records[i];
    if (i < kMostNames) names += (i == 0 ? "" : ", ") + records[i].target.name;
  }
  if (records.size() > kMostNames) names += fmt::format(", … ({} in all)", records.size());
  throw InputError({file, 0}, "--case", specimen, "must be a specimen of the file: " + names);
}

}  // namespace plastica::cli
