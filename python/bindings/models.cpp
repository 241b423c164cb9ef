#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "plastica/run/batch.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/response_size.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/background.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/response_view.hpp"
#include "python/bindings/result_files.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Record = std::shared_ptr<io::SceneRecord>;
using SharedModel = std::shared_ptr<const Model>;

std::vector<std::string> names_of(const std::vector<Probe>& probes) {
  std::vector<std::string> names;
  names.reserve(probes.size());
  for (const Probe& probe : probes) names.push_back(probe.name);
  return names;
}

ResponseView view_of_record(const Record& record) {
  const Scene& scene = record->setup.scene;
  // A response lives as long as its record.
  return {{record, &record->response}, names_of(scene.probes), scene.drive.strain};
}

/// A model with what a run of it is told besides.
struct PreparedScene {
  io::SceneFile file;
  SharedModel model;

  std::vector<std::string> probe_names() const { return names_of(file.setup.scene.probes); }
  /// When a run ends [s], where its time is not that of loads alone; 0 of others.
  double duration() const { return is_motion(*model) ? model->chain->stops.back() : 0.0; }
};

PreparedScene prepared(std::string text, const std::string& name,
                       const std::vector<std::string>& parameters) {
  PreparedScene scene{io::parse_scene_file(std::move(text), name), nullptr};
  io::with_place_in(scene.file, [&] {
    const Setup& setup = scene.file.setup;
    check_memory(setup.scene, setup.solver);
    scene.model = std::make_shared<const Model>(prepare(setup.scene, setup.solver, parameters));
  });
  return scene;
}

/// Runs a model and listens for Ctrl-C; a motion says its time.
void run_listening(const PreparedScene& scene, std::span<const double> values, Response& response,
                   const py::object& progress) {
  in_background(
      [&](const Background& background) {
        Workspace workspace = make_workspace(*scene.model);
        workspace.stop = background.stop;
        if (is_motion(*scene.model) && !progress.is_none()) {
          workspace.on_progress = [&background](double time) {
            background.set_progress(time);
            return true;
          };
        }
        run(*scene.model, values, workspace, response);
      },
      progress);
}

Record simulate_scene(const PreparedScene& scene, const py::object& progress) {
  const auto begin = std::chrono::steady_clock::now();
  io::RunMeta meta = io::begin_meta("", 1);
  meta.instruction_set = name_of(resolved(scene.file.setup.solver.isa));
  Response response = make_response(*scene.model);
  run_listening(scene, {}, response, progress);
  auto record = std::make_shared<io::SceneRecord>(
      io::make_scene_record(scene.file, *scene.model, std::move(response)));
  meta.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record->meta = std::move(meta);
  return record;
}

std::span<const double> checked(const PreparedScene& scene, const Values& values) {
  const std::size_t wanted = scene.model->parameters.size();
  if (values.ndim() != 1 || static_cast<std::size_t>(values.shape(0)) != wanted) {
    throw InputError({}, "values", "",
                     "must be " + std::to_string(wanted) + " numbers, one for each parameter");
  }
  return {values.data(), wanted};
}

ResponseView run_prepared(const PreparedScene& scene, const Values& values,
                          const py::object& progress) {
  const auto numbers = checked(scene, values);
  auto response = std::make_shared<Response>(make_response(*scene.model));
  if (scene.model->chain) {
    run_listening(scene, numbers, *response, progress);
  } else {  // a coupon takes less time than a thread
    Workspace workspace = make_workspace(*scene.model);
    run(*scene.model, numbers, workspace, *response);
  }
  io::keep_valid_samples(*response);
  return {std::move(response), scene.probe_names(), scene.model->drive};
}

