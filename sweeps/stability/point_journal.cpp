#include "sweeps/stability/point_journal.hpp"

#include <cstdint>
#include <span>

#include "plastica/base/check.hpp"
#include "plastica/base/instruction_set.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/bytes.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_digest.hpp"
#include "sweeps/stability/point_run.hpp"

namespace plastica::sweeps::stability {
namespace {

/// Raised whenever what a record holds changes.
constexpr std::uint64_t kPointVersion = 1;

std::uint64_t journal_kind() {
  return io::Digest().text("plastica/stability").integer(kPointVersion).value();
}

std::string run_digest(const Setup& setup, double within) {
  io::Digest digest;
  digest.text(version()).text(name_of(resolved(setup.solver.isa)));
  return io::hexadecimal(digest.integer(io::scene_digest(setup)).real(within).value());
}

/// Visits all of a point, so that reading cannot forget what writing has. Warnings are of the
/// scene as it is alone, which every process runs.
template <class Run, class Coder>
void traverse(Run& r, Coder& code) {
  code(r.verdict.validity, r.verdict.reason, r.status, r.level, r.as_own, r.compared, r.deviation,
       r.quantity, r.energy_balance_error, r.segment_steps, r.seconds);
}

JudgedRun run_from_bytes(std::span<const std::byte> bytes) {
  constexpr const char* kSource = "record of a journal";
  io::ByteReader reader(bytes, kSource);
  JudgedRun run;
  const auto get = [&](auto&... values) {
    ((values = reader.get<std::remove_reference_t<decltype(values)>>()), ...);
  };
  traverse(run, get);
  reader.expect_end();
  if (static_cast<std::size_t>(run.verdict.validity) >= kValidity.size() ||
      static_cast<std::size_t>(run.status) >= io::status_words().size() ||
      static_cast<std::size_t>(run.level) >= find_field_or_null("solver.level")->choices.size()) {
    throw io::StorageError(kSource, "has a number that stands for no word");
  }
  return run;
}

}  // namespace

PointJournal::PointJournal(const io::JournalPolicy& policy, const Setup& setup, double within)
    : run_(run_digest(setup, within)),
      team_(policy.team),
      journal_(policy, journal_kind(), "points") {
  journal_.begin(run_, {});
  resumed_ = journal_.found_under(run_);
  if (journal_.found() == 0 || resumed_ > 0 || policy.force) return;
  const std::string other = journal_.other_instruction_set();
  throw InputError({policy.path, 0}, "", "",
                   "has no point of this scene and deviation: " +
                       (other.empty() ? std::string("name another output")
                                      : "they were run with the instruction set " + other +
                                            ": go on with that (solver.isa), name another output") +
                       ", or use --force to start afresh");
}

std::string PointJournal::id_of(const Setup& at) const {
  return run_ + io::hexadecimal(io::scene_digest(at));
}

std::optional<JudgedRun> PointJournal::find(const Setup& at) const {
  const std::string id = id_of(at);
  const auto* bytes = journal_.find(id);
  const std::lock_guard lock(mutex_);
  if (bytes != nullptr) {
    asked_.insert(id);
    return run_from_bytes(*bytes);
  }
  const auto kept = kept_.find(id);
  if (kept == kept_.end()) return std::nullopt;
  return run_from_bytes(kept->second);
}

void PointJournal::keep(const Setup& at, const JudgedRun& run) {
  io::ByteWriter writer;
  const auto put = [&](const auto&... values) { (writer.put(values), ...); };
  traverse(run, put);
  const std::string id = id_of(at);
  journal_.keep(id, writer.bytes());
  const std::lock_guard lock(mutex_);
  asked_.insert(id);
  kept_.insert_or_assign(id, writer.take());
}

std::size_t PointJournal::finish() {
  const std::size_t others = journal_.found_besides(asked_);
  if (others == 0) journal_.finish();
  return others;
}

}  // namespace plastica::sweeps::stability
