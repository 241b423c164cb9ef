#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/config/bare_files.hpp"
#include "calibrate/config/fit_file.hpp"
#include "calibrate/fit/fit.hpp"
#include "calibrate/report/fits_text.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/result/words.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/store/journaled_batch.hpp"
#include "calibrate/target/group_values.hpp"
#include "calibrate/target/make.hpp"
#include "calibrate/target/plausibility.hpp"
#include "plastica/base/parallel_for.hpp"
#include "python/bindings/background.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/fit_records.hpp"
#include "python/bindings/problems.hpp"
#include "python/bindings/result_files.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

using calibrate::FitFile;
using calibrate::FitRecord;
using calibrate::FitStoreContents;
using calibrate::Target;
using Contents = std::shared_ptr<FitStoreContents>;
using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What is to be fitted, and how: a fit file, bare files or curves of the program's own.
struct CurveFits {
  FitFile file;
  std::vector<Target> targets;  ///< empty until `import`, of files
};

std::vector<double> values_of(const Values& values, const std::string& name, const char* what) {
  if (values.ndim() != 1) {
    throw InputError({}, name, "", std::string(what) + " must be one row of numbers");
  }
  return {values.data(), values.data() + values.shape(0)};
}

using GivenCurve =
    std::tuple<std::string, Values, Values, std::vector<std::pair<std::string, std::string>>>;

/// Curves of the program's own. @param text  what a fit file would say of them
CurveFits of_curves(std::string text, const std::vector<GivenCurve>& curves, bool accept) {
  CurveFits fits{calibrate::parse_curve_options(std::move(text), ""), {}};
  calibrate::TargetBlock& block = fits.file.targets.front();
  calibrate::TargetOptions& options = block.options;
  options.test = block.source.test;
  options.measure = block.source.measure.value_or(calibrate::Measure::Engineering);
  if (block.source.loading) options.loading = block.source.loading;
  options.accept = options.accept || accept;
  std::vector<calibrate::Curve> given;
  for (const auto& [name, strain, stress, group] : curves) {
    calibrate::Curve curve{values_of(strain, name, "strain"), values_of(stress, name, "stress")};
    if (curve.strain.size() != curve.stress.size()) {
      throw InputError({}, name, "",
                       "has " + std::to_string(curve.strain.size()) + " strains and " +
                           std::to_string(curve.stress.size()) +
                           " stresses: must be as many of both");
    }
    if (curve.strain.empty()) throw InputError({}, name, "", "has no samples");
    given.push_back(std::move(curve));
  }
  fits.targets.resize(given.size());
  in_background([&] {
    parallel_for(given.size(), {}, [&](std::size_t i, int) {
      fits.targets[i] =
          calibrate::make_target(std::get<0>(curves[i]), std::move(given[i]), options);
      fits.targets[i].group = std::get<3>(curves[i]);
    });
    calibrate::GroupValues().unite(fits.targets);
    calibrate::check_groups(fits.targets, options);
    return true;
  });
  return fits;
}

CurveFits of_bare_files(const std::vector<std::string>& files,
                        const std::map<std::string, std::string>& columns,
                        const std::vector<std::string>& group, std::string says, bool accept) {
  calibrate::BareFiles bare;
  bare.files = files;
  const std::pair<const char*, std::optional<std::string>*> texts[] = {
      {"strain", &bare.strain},   {"elongation", &bare.elongation},
      {"stress", &bare.stress},   {"gauge_length", &bare.gauge_length},
      {"force", &bare.force},     {"area", &bare.area},
      {"decimal", &bare.decimal}, {"sheet", &bare.sheet},
      {"path", &bare.path},       {"test", &bare.test},
      {"table", &bare.table},     {"measure", &bare.measure}};
  for (const auto& [name, member] : texts) {
    if (const auto found = columns.find(name); found != columns.end()) *member = found->second;
  }
  bare.group = group;
  bare.says = std::move(says);
  CurveFits fits{in_background([&] { return calibrate::fit_of_bare_files(bare); }), {}};
  for (calibrate::TargetBlock& block : fits.file.targets) block.options.accept |= accept;
  return fits;
}

