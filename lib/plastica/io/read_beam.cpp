#include <cmath>
#include <numeric>

#include "plastica/io/read_chain.hpp"
#include "plastica/io/read_fields.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_value.hpp"

namespace plastica::io {
namespace {

/// Half a unit in the last of ten places, the fewest that anybody writes lengths to.
constexpr double kSumTolerance = 5e-10;

using model_detail::number_text;

bool is_fraction(const TomlValue& value) {
  return value.is_number() || (value.is_string() && value.string().ends_with('%'));
}

/// Sets the beam's length to a sum of parts; a length that is given already must be that.
void set_length(bool given, const TomlValue& parts, double sum, Beam& result) {
  if (given && std::abs(sum - result.length) > kSumTolerance * sum) {
    throw parts.error("add up to " + number_text(sum) + " m, and the beam's length is " +
                      number_text(result.length) + " m");
  }
  if (!given) result.length = sum;
}

void read_segment_lengths(const TomlTable& beam, const TomlValue& list, Beam& result) {
  const auto items = list.array();
  const bool fractions = !items.empty() && is_fraction(items.front());
  std::vector<double> lengths =
      read_quantities(list, fractions ? Dimension::None : Dimension::Length);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (lengths[i] <= 0.0) throw items[i].error("must be above 0");
  }
  const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!fractions) {
    const bool given = beam.contains("length") || result.shape == BeamShape::Polyline;
    set_length(given, list, sum, result);
  } else if (std::abs(sum - 1.0) > kSumTolerance) {
    throw list.error("are fractions that add up to " + number_text(sum) +
                     ": must be 1; lengths need a unit");
  }
  const auto count = static_cast<int>(lengths.size());
  if (beam.contains("segments") && result.segments != count) {
    throw list.error("are " + std::to_string(count) + " lengths, and beam.segments is " +
                     std::to_string(result.segments));
  }
  for (double& length : lengths) length /= sum;
  result.segments = count;
  result.segment_fractions = std::move(lengths);
}

void read_points(const TomlTable& beam, const TomlValue& list, Beam& result) {
  for (const TomlValue& item : list.array()) {
    result.points.push_back(read_vector(item, Dimension::Length));
  }
  if (result.points.size() < 2) throw list.error("must be at least two points");
  set_length(beam.contains("length"), list, polyline_length(result.points), result);
}

}  // namespace

void read_beam(const TomlTable& root, Setup& setup) {
  const auto beam = root.find_table("beam");
  if (!beam) return;
  Beam& result = setup.scene.beam;
  const auto only_with = [&](const std::optional<TomlValue>& value, BeamShape shape,
                             std::string_view word) {
    if (value && result.shape != shape) {
      throw value->error("belongs to beam.shape = \"" + std::string(word) + "\"");
    }
    return value.has_value();
  };
  only_with(beam->find("arc_angle"), BeamShape::Arc, "arc");
  const auto towards = beam->find("arc_towards");
  const auto points = beam->find("points");
  if (only_with(towards, BeamShape::Arc, "arc")) result.arc_towards = read_direction(*towards);
  if (only_with(points, BeamShape::Polyline, "polyline")) read_points(*beam, *points, result);
  if (result.shape == BeamShape::Polyline) (void)beam->at("points");
  if (result.shape == BeamShape::Arc) (void)beam->at("arc_angle");
  if (const auto list = beam->find("segment_lengths")) read_segment_lengths(*beam, *list, result);
  if (const auto list = beam->find("joint_lengths")) {
    result.joint_lengths = read_quantities(*list, Dimension::Length);
  }
}

}  // namespace plastica::io
