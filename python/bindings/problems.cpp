#include "python/bindings/problems.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace plastica::python {

using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The cost of a coupon's fit as residuals, for searches and samplers of the user's own. Priors are
/// not in it: what they weigh beside the curve only a fit knows. A free break strain is no unknown:
/// it follows.
class CurveProblem {
 public:
  CurveProblem(calibrate::Target target, calibrate::FitOptions options)
      : target_(std::move(target)),
        options_(std::move(options)),
        set_(target_, options_),
        misfit_(target_, options_, set_) {
    const auto active = set_.active();
    for (std::size_t k = 0; k < active.size(); ++k) {
      const calibrate::ResolvedParameter& one = set_.all()[active[k]];
      values_.push_back(one.start);
      if (!one.is_break) searched_.push_back(k);
    }
  }
  CurveProblem(const CurveProblem&) = delete;
  CurveProblem& operator=(const CurveProblem&) = delete;

  std::vector<std::string> paths() const {
    std::vector<std::string> paths;
    for (const std::size_t k : searched_) paths.emplace_back(parameter(k).field->path);
    return paths;
  }
  py::array_t<double> start() const {
    return numbers([](const calibrate::ResolvedParameter& one) { return one.start; });
  }
  py::array_t<double> lower() const {
    return numbers([](const calibrate::ResolvedParameter& one) { return one.lower; });
  }
  py::array_t<double> upper() const {
    return numbers([](const calibrate::ResolvedParameter& one) { return one.upper; });
  }

  /// sqrt(w_i) (model - measured) [Pa], and last the break term's; their squares add up to the
  /// cost.
  py::array_t<double> residuals(const Values& x) {
    const calibrate::Misfit::Details details = evaluate(x);
    return weighted(details);
  }

  /// Slopes of these by the parameters, and the residuals (m x n), (m).
  py::tuple jacobian(const Values& x) {
    const calibrate::Misfit::Details details = evaluate(x);
    const py::array_t<double> residual = weighted(details);
    const auto samples = details.residual.size();
    const std::size_t rows = samples + 1;
    py::array_t<double> slopes(
        {static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(searched_.size())});
    auto out = slopes.mutable_unchecked<2>();
    const auto weight = misfit_.weights();
    std::vector<double> gradient(values_.size());
    misfit_.search_cost(values_, gradient);
    const double* r = residual.data();
    for (std::size_t c = 0; c < searched_.size(); ++c) {
      const double* column = details.jacobian.data() + searched_[c] * samples;
      const auto k = static_cast<py::ssize_t>(c);
      double of_samples = 0.0;
      for (std::size_t i = 0; i < samples; ++i) {
        const double slope = std::sqrt(weight[i]) * column[i];
        out(static_cast<py::ssize_t>(i), k) = slope;
        of_samples += r[i] * slope;
      }
      // What the gradient of the cost, 2 J^T r, has beyond the samples is the break's.
      out(static_cast<py::ssize_t>(samples), k) =
          r[samples] != 0.0 ? (0.5 * gradient[searched_[c]] - of_samples) / r[samples] : 0.0;
    }
    return py::make_tuple(slopes, residual);
  }

  double cost(const Values& x) {
    set(x);
    return misfit_.search_cost(values_, {});
  }

  /// The model's stress at the corrected samples [Pa] (n_samples).
  py::array_t<double> model(const Values& x) {
    const calibrate::Misfit::Details details = evaluate(x);
    py::array_t<double> stress(static_cast<py::ssize_t>(details.residual.size()));
    for (std::size_t i = 0; i < details.residual.size(); ++i) {
      stress.mutable_data()[i] = target_.corrected.stress[i] + details.residual[i];
    }
    return stress;
  }

  const calibrate::Target& target() const { return target_; }

 private:
  const calibrate::ResolvedParameter& parameter(std::size_t active) const {
    return set_.all()[set_.active()[active]];
  }
  template <class Of>
  py::array_t<double> numbers(const Of& of) const {
    py::array_t<double> all(static_cast<py::ssize_t>(searched_.size()));
    for (std::size_t k = 0; k < searched_.size(); ++k) {
      all.mutable_data()[k] = of(parameter(searched_[k]));
    }
    return all;
  }

  void set(const Values& x) {
    if (x.ndim() != 1 || static_cast<std::size_t>(x.shape(0)) != searched_.size()) {
      throw InputError(
          {}, "x", "",
          "must be " + std::to_string(searched_.size()) + " numbers, one for each parameter");
    }
    for (std::size_t k = 0; k < searched_.size(); ++k) values_[searched_[k]] = x.data()[k];
  }

  calibrate::Misfit::Details evaluate(const Values& x) {
    set(x);
    if (!std::isfinite(misfit_.search_cost(values_, {}))) {
      throw InputError({}, "x", "", "is where the model cannot be run: out of a field's range");
    }
    return misfit_.details(values_);
  }

  py::array_t<double> weighted(const calibrate::Misfit::Details& details) {
    const std::size_t samples = details.residual.size();
    py::array_t<double> residual(static_cast<py::ssize_t>(samples + 1));
    const auto weight = misfit_.weights();
    for (std::size_t i = 0; i < samples; ++i) {
      residual.mutable_data()[i] = std::sqrt(weight[i]) * details.residual[i];
    }
    misfit_.search_cost(values_, {});
    residual.mutable_data()[samples] = misfit_.break_residual();
    return residual;
  }

  calibrate::Target target_;
  calibrate::FitOptions options_;
  calibrate::ParameterSet set_;
  calibrate::Misfit misfit_;
  std::vector<double> values_;         ///< of the active parameters [SI] (n_active)
  std::vector<std::size_t> searched_;  ///< active index of each unknown (n)
};

py::object make_problem(calibrate::Target target, calibrate::FitOptions options) {
  if (target.status != calibrate::TargetStatus::Ready) {
    throw InputError({}, target.name, "", "cannot be fitted: " + target.reason);
  }
  for (calibrate::Parameter& one : options.parameters) {
    if (one.prior) {
      throw InputError({}, "prior", "", "is no part of a problem: add it to your own cost");
    }
  }
  return py::cast(std::make_shared<CurveProblem>(std::move(target), std::move(options)));
}

void bind_problems(py::module_& core) {
  py::class_<CurveProblem, std::shared_ptr<CurveProblem>>(core, "CurveProblem")
      .def_property_readonly("parameters", &CurveProblem::paths)
      .def_property_readonly("start", &CurveProblem::start)
      .def_property_readonly("lower", &CurveProblem::lower)
      .def_property_readonly("upper", &CurveProblem::upper)
      .def_property_readonly("strain",
                             [](const py::object& self) {
                               const auto& problem = self.cast<const CurveProblem&>();
                               return view_of(problem.target().corrected.strain, self);
                             })
      .def_property_readonly("stress",
                             [](const py::object& self) {
                               const auto& problem = self.cast<const CurveProblem&>();
                               return view_of(problem.target().corrected.stress, self);
                             })
      .def("residuals", &CurveProblem::residuals, py::arg("x"))
      .def("jacobian", &CurveProblem::jacobian, py::arg("x"))
      .def("model", &CurveProblem::model, py::arg("x"))
      .def("cost", &CurveProblem::cost, py::arg("x"));
}

}  // namespace plastica::python