/// Numbers of the cases of a batch, one array each.
class BatchColumns {
 public:
  BatchColumns(const PreparedScene& scene, std::size_t cases)
      : samples_(sample_count(scene)),
        probes_(scene.file.setup.scene.probes.size()),
        status_(size(cases)),
        valid_(size(cases)),
        iterations_(size(cases)),
        permanent_(size(cases)),
        balance_(size(cases)),
        seconds_(size(cases)),
        values_({size(probes_), size(cases), size(samples_)}) {
    status_out_ = status_.mutable_data();
    valid_out_ = valid_.mutable_data();
    iterations_out_ = iterations_.mutable_data();
    permanent_out_ = permanent_.mutable_data();
    balance_out_ = balance_.mutable_data();
    seconds_out_ = seconds_.mutable_data();
    values_out_ = values_.mutable_data();
    cases_ = cases;
    for (std::size_t i = 0; i < cases; ++i) take(i, Response{});  // not begun
  }

  void take(std::size_t i, const Response& response) {
    const bool begun = response.status != Status::NotRun;
    status_out_[i] = static_cast<std::uint8_t>(response.status);
    valid_out_[i] = static_cast<std::int64_t>(response.samples);
    iterations_out_[i] = response.counters.iterations;
    const bool has_numbers = begun && response.samples > 0;
    permanent_out_[i] = has_numbers ? response.permanent_strain : kNone;
    balance_out_[i] = has_numbers ? response.energy_balance_error : kNone;
    seconds_out_[i] = begun ? response.seconds : kNone;
    for (std::size_t p = 0; p < probes_; ++p) {
      double* row = values_out_ + (p * cases_ + i) * samples_;
      for (std::size_t s = 0; s < samples_; ++s) {
        row[s] = s < response.samples && p < response.probes.size() ? response.probes[p][s] : kNone;
      }
    }
  }

  py::dict columns() const {
    py::dict all;
    all["status"] = status_;
    all["samples"] = valid_;
    all["newton_iterations"] = iterations_;
    all["permanent_strain"] = permanent_;
    all["energy_balance_error"] = balance_;
    all["seconds"] = seconds_;
    all["probes"] = values_;
    return all;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static py::ssize_t size(std::size_t count) { return static_cast<py::ssize_t>(count); }
  static std::size_t sample_count(const PreparedScene& scene) {
    return response_size(*scene.model).samples;
  }

  std::size_t samples_, probes_, cases_ = 0;
  py::array_t<std::uint8_t> status_;
  py::array_t<std::int64_t> valid_, iterations_;
  py::array_t<double> permanent_, balance_, seconds_, values_;
  std::uint8_t* status_out_;
  std::int64_t *valid_out_, *iterations_out_;
  double *permanent_out_, *balance_out_, *seconds_out_, *values_out_;
};

py::dict run_prepared_batch(const PreparedScene& scene, const Values& values, int threads,
                            const py::object& progress) {
  const std::size_t parameters = scene.model->parameters.size();
  if (values.ndim() != 2 || static_cast<std::size_t>(values.shape(1)) != parameters) {
    throw InputError({}, "values", "",
                     "must have a row for each case and " + std::to_string(parameters) +
                         " columns, one for each parameter");
  }
  const auto cases = static_cast<std::size_t>(values.shape(0));
  BatchColumns columns(scene, cases);
  const std::span<const double> numbers{values.data(), cases * parameters};
  in_background(
      [&](const Background& background) {
        BatchOptions options;
        options.threads = threads;
        options.stop = background.stop;
        options.progress = [&background](std::size_t finished) {
          background.set_progress(static_cast<double>(finished));
        };
        run_batch(
            *scene.model, numbers, cases,
            [&](std::size_t i, Response&& response) { columns.take(i, response); }, options);
      },
      progress);
  return columns.columns();
}

py::tuple differentiate(const PreparedScene& scene, const Values& values) {
  const auto numbers = checked(scene, values);
  const Model& model = *scene.model;
  const bool one_stress = model.probes.size() == 1 && model.probes[0] == ProbeQuantity::Stress;
  if (model.chain || !one_stress || model.coupon.breaks()) {
    throw InputError({}, "run_sensitivity", "",
                     "needs a coupon without break limits whose one probe is the stress");
  }
  auto response = std::make_shared<Response>(make_response(*scene.model));
  Sensitivity sensitivity = make_sensitivity(*scene.model);
  Workspace workspace = make_workspace(*scene.model);
  run_sensitivity(*scene.model, numbers, workspace, *response, sensitivity);
  if (!usable(response->status)) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::ranges::fill(sensitivity.stress, kNone);
    std::ranges::fill(sensitivity.permanent_strain, kNone);
  }
  const auto parameters = static_cast<py::ssize_t>(numbers.size());
  const auto samples = static_cast<py::ssize_t>(scene.model->drive.size());
  const py::array_t<double> by_sample({samples, parameters}, sensitivity.stress.data());
  const py::array_t<double> permanent(parameters, sensitivity.permanent_strain.data());
  return py::make_tuple(ResponseView{std::move(response), scene.probe_names(), scene.model->drive},
                        by_sample, permanent);
}

