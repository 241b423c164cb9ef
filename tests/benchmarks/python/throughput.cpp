#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "calibrate/config/fit_file.hpp"
#include "calibrate/fit/fit.hpp"
#include "calibrate/target/make.hpp"
#include "plastica/base/keep_freed_memory.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/run/batch.hpp"

/// throughput SCENE.toml FIT.toml CASES CURVES: what throughput.py does from Python, in C++: a
/// batch of one model with values of its modulus, and fits of copies of a curve. Prints the seconds
/// of both.
namespace plastica {
namespace {

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double run_cases(const std::string& path, std::size_t cases) {
  const io::SceneFile file = io::read_scene_file(path);
  const std::vector<std::string> parameters{"material.youngs_modulus"};
  const Model model = prepare(file.setup.scene, file.setup.solver, parameters);
  std::vector<double> values(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    values[i] = 200e9 + 10e9 * static_cast<double>(i) / static_cast<double>(cases);
  }
  std::vector<std::vector<double>> histories(cases);
  BatchOptions options;
  options.threads = 1;
  return seconds_of([&] {
    const auto take = [&](std::size_t i, Response&& response) {
      histories[i] = std::move(response.probes[0]);
    };
    run_batch(model, values, cases, take, options);
  });
}

double fit_curves(const std::string& path, std::size_t curves) {
  calibrate::FitFile file = calibrate::read_fit_file(path);
  const calibrate::Curve curve = calibrate::import_all(file).front().raw;
  file.options.keep_trace = false;
  return seconds_of([&] {
    std::vector<calibrate::Target> targets;
    for (std::size_t i = 0; i < curves; ++i) {
      targets.push_back(calibrate::make_target(std::to_string(i), curve));
    }
    calibrate::BatchFitOptions batch;
    batch.threads = 1;
    (void)calibrate::fit(targets, file.options, batch);
  });
}

}  // namespace
}  // namespace plastica

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  plastica::keep_freed_memory();
  std::printf("%.6f %.6f\n", plastica::run_cases(argv[1], std::stoul(argv[3])),
              plastica::fit_curves(argv[2], std::stoul(argv[4])));
  return 0;
}
