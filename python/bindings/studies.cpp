#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/engine_world.hpp"
#include "plastica/io/scene_file.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/background.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/result_files.hpp"
#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/advice_json.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/check/run_check.hpp"
#include "sweeps/report/json.hpp"
#include "sweeps/report/text.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

using sweeps::SweepRecord;
using SweepHandle = std::shared_ptr<SweepRecord>;

py::object value_of(const FieldValue& value, bool whole) {
  if (const auto* number = std::get_if<double>(&value)) {
    return whole ? py::object(py::int_(static_cast<std::int64_t>(*number))) : py::cast(*number);
  }
  if (const auto* word = std::get_if<std::string>(&value)) return py::cast(*word);
  return py::none();
}

SweepHandle run_sweep(const sweeps::Sweep& sweep, int threads, const py::object& progress) {
  sweeps::check_reference(sweep, sweeps::CaseTable(sweep));
  const auto begin = std::chrono::steady_clock::now();
  io::RunMeta meta = io::begin_meta("", threads);
  meta.instruction_set = name_of(resolved(sweep.setup.solver.isa));
  auto record = std::make_shared<SweepRecord>();
  in_background(
      [&](const Background& background) {
        sweeps::SweepRunOptions how;
        how.threads = threads;
        how.stop = background.stop;
        sweeps::SweepRun run(sweep, std::move(how));
        run.on_progress([&](const sweeps::SweepProgress& done) {
          background.set_progress(static_cast<double>(done.done));
        });
        auto results = run.run();
        if (!run.complete()) return;
        *record = sweeps::make_record(sweep, run.cases(), run.ids(), std::move(results));
      },
      progress);
  meta.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record->meta = std::move(meta);
  return record;
}

/// What each case was and gave, a list for each column.
py::dict columns_of(const SweepRecord& record) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  py::dict columns;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    py::list values;
    const bool whole = record.axes[a].field->kind == FieldKind::Integer;
    for (std::size_t i = 0; i < record.cases(); ++i) {
      values.append(value_of(record.at(i, a), whole));
    }
    columns[py::str(std::string(record.axes[a].field->path))] = values;
  }
  const auto add = [&](const char* name, const auto& of) {
    py::list values;
    for (std::size_t i = 0; i < record.cases(); ++i) values.append(of(i));
    columns[name] = values;
  };
  const auto result = [&](std::size_t i) -> const sweeps::CaseResult& { return record.results[i]; };
  const auto& compared = record.comparison;
  add("status", [&](std::size_t i) { return name_of(result(i).status); });
  add("reason", [&](std::size_t i) {
    return result(i).reason.empty() ? compared.reason[i] : result(i).reason;
  });
  add("value", [&](std::size_t i) { return result(i).value.value_or(kNone); });
  add("reference", [&](std::size_t i) { return compared.reference[i].value_or(kNone); });
  add("error", [&](std::size_t i) { return compared.error[i].value_or(kNone); });
  add("reference_error", [&](std::size_t i) {
    return i < compared.reference_error.size() ? compared.reference_error[i].value_or(kNone)
                                               : kNone;
  });
  add("segment_iterations", [&](std::size_t i) { return result(i).segment_iterations(); });
  add("cutbacks", [&](std::size_t i) { return result(i).cutbacks; });
  add("energy_balance_error", [&](std::size_t i) { return result(i).energy_balance_error; });
  add("seconds", [&](std::size_t i) { return result(i).seconds; });
  return columns;
}

/// Curves of the cases that have one: time and value by the number of the case.
py::dict curves_of(const py::object& self) {
  const auto& record = self.cast<const SweepRecord&>();
  py::dict curves;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const sweeps::CaseResult& result = record.results[i];
    if (result.curve.empty()) continue;
    curves[py::int_(i)] = py::make_tuple(view_of(result.time, self), view_of(result.curve, self));
  }
  return curves;
}

constexpr const char* kAdviceEnds[] = {"found",    "too many runs", "too much work", "diverging",
                                       "too dear", "at finest",     "interrupted"};

/// Fields of a scene that advice sets, by their paths, and the lengths of graded segments.
py::dict advised_values(const Setup& before, const sweeps::Advice& advice) {
  const Setup after = sweeps::advised_setup(before, advice);
  py::dict values;
  for (const Field& field : fields()) {
    const FieldValue value = field.get(after);
    if (value != field.get(before)) {
      values[py::str(std::string(field.path))] = value_of(value, field.kind == FieldKind::Integer);
    }
  }
  return values;
}

py::dict advise(std::string text, const std::string& name, double within, double budget,
                const std::vector<std::string>& probes, int max_runs, double max_work, int threads,
                const py::object& progress) {
  const io::SceneFile file = io::parse_scene_file(std::move(text), name);
  sweeps::AdviceOptions options;
  options.within = within;
  options.budget = budget;
  options.probes = probes;
  options.max_runs = max_runs;
  options.max_work = max_work;
  options.threads = threads;
  sweeps::Advice advice;
  in_background(
      [&](const Background& background) {
        sweeps::AdviceOptions own = options;
        own.stop = background.stop;
        own.progress = [&](int runs) { background.set_progress(runs); };
        advice = io::with_place_in(file, [&] { return sweeps::advise(file.setup, own); });
      },
      progress);
  py::dict said;
  said["end"] = kAdviceEnds[static_cast<std::size_t>(advice.end)];
  said["found"] = advice.end == sweeps::AdviceEnd::Found;
  said["values"] = advised_values(file.setup, advice);
  said["segment_lengths"] = advice.fractions;
  said["promised"] = advice.promised;
  said["verified"] = advice.verified;
  said["expected_seconds"] = advice.expected_seconds;
  said["segment_iterations"] = advice.work;
  said["worst"] = advice.worst;
  said["reason"] = advice.reason;
  said["runs"] = advice.runs;
  said["warnings"] = advice.warnings;
  const std::string& own = file.setup.scene.name;
  const std::string shown = own.empty() ? "the scene" : own;
  said["report"] = sweeps::advice_text(advice, options, shown);
  said["json"] = sweeps::advice_json(advice, options, shown);
  return said;
}

