#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/config/settle_segments.hpp"
#include "calibrate/report/fits_text.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/result/words.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/store/journaled_scene_fits.hpp"
#include "python/bindings/background.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/fit_records.hpp"
#include "python/bindings/result_files.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

using calibrate::SceneFitContents;
using calibrate::SceneFitFile;
using calibrate::SceneFitRecord;
using Contents = std::shared_ptr<SceneFitContents>;

/// Gives the targets, in the order of the file, names that files could not have.
void rename(SceneFitFile& file, const std::vector<std::string>& names) {
  std::size_t k = 0;
  for (calibrate::SceneFitCase& one : file.cases) {
    for (calibrate::WeightedTarget& weighted : one.targets) {
      if (one.name == weighted.target.name) one.name = names.at(k);
      weighted.target.name = names.at(k++);
    }
  }
}

Contents run_scene_fits(SceneFitFile& file, const std::string& journal, int threads,
                        const py::object& progress) {
  calibrate::check_fits(file);
  const auto begin = std::chrono::steady_clock::now();
  auto contents = std::make_shared<SceneFitContents>();
  contents->meta = io::begin_meta("", threads);
  contents->meta.versions.emplace_back("nlopt", calibrate::nlopt_version());
  contents->meta.instruction_set =
      name_of(resolved(file.cases.front().targets.front().setup.solver.isa));
  contents->confidence = file.options.confidence;
  in_background(
      [&](const Background& background) {
        calibrate::SceneFitHooks hooks;
        hooks.stop = background.stop;
        if (!calibrate::settle_segments(file, threads, hooks).found) {
          throw InputError(
              {file.path, 0}, "fit.segments", "auto",
              "no number of segments moves the values by as little as fit.within asks");
        }
        contents->inputs = file.inputs;
        calibrate::JournaledOptions how;
        how.journal.path = journal;
        how.journal.instruction_set = contents->meta.instruction_set;
        how.threads = threads;
        how.stop = background.stop;
        how.progress = [&](const calibrate::BatchProgress& done) {
          if (file.cases.size() < 2 || done.total == 0) return;
          background.set_progress(static_cast<double>(done.done) / static_cast<double>(done.total));
        };
        calibrate::JournaledSceneFits batch(file.cases, file.options, how, {});
        std::vector<calibrate::SceneFitResult> results = batch.run();
        if (!batch.complete()) return;
        for (std::size_t i = 0; i < results.size(); ++i) {
          contents->records.push_back(
              record_of(file.cases[batch.fits()[i].of], std::move(results[i])));
          contents->records.back().seconds = batch.seconds()[i];
        }
        calibrate::put_in_order(contents->records);
        contents->run = batch.run_id();
        batch.finish();
      },
      progress);
  contents->meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return contents;
}

calibrate::ReportOptions report_options(const SceneFitContents& contents) {
  calibrate::ReportOptions options;
  options.confidence = contents.confidence;
  return options;
}

/// What a fit made of each of its targets, by their names.
py::dict targets_of(const py::object& self) {
  const SceneFitRecord& record = self.cast<const SceneFitView&>().record();
  py::dict targets;
  for (std::size_t i = 0; i < record.targets.size(); ++i) {
    const calibrate::SceneTarget& target = record.targets[i];
    py::dict one;
    one["abscissa"] = view_of(target.abscissa, self);
    one["ordinate"] = view_of(target.ordinate, self);
    one["abscissa_name"] =
        target.abscissa_probe.empty()
            ? std::string(
                  calibrate::words_of<calibrate::Abscissa>()[static_cast<std::size_t>(target.kind)])
            : target.abscissa_probe;
    one["ordinate_name"] = target.ordinate_probe;
    one["abscissa_unit"] = si_unit(target.abscissa_is);
    one["ordinate_unit"] = si_unit(target.ordinate_is);
    if (i < record.result.targets.size()) {
      const calibrate::TargetFit& fit = record.result.targets[i];
      one["fitted"] = view_of(fit.fitted, self);
      one["fitted_error"] = view_of(fit.fitted_error, self);
      one["noise"] = fit.noise;
      one["misfit_fraction"] = fit.misfit_fraction;
      one["runs_test_p"] = fit.runs_test_p;
      one["break_strain"] = fit.break_strain;
    }
    targets[py::str(target.name)] = one;
  }
  return targets;
}

