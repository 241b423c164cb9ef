#include "calibrate/report/repairs_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "calibrate/report/format.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate::report {

using plastica::report::Ink;
using plastica::report::kWidth;

namespace {

/// Curves that were mended in the same way.
struct EqualRepairs {
  std::string kind;
  std::string sentence;
  std::vector<std::pair<std::size_t, std::string_view>> curves;  ///< samples, name
};

}  // namespace

std::string repairs_text(std::span<const Repair> repairs, const Ink& ink) {
  if (repairs.empty()) return {};
  std::string text = '\n' + ink.heading("Repairs\n");
  for (const Repair& repair : repairs) {
    const std::string first =
        fmt::format("  {:<17} {:<14}", repair.kind, counted(repair.count, "sample"));
    text += wrapped(first, printable(sentence_of(repair)), kWidth);
  }
  return text;
}

std::string repairs_text(std::span<const RepairedCurve> curves, std::size_t shown, const Ink& ink) {
  std::vector<EqualRepairs> all;
  for (const RepairedCurve& curve : curves) {
    for (const Repair& repair : curve.repairs) {
      const std::string sentence = sentence_of(repair);
      auto equal = std::find_if(all.begin(), all.end(), [&](const EqualRepairs& other) {
        return other.kind == repair.kind && other.sentence == sentence;
      });
      if (equal == all.end()) equal = all.insert(all.end(), {repair.kind, sentence, {}});
      equal->curves.emplace_back(repair.count, curve.name);
    }
  }
  if (all.empty()) return {};
  std::string text = '\n' + ink.heading("Repaired\n");
  for (const EqualRepairs& equal : all) {
    text += wrapped("  " + equal.kind + ": ", printable(equal.sentence), kWidth);
    const std::size_t count = equal.curves.size();
    const std::size_t listed = shown == 0 ? count : std::min(count, shown);
    std::string list;
    for (std::size_t i = 0; i < listed; ++i) {
      const auto& [samples, name] = equal.curves[i];
      list += (i == 0 ? counted(samples, "sample") : ", " + std::to_string(samples)) + " in " +
              printable(name);
    }
    if (listed < count) list += fmt::format(", and {} more", counted(count - listed, "specimen"));
    text += wrapped("    ", list, kWidth);
  }
  return text;
}

std::string repairs_text(std::span<const SceneFitRecord> records, const ReportOptions& options,
                         const Ink& ink) {
  std::vector<RepairedCurve> curves;
  for (const SceneFitRecord& record : records) {
    for (const SceneTarget& target : record.targets) {
      curves.push_back({target.name, target.repairs});
    }
  }
  if (curves.size() == 1) return repairs_text(curves.front().repairs, ink);
  return repairs_text(curves, options.specimens_shown, ink);
}

}  // namespace plastica::calibrate::report