py::list check(const sweeps::CheckFile& file, int threads, const py::object& progress) {
  std::vector<sweeps::ClaimVerdict> found;
  in_background(
      [&](const Background& background) {
        sweeps::CheckOptions options;
        options.threads = threads;
        options.stop = background.stop;
        options.progress = [&](std::size_t done) {
          background.set_progress(static_cast<double>(done));
        };
        found = sweeps::run_check(file, options);
      },
      progress);
  py::list verdicts;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const sweeps::ClaimVerdict& verdict = found[i];
    py::dict one;
    one["name"] = file.claims[i].name;
    one["holds"] = verdict.holds;
    one["number"] = verdict.number ? py::cast(*verdict.number) : py::none();
    one["found"] = verdict.found;
    one["reason"] = verdict.reason;
    one["at"] = verdict.at;
    one["beside"] = verdict.beside;
    one["warnings"] = verdict.warnings;
    one["judged"] = verdict.judged;
    py::list worst;
    for (const sweeps::JudgedNumber& number : verdict.worst) {
      worst.append(py::make_tuple(number.of, number.number, number.remark));
    }
    one["worst"] = std::move(worst);
    verdicts.append(one);
  }
  return verdicts;
}

std::string export_beam(std::string text, const std::string& name, const std::string& to,
                        const std::string& up, std::optional<double> gravity,
                        std::optional<double> damping_time, const std::string& contacts) {
  const io::SceneFile file = io::parse_scene_file(std::move(text), name);
  const auto index_of = [](const std::string& field, const std::string& word, const auto& words) {
    const auto found = std::ranges::find(words, word);
    if (found != std::end(words)) return found - std::begin(words);
    std::string rule = "must be one of";
    for (const auto each : words) rule += " " + std::string(each);
    throw InputError({}, field, word, rule);
  };
  const auto format =
      static_cast<calibrate::EngineFormat>(index_of("to", to, calibrate::engine_formats()));
  constexpr std::array<std::string_view, 3> kContacts{"none", "others", "all"};
  calibrate::EngineWorld world{.up = up};
  world.gravity = gravity;
  world.damping_time = damping_time;
  world.contacts =
      static_cast<calibrate::EngineContacts>(index_of("contacts", contacts, kContacts));
  return io::with_place_in(file, [&] {
    calibrate::EngineBeam beam = calibrate::engine_beam(file.setup.scene, file.setup.solver);
    calibrate::put_into(world, beam);
    return calibrate::engine_text(beam, format);
  });
}

}  // namespace

void bind_studies(py::module_& core) {
  py::class_<sweeps::Sweep>(core, "Sweep")
      .def(py::init([](const std::string& path) {
             return in_background([&] { return sweeps::read_sweep_file(path); });
           }),
           py::arg("path"))
      .def_property_readonly(
          "cases", [](const sweeps::Sweep& sweep) { return sweeps::CaseTable(sweep).size(); })
      .def_readonly("notes", &sweeps::Sweep::notes)
      .def("run", &run_sweep, py::arg("threads"), py::arg("progress"));
  auto type = py::class_<SweepRecord, SweepHandle>(core, "SweepRecord");
  type.def_readonly("name", &SweepRecord::name)
      .def_readonly("against", &SweepRecord::against)
      .def_readonly("warnings", &SweepRecord::warnings)
      .def_property_readonly("inputs",
                             [](const SweepRecord& record) { return texts_of(record.inputs); })
      .def_property_readonly("axes",
                             [](const SweepRecord& record) {
                               std::vector<std::string> paths;
                               for (const auto& axis : record.axes) {
                                 paths.emplace_back(axis.field->path);
                               }
                               return paths;
                             })
      .def("columns", &columns_of)
      .def("curves", &curves_of)
      .def("report", [](const SweepRecord& record) { return sweeps::sweep_report(record); })
      .def("json", &sweeps::sweep_json);
  bind_files<SweepRecord>(
      core, type, "read_sweep",
      [](const std::string& path) { return sweeps::read_sweep_store(path); },
      [](const std::string& path, const SweepRecord& record, io::Overwrite overwrite) {
        sweeps::write_sweep_store(path, record, overwrite);
      });
  core.def("advise", &advise, py::arg("text"), py::arg("name"), py::arg("within"),
           py::arg("budget"), py::arg("probes"), py::arg("max_runs"), py::arg("max_work"),
           py::arg("threads"), py::arg("progress"));
  py::class_<sweeps::CheckFile>(core, "CheckFile")
      .def(py::init([](const std::string& path) {
             return in_background([&] { return sweeps::read_check_file(path, {}); });
           }),
           py::arg("path"))
      .def_property_readonly("cases", &sweeps::cases_of)
      .def_readonly("notes", &sweeps::CheckFile::notes)
      .def("run", &check, py::arg("threads"), py::arg("progress"));
  core.def("export_beam", &export_beam, py::arg("text"), py::arg("name"), py::arg("to"),
           py::arg("up"), py::arg("gravity"), py::arg("damping_time"), py::arg("contacts"));
}

}  // namespace plastica::python