/// By the probes' names.
py::dict probe_units(const PreparedScene& prepared) {
  const Scene& scene = prepared.file.setup.scene;
  py::dict units;
  for (const Probe& probe : scene.probes) {
    units[py::str(probe.name)] = si_unit(dimension_of(probe.quantity, scene.drive.deformation));
  }
  return units;
}

std::vector<std::string> parameter_paths(const PreparedScene& scene) {
  std::vector<std::string> paths;
  for (const Field* field : scene.model->parameters) paths.emplace_back(field->path);
  return paths;
}

std::vector<std::string> words_of_status() {
  const auto words = io::status_words();
  return {words.begin(), words.end()};
}

}  // namespace

void bind_models(py::module_& core) {
  core.def("status_words", &words_of_status);
  py::class_<PreparedScene>(core, "PreparedScene")
      .def(py::init(&prepared), py::arg("text"), py::arg("name"), py::arg("parameters"))
      .def_property_readonly("parameters", &parameter_paths)
      .def_property_readonly("probe_names", &PreparedScene::probe_names)
      .def_property_readonly("probe_units", &probe_units)
      .def_property_readonly("notes", [](const PreparedScene& scene) { return scene.file.notes; })
      .def_property_readonly("level_reason",
                             [](const PreparedScene& scene) { return scene.model->level_reason; })
      .def_property_readonly(
          "warnings", [](const PreparedScene& scene) { return scene_warnings(*scene.model); })
      .def_property_readonly("duration", &PreparedScene::duration)
      .def_property_readonly("riding",
                             [](const PreparedScene& scene) { return riding_of(*scene.model); })
      .def_property_readonly(
          "bytes", [](const PreparedScene& scene) { return response_size(*scene.model).bytes(); })
      .def_property_readonly("drive",
                             [](const py::object& self) {
                               return view_of(self.cast<const PreparedScene&>().model->drive, self);
                             })
      .def("simulate", &simulate_scene, py::arg("progress"))
      .def("run", &run_prepared, py::arg("values"), py::arg("progress"))
      .def("run_batch", &run_prepared_batch, py::arg("values"), py::arg("threads"),
           py::arg("progress"))
      .def("differentiate", &differentiate, py::arg("values"));
  auto type = py::class_<io::SceneRecord, Record>(core, "SceneRecord");
  type.def_property_readonly("response", &view_of_record)
      .def_property_readonly("name",
                             [](const io::SceneRecord& record) { return record.setup.scene.name; })
      .def_readonly("level_reason", &io::SceneRecord::level_reason)
      .def_readonly("warnings", &io::SceneRecord::warnings)
      .def_property_readonly("inputs",
                             [](const io::SceneRecord& record) { return texts_of(record.inputs); })
      .def("report", [](const io::SceneRecord& record) { return report::scene_report(record); })
      .def("json", [](const io::SceneRecord& record) { return report::scene_json(record); });
  bind_files<io::SceneRecord>(
      core, type, "read_scene", [](const std::string& path) { return io::read_scene_store(path); },
      [](const std::string& path, const io::SceneRecord& record, io::Overwrite overwrite) {
        io::write_scene_store(path, record, overwrite);
      });
  core.def(
      "read_scene_file",
      [](const std::string& path) {
        const io::SceneFile file = io::read_scene_file(path);
        return py::make_tuple(file.text, file.notes);
      },
      py::arg("path"));
  core.def("schema_of", &io::schema_of, py::arg("path"));
}

}  // namespace plastica::python
