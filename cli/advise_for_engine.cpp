#include "cli/advise_for_engine.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "calibrate/engine/engine_text.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "sweeps/advise/for_engine/engine_advice.hpp"
#include "sweeps/advise/for_engine/engine_advice_json.hpp"
#include "sweeps/advise/for_engine/engine_advice_text.hpp"

namespace plastica::cli {
namespace {

sweeps::EngineAdvice engine_advice_with_progress(const sweeps::AdvisedEngine& engine,
                                                 const Setup& setup, sweeps::AdviceOptions options,
                                                 bool quiet) {
  const InterruptGuard interrupt;
  options.stop = &interrupt.flag();
  // Our own runs, then those by the engine's rule.
  ProgressBar bar("runs, at most",
                  static_cast<std::size_t>(sweeps::kRuleRunsPerRun * options.max_runs), quiet);
  options.progress = [&](int runs) { bar.update(static_cast<std::size_t>(runs), 0); };
  sweeps::EngineAdvice advice = sweeps::advise_for_engine(engine, setup, options);
  bar.clear();
  return advice;
}

void write_beam(const EngineAdviceRequest& request, sweeps::EngineAdvice& advice,
                const std::string& name) {
  calibrate::EngineBeam& beam = advice.beam;
  const calibrate::EngineFormat format = advice.engine->format;
  for (const std::string& note : calibrate::engine_notes(beam, format)) {
    tell("note: {}\n", note);
  }
  beam.notes.insert(beam.notes.begin(), advice.notes.begin(), advice.notes.end());
  beam.notes.insert(
      beam.notes.begin(),
      fmt::format("segments and step are advised for {} of {}: error {:.3g} % at most",
                  advice.worst, name, 100.0 * advice.promised));
  io::write_text_file(request.output, calibrate::engine_text(beam, format),
                      io::overwrite_if(request.force));
  tell("wrote {}\n", request.output);
}

}  // namespace

void check_engine_request(const EngineAdviceRequest& request) {
  std::vector<std::string> words;
  for (const sweeps::AdvisedEngine& one : sweeps::advised_engines()) words.emplace_back(one.word);
  check_word("--for", request.engine, words);
  const sweeps::AdvisedEngine& engine = *sweeps::advised_engine(request.engine);
  require_ending("-o", request.output, std::string(engine.ending),
                 fmt::format("with --for {} it is the beam", engine.word));
}

int advise_for_engine(EngineAdviceRequest request, const io::SceneFile& file) {
  sweeps::EngineAdvice advice = engine_advice_with_progress(
      *sweeps::advised_engine(request.engine), file.setup, request.options, request.quiet);
  const std::string name = std::filesystem::path(request.scene).filename().string();
  fmt::print("{}", sweeps::engine_advice_text(advice, request.options, name));
  if (advice.end == sweeps::EngineAdviceEnd::Interrupted) return kInterrupted;
  if (!request.json.empty()) {
    io::write_text_file(request.json, sweeps::engine_advice_json(advice, request.options, name),
                        io::overwrite_if(request.force));
    tell("wrote {}\n", request.json);
  }
  if (advice.end != sweeps::EngineAdviceEnd::Found) return kNotAcceptable;
  if (!request.output.empty()) write_beam(request, advice, name);
  return kDone;
}

}  // namespace plastica::cli
