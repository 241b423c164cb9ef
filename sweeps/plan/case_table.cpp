#include <algorithm>
#include <variant>

#include "plastica/base/instruction_set.hpp"
#include "plastica/base/renamed.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/scene_digest.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/run/taken_fibres.hpp"
#include "sweeps/plan/read_axes.hpp"
#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {
namespace {

/// What all cases run with; where an axis moves it, what "auto" is here.
InstructionSet common_instruction_set(const Sweep& sweep) {
  const bool varied = std::any_of(sweep.axes.begin(), sweep.axes.end(), [](const Axis& axis) {
    return axis.field->path == "solver.isa";
  });
  return varied ? InstructionSet::Auto : sweep.setup.solver.isa;
}

/// What besides the setup decides a case's result.
std::uint64_t quantity_digest(const Sweep& sweep) {
  const Quantity& q = sweep.quantity;
  io::Digest digest;
  digest.text(version()).text(name_of(resolved(common_instruction_set(sweep))));
  digest.integer(static_cast<std::uint64_t>(q.kind)).integer(q.probe);
  digest.integer(static_cast<std::uint64_t>(q.take)).integer(static_cast<std::uint64_t>(q.mode));
  digest.text(old_path(q.parameter)).integer(static_cast<std::uint64_t>(sweep.timed_runs));
  if (sweep.fit) digest.integer(digest_of(*sweep.fit));
  return digest.value();
}

}  // namespace

CaseTable::CaseTable(const Sweep& sweep) : sweep_(sweep), common_digest_(quantity_digest(sweep)) {
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    const auto same = std::find_if(wheels_.begin(), wheels_.end(), [&](const Wheel& wheel) {
      return !axis.group.empty() && sweep.axes[wheel.axes.front()].group == axis.group;
    });
    if (same != wheels_.end()) {
      same->axes.push_back(a);
    } else {
      wheels_.push_back({{a}, axis.values.size()});
    }
  }
  for (const Wheel& wheel : wheels_) size_ *= wheel.length;
}

std::vector<std::size_t> CaseTable::position(std::size_t index) const {
  std::vector<std::size_t> at(sweep_.axes.size());
  for (std::size_t w = wheels_.size(); w-- > 0;) {
    for (const std::size_t axis : wheels_[w].axes) at[axis] = index % wheels_[w].length;
    index /= wheels_[w].length;
  }
  return at;
}

Setup CaseTable::setup(std::size_t index) const {
  Setup setup = sweep_.setup;
  const std::vector<std::size_t> at = position(index);
  std::vector<const Field*> fields(at.size());
  std::vector<FieldValue> values(at.size());
  for (std::size_t a = 0; a < at.size(); ++a) {
    fields[a] = sweep_.axes[a].field;
    values[a] = sweep_.axes[a].values[at[a]];
  }
  apply(setup, fields, values);
  return setup;
}

std::string CaseTable::id(std::size_t index) const {
  Setup of_case = setup(index);
  of_case.solver.time_step = taken_time_step(of_case.scene, of_case.solver);
  of_case.solver.fibres = taken_fibres(of_case.scene, of_case.solver);
  return io::hexadecimal(
      io::Digest().integer(common_digest_).integer(io::scene_digest(of_case)).value());
}

std::string value_text(const Field& field, const FieldValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr) return "unset";
  std::string text = model_detail::number_text(*number);
  const std::string_view unit = si_unit(field.dimension);
  if (unit != "1") text.append(" ").append(unit);
  return text;
}

}  // namespace plastica::sweeps
