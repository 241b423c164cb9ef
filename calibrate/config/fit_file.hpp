#pragma once

#include <memory>
#include <string>
#include <vector>

#include "calibrate/config/read_target.hpp"
#include "calibrate/fit/options.hpp"
#include "plastica/io/result_file.hpp"

namespace plastica::calibrate {

/// What a fit file says; docs/file-formats.md lists its keys.
struct FitFile {
  std::string path;  ///< as the user gave it; empty for curves named on the command line
  std::string text;
  FitOptions options;
  std::vector<TargetBlock> targets;  ///< in the order of the file
  std::vector<std::string> notes{};  ///< old names in it, each with the new one, for the user
};

/// Reads a fit file and finds the files of its targets; does not read those.
/// @throws InputError naming file, line, key, value and rule, for the first thing that is wrong:
///         keys that nobody knows, and patterns that match no file, included
FitFile read_fit_file(const std::string& path);
/// @param path  stands for the file in errors; its folder is where relative paths begin
FitFile parse_fit_file(std::string text, const std::string& path);

/// Reads what a fit file says of curves that a program has itself: all but [[target]], whose place
/// takes [target_defaults] as the one block, without files and columns.
/// @param name  stands for the file in errors
/// @throws InputError as above, also for files and columns in [target_defaults]
FitFile parse_curve_options(std::string text, const std::string& name);

/// The texts that a result depends on, for the file: the fit file, then its tables, each once.
/// @throws InputError if a table cannot be read
std::vector<io::InputText> input_texts(const FitFile& file);
/// The tables beside the curves, each once.
std::vector<const TableSource*> tables_of(const FitFile& file);

/// Imports the specimens of all targets. A name that an earlier specimen has gets "#2", "#3", …
/// @param threads  that read files side by side, 0: as many as the machine has; changes nothing
/// @param spool  see `import_targets`
/// @throws InputError as `import_targets`, but not for a bad specimen: that one is Rejected
std::vector<Target> import_all(const FitFile& file, int threads = 0,
                               const std::shared_ptr<CurveSpool>& spool = nullptr);

}  // namespace plastica::calibrate
