#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/config/fit_file.hpp"
#include "calibrate/store/fit_store.hpp"
#include "cli/tell.hpp"

namespace plastica {
class Team;
}

namespace plastica::cli {

/// The files that a fit of curves reads: its own, tables, curves.
std::vector<std::string> files_read(const calibrate::FitFile& file);

/// Refuses to write over a file that is read, whatever is forced. @throws InputError
void refuse_input(std::string_view option, const std::string& output, const std::string& input);

/// Refuses an output that is another output of the same run, or in the way of its journal or lock,
/// whatever is forced. @throws InputError
void refuse_own_files(std::string_view option, const std::string& path, const std::string& output);

/// Refuses the name of a result file that ends as another format does. @throws InputError
void refuse_other_format(const std::string& output);

/// Refuses an output, if there is one, that does not end as what is written does.
/// @param kind  "it is the beam"
void require_ending(std::string_view option, const std::string& output, std::string_view ending,
                    std::string_view kind);

/// Refuses an option that does not go with the others. @throws InputError
/// @param given  whether the command line has the option
void refuse_option(bool given, std::string_view option, std::string_view rule);

/// The seconds of an option that is a time, "12 ms"; empty where it is not given. @throws
/// InputError
std::optional<double> seconds_of(std::string_view option, const std::string& text);

/// The error of an option, "1 %", as a fraction, 0 … 1, both excluded. A bare number is refused: it
/// might be per cent or not. @throws InputError
double fraction_of(std::string_view option, const std::string& text);

/// Whether a run that is to go on finds an output, which may be its own, complete.
/// @param team  of the run, of which all find it or none; null: there is none
bool finds_output(bool resume, bool force, const std::string& output, Team* team);

/// Refuses a value that is none of an option's words, naming them and the nearest. Empty: not
/// given.
void check_word(std::string_view option, const std::string& value,
                const std::vector<std::string>& words);

/// Refuses an output that another run has made.
/// @param journal_is_ours  whether the journal has fits of this run
[[noreturn]] void refuse_other_output(const std::string& output, bool journal_is_ours);

/// Looks at an output that a run found: it is this run's, complete, or refused. Its journal goes,
/// unless it has fits of another run.
/// @param batch  has `run_id`, `resumed` and `stale` fits of its journal, and `discard`
/// @param found  `run_id` of the output
/// @throws InputError if another run has made the output
template <class Batch>
void take_complete_output(const std::string& output, const std::string& found, Batch& batch) {
  if (batch.run_id() != found) refuse_other_output(output, batch.resumed() > 0);
  tell("{} is complete: nothing is left to do\n", output);
  if (batch.stale() == 0) {
    batch.discard();
  } else {
    tell("its journal has {} fits of another run, and is kept\n", batch.stale());
  }
}

/// Says that a run was interrupted, and what goes on with it; once.
/// @param output  is replaced then, if it is there
void tell_interrupted(const std::string& output);

/// Checks where the result and the summary are to go, before anything is computed. Not even
/// `force` lets a run write over what it reads.
/// @param json  empty: none is asked for
/// @param found  the output may be there, since it is looked at before it is written
/// @throws InputError
void check_outputs(const calibrate::FitFile& file, const std::string& output,
                   const std::string& json, bool force, bool found = false);
/// @param read  the files that the run reads
void check_outputs(std::span<const std::string> read, const std::string& output,
                   const std::string& json, bool force, bool found = false);

}  // namespace plastica::cli
