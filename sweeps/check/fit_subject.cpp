#include "sweeps/check/fit_subject.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "calibrate/config/settle_segments.hpp"
#include "calibrate/search/fit_interrupted.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/journaled_batch.hpp"
#include "calibrate/store/journaled_scene_fits.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::sweeps {
namespace {

/// A folder for a journal that nobody resumes; gone when the fits are done.
class JournalFolder {
 public:
  JournalFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "plastica-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw io::StorageError(pattern, std::string("cannot be made: ") + std::strerror(errno));
    }
    path_ = pattern;
  }
  ~JournalFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  JournalFolder(const JournalFolder&) = delete;
  JournalFolder& operator=(const JournalFolder&) = delete;

  calibrate::JournaledOptions options(int threads, StopFlag stop,
                                      const std::function<void(std::size_t done)>& progress) const {
    calibrate::JournaledOptions how;
    how.journal.path = (path_ / "fits.journal").string();
    how.threads = threads;
    how.stop = stop;
    how.progress = [&progress](const calibrate::BatchProgress& now) {
      if (progress) progress(now.done);
    };
    return how;
  }

 private:
  std::filesystem::path path_;
};

template <typename Records, typename NameOf>
void add_names(const Records& records, const NameOf& name_of, std::vector<std::string>& names) {
  for (const auto& record : records) {
    const std::string& name = name_of(record);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

std::size_t law_count(const std::vector<calibrate::Law>& laws) {
  return std::max<std::size_t>(1, laws.size());
}

}  // namespace

std::vector<std::string> FitSubject::names() const {
  std::vector<std::string> all;
  const auto of_record = [](const auto& one) -> const std::string& { return one.name; };
  add_names(targets, of_record, all);
  if (scenes) add_names(scenes->cases, of_record, all);
  if (result) {
    add_names(
        result->curves, [](const auto& one) -> const std::string& { return one.target.name; }, all);
    add_names(result->scenes, of_record, all);
  }
  return all;
}

std::size_t FitSubject::fits() const {
  if (curves) return targets.size() * law_count(curves->options.laws);
  return scenes ? scenes->cases.size() * law_count(scenes->options.laws) : 0;
}

std::vector<std::string> FitSubject::notes() const {
  if (curves) return curves->notes;
  return scenes ? scenes->notes : std::vector<std::string>{};
}

FitSubject read_fit_subject(const std::string& path) {
  FitSubject subject;
  subject.path = path;
  if (calibrate::names_scenes(path)) {
    subject.scenes = calibrate::read_scene_fit_file(path);
    calibrate::check_fits(*subject.scenes);
    return subject;
  }
  subject.curves = calibrate::read_fit_file(path);
  subject.targets = calibrate::import_all(*subject.curves);
  calibrate::check_parameters(subject.curves->options.parameters);
  return subject;
}

FitSubject read_fit_result(const std::string& path) {
  FitSubject subject;
  subject.path = path;
  FittedRecords& records = subject.result.emplace();
  const std::string schema = io::schema_of(path);
  if (schema == calibrate::kFitStoreSchema) {
    records.curves = calibrate::read_fit_store(path).records;
  } else if (schema == calibrate::kSceneFitSchema) {
    records.scenes = calibrate::read_scene_fit_store(path).records;
  } else {
    throw InputError({path, 0}, "schema", schema, "must be a result of fits, of calibrate");
  }
  return subject;
}

std::optional<FittedRecords> run_fits(const FitSubject& subject, int threads, StopFlag stop,
                                      const std::function<void(std::size_t done)>& progress) {
  if (subject.result) return *subject.result;
  const JournalFolder folder;
  FittedRecords found;
  if (subject.curves) {
    calibrate::JournaledBatch batch(subject.targets, subject.curves->options,
                                    folder.options(threads, stop, progress));
    std::vector<calibrate::FitResult> results = batch.run();
    if (!batch.complete()) return std::nullopt;
    for (std::size_t i = 0; i < results.size(); ++i) {
      found.curves.push_back({subject.targets[batch.cases()[i].target], std::move(results[i])});
    }
    return found;
  }
  calibrate::SceneFitFile file = *subject.scenes;
  try {
    calibrate::SceneFitHooks hooks;
    hooks.stop = stop;
    if (!calibrate::settle_segments(file, threads, hooks).found) {
      for (const calibrate::SceneFitCase& one : file.cases) {
        calibrate::SceneFitResult none;
        none.reason = "no number of segments moves its values by as little as fit.within asks for";
        found.scenes.push_back(record_of(one, std::move(none)));
      }
      return found;
    }
  } catch (const calibrate::FitInterrupted&) {
    return std::nullopt;
  }
  calibrate::JournaledSceneFits batch(file.cases, file.options,
                                      folder.options(threads, stop, progress));
  std::vector<calibrate::SceneFitResult> results = batch.run();
  if (!batch.complete()) return std::nullopt;
  for (std::size_t i = 0; i < results.size(); ++i) {
    found.scenes.push_back(record_of(file.cases[batch.fits()[i].of], std::move(results[i])));
  }
  return found;
}

}  // namespace plastica::sweeps