py::object segments_of(const SceneFitView& view) {
  const auto& segments = view.record().result.segments;
  if (!segments) return py::none();
  py::dict by_parameter;
  for (std::size_t k = 0; k < segments->parameters.size(); ++k) {
    const calibrate::SegmentsError& error = segments->parameters[k];
    py::dict one;
    one["at_half"] = error.at_half;
    one["at_own"] = error.at_own;
    one["at_twice"] = error.at_twice;
    one["trend"] = name_of(error.trend);
    one["observed_order"] = error.observed_order;
    one["extrapolated"] = error.extrapolated;
    one["extrapolated_error"] = error.extrapolated_error;
    one["error"] = error.error;
    by_parameter[py::str(view.outcome().parameters[k].name())] = one;
  }
  return by_parameter;
}

}  // namespace

void bind_scene_fits(py::module_& core) {
  bind_record<SceneFitView>(core, "SceneFit")
      .def_property_readonly(
          "usable", [](const SceneFitView& view) { return is_usable(view.record().result); })
      .def_property_readonly(
          "why_unusable",
          [](const SceneFitView& view) { return why_unusable(view.record().result); })
      .def_property_readonly("targets", &targets_of)
      .def_property_readonly("segments", &segments_of)
      .def_property_readonly(
          "evaluations",
          [](const SceneFitView& view) { return view.record().result.evaluations(); })
      .def_property_readonly("runs",
                             [](const SceneFitView& view) { return view.record().result.runs; })
      .def("report", [](const SceneFitView& view) {
        return calibrate::scene_fit_report(view.record(), report_options(*view.contents));
      });
  py::class_<SceneFitFile>(core, "SceneFits")
      .def(py::init([](const std::string& path) {
             return in_background([&] { return calibrate::read_scene_fit_file(path); });
           }),
           py::arg("path"))
      .def("set_laws",
           [](SceneFitFile& file, const std::vector<std::string>& laws) {
             file.options.laws = calibrate::laws_of(laws, "laws");
           })
      .def("set_intervals",
           [](SceneFitFile& file, bool profile, int bootstrap, int block, int specimens) {
             set_intervals(profile, bootstrap, block, specimens, file.options.intervals);
           })
      .def("rename", &rename, py::arg("names"))
      .def_readonly("notes", &SceneFitFile::notes)
      .def("run", &run_scene_fits, py::arg("journal"), py::arg("threads"), py::arg("progress"));
  auto type = py::class_<SceneFitContents, Contents>(core, "SceneFitContents");
  type.def("__len__", [](const SceneFitContents& contents) { return contents.records.size(); })
      .def("record",
           [](const Contents& contents, std::size_t index) {
             return SceneFitView{contents, index};
           })
      .def_readonly("confidence", &SceneFitContents::confidence)
      .def_property_readonly(
          "inputs", [](const SceneFitContents& contents) { return texts_of(contents.inputs); })
      .def_property_readonly("advised", &advised_law<SceneFitContents>)
      .def(
          "report",
          [](const SceneFitContents& contents, bool all) {
            std::vector<SceneFitRecord> records = contents.records;
            return calibrate::fits_text(records, report_options(contents), all);
          },
          py::arg("all"))
      .def("json", [](const SceneFitContents& contents) {
        return calibrate::json_summary(contents.records, contents.confidence);
      });
  bind_files<SceneFitContents>(
      core, type, "read_scene_fits",
      [](const std::string& path) { return calibrate::read_scene_fit_store(path); },
      [](const std::string& path, const SceneFitContents& contents, io::Overwrite overwrite) {
        calibrate::write_scene_fit_store(path, contents, overwrite);
      });
  core.def("names_scenes", &calibrate::names_scenes, py::arg("path"));
}

}  // namespace plastica::python