Contents run_fits(CurveFits& fits, int threads, const py::object& progress) {
  const auto begin = std::chrono::steady_clock::now();
  auto contents = std::make_shared<FitStoreContents>();
  contents->meta = io::begin_meta("", threads);
  contents->meta.versions.emplace_back("nlopt", calibrate::nlopt_version());
  calibrate::FitOptions& options = fits.file.options;
  contents->meta.instruction_set = name_of(resolved(options.setup.solver.isa));
  in_background(
      [&](const Background& background) {
        contents->inputs = calibrate::input_texts(fits.file);
        if (fits.file.path.empty()) contents->inputs.front().name = "python.toml";
        if (fits.targets.empty()) fits.targets = calibrate::import_all(fits.file, threads);
        const auto cases = calibrate::cases_of(fits.targets.size(), options);
        options.keep_trace = cases.size() <= calibrate::kTracedFits;
        contents->run = calibrate::run_id(fits.targets, options, threads);
        calibrate::BatchFitOptions batch;
        batch.threads = threads;
        batch.stop = background.stop;
        std::size_t done = 0;
        batch.finished = [&](std::size_t, calibrate::FitResult&) {
          background.set_progress(static_cast<double>(++done) / static_cast<double>(cases.size()));
        };
        auto results = calibrate::fit(fits.targets, options, batch);
        if (is_raised(background.stop)) return;
        for (std::size_t i = 0; i < results.size(); ++i) {
          contents->records.push_back({fits.targets[cases[i].target], std::move(results[i])});
        }
        calibrate::put_in_order(contents->records);
      },
      progress);
  contents->options = options;
  contents->meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return contents;
}

/// The cost of the one fit as a function.
py::object problem_of(CurveFits& fits) {
  if (fits.targets.empty()) {
    fits.targets = in_background([&] { return calibrate::import_all(fits.file); });
  }
  if (fits.targets.size() != 1) {
    throw InputError({}, "curves", std::to_string(fits.targets.size()), "must be one specimen");
  }
  return make_problem(fits.targets.front(), fits.file.options);
}

calibrate::ReportOptions report_options(const FitStoreContents& contents) {
  calibrate::ReportOptions options;
  options.confidence = contents.options.confidence;
  options.specimen_resamples = contents.options.intervals.specimens;
  options.seed = contents.options.seed;
  return options;
}

std::string report_of(const FitStoreContents& contents, bool all) {
  std::vector<FitRecord> records = contents.records;
  return calibrate::fits_text(records, report_options(contents), all);
}

py::dict characteristics(const CurveFitView& view) {
  py::dict values;
  for (const auto& entry : calibrate::characteristic_entries()) {
    const auto value = calibrate::shown(entry, view.record().target.characteristics);
    values[py::str(std::string(entry.name))] = value ? py::cast(*value) : py::none();
  }
  return values;
}

/// Strain and stress of a curve of a record.
template <class Part>
auto curve_of(const Part& part) {
  return [part](const py::object& self) {
    const calibrate::Curve& curve = part(self.cast<const CurveFitView&>().record());
    return py::make_tuple(view_of(curve.strain, self), view_of(curve.stress, self));
  };
}

std::vector<std::string> repairs(const CurveFitView& view) {
  std::vector<std::string> lines;
  const calibrate::Target& target = view.record().target;
  for (const auto& repair : target.repairs) lines.push_back(repair.kind + ": " + repair.text);
  for (const auto& correction : target.corrections) {
    if (correction.applied) lines.push_back(correction.kind + ": " + correction.text);
  }
  return lines;
}

