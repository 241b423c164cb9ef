#include "cli/export_paraview.hpp"

#include <algorithm>
#include <filesystem>

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

io::SceneRecord scene_with_frames(const std::string& file) {
  io::SceneRecord record = io::read_scene_store(file);
  if (record.outline.segments() == 0) {
    throw InputError({file}, "", "", "is of a coupon, which has no beam to show");
  }
  if (report::frames_of(record) == 0) {
    throw InputError({file}, "", "", "has no frame: the run ended before the first");
  }
  return record;
}

}  // namespace

bool is_for_paraview(std::string_view format) {
  return std::find(kParaviewFormats.begin(), kParaviewFormats.end(), format) !=
         kParaviewFormats.end();
}

void write_for_paraview(const std::string& file, std::string_view format, const std::string& output,
                        bool force) {
  if (output == "-") {
    throw InputError({}, "--output", "-", "must be a file: the format is none for a terminal");
  }
  const bool text = format == "xdmf";
  std::string numbers = output;
  if (text) {
    const std::filesystem::path path(output);
    numbers = std::filesystem::path(path).replace_extension(".vtkhdf").string();
    if (path.filename().string().find(':') != std::string::npos) {
      throw InputError(
          {}, "--output", output,
          "must have no colon in its name: XDMF takes it for the end of a file's name");
    }
    refuse_own_files("--output", numbers, output);
    refuse_input("--output", numbers, file);
    io::check_output_path(numbers, force);
  }
  io::check_output_path(output, force);
  const io::SceneRecord record = scene_with_frames(file);
  report::write_vtkhdf(numbers, record, io::overwrite_if(force));
  if (!text) return;
  const std::string name = std::filesystem::path(numbers).filename().string();
  io::write_text_file(output, report::xdmf_text(record, name), io::overwrite_if(force));
  tell("the numbers are in {}, beside it\n", numbers);
}

}  // namespace plastica::cli
