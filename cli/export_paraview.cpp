#include "cli/export_paraview.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/exit_code.hpp"
#include "cli/frame_progress.hpp"
#include "cli/interrupt.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/vtk/vtkhdf_file.hpp"

namespace plastica::cli {
namespace {

/// The file of the numbers beside an XDMF text: in place of its ending, or behind another one, so
/// that two texts do not share it.
std::string numbers_beside(const std::string& output) {
  const std::filesystem::path path(output);
  if (path.extension() != ".xdmf") return output + ".vtkhdf";
  return std::filesystem::path(path).replace_extension(".vtkhdf").string();
}

/// The library of XDMF reads the text "FILE:/DATASET|selection", and trims it.
void check_name_for_xdmf(const std::string& output) {
  const std::string name = std::filesystem::path(output).filename().string();
  if (name.find_first_of(":|\\\t\n\r") == std::string::npos && !name.starts_with(' ')) return;
  throw InputError({}, "--output", output,
                   "must have no colon, bar, backslash, tab or line break in its name, nor a blank "
                   "before it: readers of XDMF take them for something else");
}

}  // namespace

bool is_for_paraview(std::string_view format) {
  return std::find(kParaviewFormats.begin(), kParaviewFormats.end(), format) !=
         kParaviewFormats.end();
}

void tell_of_numbered_steps(const io::SceneRecord& record) {
  if (report::has_rising_times(record)) return;
  tell("note: the times of the frames fall, and readers would sort them: the steps are numbered\n");
}

int write_for_paraview(const std::string& file, std::string_view format, const std::string& output,
                       bool force) {
  if (output == "-") {
    throw InputError({}, "--output", "-", "must be a file: the format is none for a terminal");
  }
  const bool text = format == "xdmf";
  const std::string numbers = text ? numbers_beside(output) : output;
  if (text) {
    check_name_for_xdmf(output);
    refuse_input("--output", numbers, file);
    io::check_output_path(numbers, force);
  }
  io::check_output_path(output, force);
  const io::SceneRecord record = io::read_scene_store(file);
  const InterruptGuard interrupt;
  try {
    FrameProgress progress(report::frames_of(record), false);
    const report::FrameHooks hooks{&interrupt.flag(),
                                   [&](std::size_t done) { progress.update(done); }};
    if (!report::write_vtkhdf(numbers, record, io::overwrite_if(force), hooks)) {
      progress.clear();
      tell("interrupted: nothing is written\n");
      return kInterrupted;
    }
  } catch (const InputError& error) {
    if (!error.field().empty()) throw;
    throw InputError({file}, "", "", error.rule());
  }
  tell_of_numbered_steps(record);
  if (!text) return kDone;
  try {
    const std::string name = std::filesystem::path(numbers).filename().string();
    io::write_text_file(output, report::xdmf_text(record, name), io::overwrite_if(force));
  } catch (...) {
    // Numbers alone would be in the way of the next try, or belong to an older text.
    std::error_code ignored;
    std::filesystem::remove(numbers, ignored);
    throw;
  }
  tell("the numbers are in {}, beside it\n", numbers);
  return kDone;
}

}  // namespace plastica::cli