void bind_view(py::module_& core) {
  const auto number = [](auto member) {
    return [member](const CurveFitView& view) { return view.record().result.*member; };
  };
  using calibrate::FitResult;
  bind_record<CurveFitView>(core, "CurveFit")
      .def_property_readonly(
          "usable", [](const CurveFitView& view) { return is_usable(view.record().result); })
      .def_property_readonly(
          "why_unusable",
          [](const CurveFitView& view) { return why_unusable(view.record().result); })
      .def_property_readonly("cost", number(&FitResult::cost))
      .def_property_readonly("misfit", number(&FitResult::misfit_rms))
      .def_property_readonly("misfit_fraction", number(&FitResult::misfit_fraction))
      .def_property_readonly("misfit_word", number(&FitResult::misfit_word))
      .def_property_readonly("runs_test_p", number(&FitResult::runs_test_p))
      .def_property_readonly("samples", number(&FitResult::samples))
      .def_property_readonly("break_strain_total", number(&FitResult::break_strain_total))
      .def_property_readonly(
          "evaluations",
          [](const CurveFitView& view) { return view.record().result.evaluations(); })
      .def_property_readonly("target_status",
                             [](const CurveFitView& view) {
                               const auto words = calibrate::words_of<calibrate::TargetStatus>();
                               const auto status = view.record().target.status;
                               return words[static_cast<std::size_t>(status)];
                             })
      .def_property_readonly("target_reason",
                             [](const CurveFitView& view) { return view.record().target.reason; })
      .def_property_readonly("target_warnings",
                             [](const CurveFitView& view) { return view.record().target.warnings; })
      .def_property_readonly("file",
                             [](const CurveFitView& view) { return view.record().target.file; })
      .def_property_readonly("group",
                             [](const CurveFitView& view) {
                               py::dict group;
                               for (const auto& [key, value] : view.record().target.group) {
                                 group[py::str(key)] = value;
                               }
                               return group;
                             })
      .def_property_readonly("repairs", &repairs)
      .def_property_readonly("characteristics", &characteristics)
      .def_property_readonly(
          "measured", curve_of([](const FitRecord& r) -> const auto& { return r.target.raw; }))
      .def_property_readonly("corrected", curve_of([](const FitRecord& r) -> const auto& {
                               return r.target.corrected;
                             }))
      .def_property_readonly(
          "fitted", curve_of([](const FitRecord& r) -> const auto& { return r.result.fitted; }))
      .def("report", [](const CurveFitView& view) {
        return calibrate::fit_report(view.record(), report_options(*view.contents));
      });
}

}  // namespace

void bind_curve_fits(py::module_& core) {
  bind_view(core);
  py::class_<CurveFits>(core, "CurveFits")
      .def_static(
          "of_file",
          [](const std::string& path, bool accept) {
            CurveFits fits{calibrate::read_fit_file(path), {}};
            for (calibrate::TargetBlock& block : fits.file.targets) block.options.accept |= accept;
            return fits;
          },
          py::arg("path"), py::arg("accept"))
      .def_static("of_bare_files", &of_bare_files, py::arg("files"), py::arg("columns"),
                  py::arg("group"), py::arg("text"), py::arg("accept"))
      .def_static("of_curves", &of_curves, py::arg("text"), py::arg("curves"), py::arg("accept"))
      .def("set_laws",
           [](CurveFits& fits, const std::vector<std::string>& laws) {
             fits.file.options.laws = calibrate::laws_of(laws, "laws");
           })
      .def("set_intervals",
           [](CurveFits& fits, bool profile, int bootstrap, int block, int specimens) {
             set_intervals(profile, bootstrap, block, specimens, fits.file.options.intervals);
           })
      .def_property_readonly("notes", [](const CurveFits& fits) { return fits.file.notes; })
      .def("problem", &problem_of)
      .def("run", &run_fits, py::arg("threads"), py::arg("progress"));
  auto type = py::class_<FitStoreContents, Contents>(core, "CurveFitContents");
  type.def("__len__", [](const FitStoreContents& contents) { return contents.records.size(); })
      .def("record",
           [](const Contents& contents, std::size_t index) {
             return CurveFitView{contents, index};
           })
      .def_property_readonly(
          "confidence",
          [](const FitStoreContents& contents) { return contents.options.confidence; })
      .def_property_readonly(
          "inputs", [](const FitStoreContents& contents) { return texts_of(contents.inputs); })
      .def_property_readonly("advised", &advised_law<FitStoreContents>)
      .def("report", &report_of, py::arg("all"), py::call_guard<py::gil_scoped_release>())
      .def(
          "json",
          [](const FitStoreContents& contents) {
            const calibrate::FitOptions& fit = contents.options;
            return calibrate::json_summary(contents.records, 2,
                                           {fit.intervals.specimens, fit.seed, fit.confidence});
          },
          py::call_guard<py::gil_scoped_release>());
  bind_files<FitStoreContents>(
      core, type, "read_curve_fits",
      [](const std::string& path) { return calibrate::read_fit_store(path); },
      [](const std::string& path, const FitStoreContents& contents, io::Overwrite overwrite) {
        calibrate::write_fit_store(path, contents, overwrite);
      });
}

}  // namespace plastica::python
