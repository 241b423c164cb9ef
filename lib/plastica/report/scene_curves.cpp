#include "plastica/report/scene_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/shown_probes.hpp"

namespace plastica::report {
namespace {

double largest(const std::vector<double>& values, std::size_t first, std::size_t stride) {
  double most = 0.0;
  for (std::size_t i = first; i < values.size(); i += stride) {
    if (std::isfinite(values[i])) most = std::max(most, std::fabs(values[i]));
  }
  return most;
}

/// Strain and stress of a joint over the path, about the axis about which it broke, else that of
/// its largest strain.
struct JointPath {
  std::size_t joint = 0;
  std::size_t axis = 0;
  bool broke = false;                       ///< at the end of it
  std::vector<std::vector<double>> points;  ///< (strain in %, stress in MPa)
};

double strain_at(const io::SceneRecord& record, std::size_t frame, std::size_t joint,
                 std::size_t axis) {
  const ChainHistory& chain = record.response.chain;
  return chain.angle[(frame * chain.joints + joint) * 3 + axis] *
         record.outline.strain_per_angle[3 * joint + axis];
}

/// A joint that broke, and was not cut by the scene.
struct Broken {
  std::size_t joint = 0;
  std::optional<std::size_t> axis;  ///< about which it broke, if about one
  double time = 0.0;                ///< [s]
};

/// About which axis of a joint a cause acts, if about one.
std::optional<std::size_t> axis_of(BreakCause cause) {
  switch (cause) {
    case BreakCause::BendingX: return 0;
    case BreakCause::BendingY: return 1;
    case BreakCause::Torsion: return 2;
    case BreakCause::Biaxial:
    case BreakCause::Stretch:
    case BreakCause::Cut: break;
  }
  return std::nullopt;
}

/// The first that broke; of a joint, whether it did.
std::optional<Broken> first_broken(const io::SceneRecord& record, std::optional<int> wanted) {
  for (const ChainBreak& event : record.response.chain.events) {
    for (const BrokenJoint& broken : event.joints) {
      if (broken.cause == BreakCause::Cut || (wanted && broken.joint != *wanted)) continue;
      return Broken{static_cast<std::size_t>(broken.joint), axis_of(broken.cause), event.time};
    }
  }
  return std::nullopt;
}

/// @param wanted  a joint; none: that which broke, else that of the largest strain
JointPath joint_path(const io::SceneRecord& record, std::optional<int> wanted) {
  const ChainHistory& chain = record.response.chain;
  JointPath path;
  double most = -1.0;
  const std::optional<Broken> broken = first_broken(record, wanted);
  if (broken) wanted = static_cast<int>(broken->joint);
  path.broke = broken.has_value();
  // What is broken turns freely.
  std::size_t frames = frames_of(record);
  while (broken && frames > 1 && time_of_frame(record, frames - 1) > broken->time) --frames;
  for (std::size_t joint = 0; joint < chain.joints; ++joint) {
    if (wanted && joint != static_cast<std::size_t>(*wanted)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (broken && broken->axis && axis != *broken->axis) continue;
      for (std::size_t frame = 0; frame < frames; ++frame) {
        const double size = std::fabs(strain_at(record, frame, joint, axis));
        if (!(size > most)) continue;
        most = size;
        path.joint = joint;
        path.axis = axis;
      }
    }
  }
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::size_t at = (frame * chain.joints + path.joint) * 3 + path.axis;
    const double modulus = record.outline.modulus[3 * path.joint + path.axis];
    path.points.push_back({100.0 * strain_at(record, frame, path.joint, path.axis),
                           1e-6 * chain.moment[at] / modulus});
  }
  return path;
}

void check_joint(const io::SceneRecord& record, int joint) {
  const std::size_t joints = record.response.chain.joints;
  if (joint >= 0 && static_cast<std::size_t>(joint) < joints) return;
  throw InputError({}, "--joint", std::to_string(joint),
                   joints == 0 ? std::string("is not of a coupon, which has none")
                               : fmt::format("must be from 0 to {}", joints - 1));
}

}  // namespace

std::vector<std::string> labels_of(std::span<const io::SceneRecord> records) {
  std::vector<std::string> labels;
  const auto same_name = [&](const io::SceneRecord& record) {
    return std::count_if(records.begin(), records.end(), [&](const io::SceneRecord& other) {
      return other.setup.scene.name == record.setup.scene.name;
    });
  };
  for (const io::SceneRecord& record : records) {
    const std::string segments = counted(record.outline.segments(), "segment");
    const std::string name = printable(record.setup.scene.name);
    const auto count = static_cast<std::size_t>(same_name(record));
    if (count == records.size()) {
      labels.push_back(segments);
    } else {
      labels.push_back(count == 1 ? name : fmt::format("{}, {}", name, segments));
    }
  }
  return labels;
}

std::string title_of(std::span<const io::SceneRecord> records) {
  std::string title;
  for (const io::SceneRecord& record : records) {
    const std::string name = printable(record.setup.scene.name);
    if (title.find(name) != title.npos) continue;
    if (!title.empty()) title += ", ";
    title += name;
  }
  return cut(title, 90);
}

const std::vector<double>* coupon_stress(const io::SceneRecord& record) {
  const auto& probes = record.setup.scene.probes;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    if (probes[p].quantity == ProbeQuantity::Stress) return &record.response.probes[p];
  }
  return nullptr;
}

Figure moment_figure(std::span<const io::SceneRecord> records, std::optional<double> time) {
  constexpr std::array<std::string_view, 3> kNames{"bending about x", "bending about y", "torque"};
  constexpr std::array<std::string_view, 3> kLabels{"M_x", "M_y", "T"};
  const std::vector<std::string> labels = labels_of(records);
  std::array<double, 3> most{};
  for (const io::SceneRecord& record : records) {
    const ChainHistory& chain = record.response.chain;
    const auto first =
        chain.moment.begin() + static_cast<long>(3 * chain.joints * frame_at(record, time));
    const std::vector<double> shown(first, first + static_cast<long>(3 * chain.joints));
    for (std::size_t k = 0; k < 3; ++k) most[k] = std::max(most[k], largest(shown, k, 3));
  }
  const double all = *std::max_element(most.begin(), most.end());
  const io::SceneRecord& front = records.front();
  std::string when;
  if (time || is_motion(front)) {
    when = " at " +
           time_text(time_of_frame(front, frame_at(front, time)), front.response.chain.time.back());
  }
  Figure figure;
  figure.title = title_of(records);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(most[axis] > 1e-6 * all) && !(axis == 0 && all == 0.0)) continue;
    const bool kilo = most[axis] >= 1e4;
    FigurePanel panel{std::string(kNames[axis]) + when, "along the beam [m]",
                      fmt::format("{} [{}]", kLabels[axis], kilo ? "kN m" : "N m")};
    for (std::size_t r = 0; r < records.size(); ++r) {
      const ChainHistory& chain = records[r].response.chain;
      const std::size_t first = frame_at(records[r], time) * chain.joints;
      FigureCurve curve = curve_of_record(r, records.size(), labels[r]);
      for (std::size_t i = 0; i < chain.joints; ++i) {
        curve.points.push_back({records[r].outline.ends[i] * records[r].setup.scene.beam.length,
                                chain.moment[3 * (first + i) + axis] / (kilo ? 1e3 : 1.0)});
      }
      panel.curves.push_back(std::move(curve));
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

Figure joint_figure(std::span<const io::SceneRecord> records, std::optional<int> joint) {
  const std::vector<std::string> labels = labels_of(records);
  Figure figure;
  figure.title = title_of(records);
  FigurePanel panel{"", "strain [%]", "stress [MPa]"};
  for (std::size_t r = 0; r < records.size(); ++r) {
    const io::SceneRecord& record = records[r];
    if (joint) check_joint(record, *joint);
    FigureCurve curve = curve_of_record(r, records.size(), labels[r]);
    if (record.level == Level::Coupon) {
      const std::vector<double>& stress = *coupon_stress(record);
      for (std::size_t i = 0; i < stress.size(); ++i) {
        curve.points.push_back({100.0 * record.setup.scene.drive.strain[i], 1e-6 * stress[i]});
      }
      curve.name = records.size() == 1 ? "coupon" : printable(record.setup.scene.name);
      curve.stroke = Stroke::Line;
      panel.title = "coupon";
    } else {
      JointPath path = joint_path(record, joint);
      curve.points = std::move(path.points);
      const bool shear = path.axis == 2;
      panel.title =
          fmt::format("joint {} at {} of the length{}: {}", path.joint,
                      place_label(record.outline.ends[path.joint]), path.broke ? ", broken" : "",
                      shear ? std::string("torsion")
                            : fmt::format("bending {}, extreme fibre", axis_name(path.axis)));
      if (shear) {
        panel.x_label = "shear strain [%]";
        panel.y_label = "shear stress [MPa]";
      }
      const std::string shown = fmt::format("joint {}", path.joint);
      curve.name = records.size() == 1 ? shown : curve.name + ", " + shown;
    }
    panel.curves.push_back(std::move(curve));
  }
  if (records.size() > 1) panel.title.clear();
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure load_figure(std::span<const io::SceneRecord> records, const std::string& probe) {
  const std::vector<std::string> labels = labels_of(records);
  Figure figure;
  figure.title = title_of(records);
  const ShownProbes shown(records, probe);
  // Lengths are mostly small.
  const bool length = shown.dimension() == Dimension::Length;
  FigurePanel panel{
      "", fmt::format("{} [{}]", shown.axis(), length ? "mm" : si_unit(shown.dimension())),
      "load factor [1]"};
  for (std::size_t r = 0; r < records.size(); ++r) {
    const io::SceneRecord& record = records[r];
    FigureCurve curve = curve_of_record(r, records.size(), shown.curve_name(r, labels[r]));
    const std::vector<double>& values = shown.values(r);
    for (std::size_t i = 0; i < record.response.samples; ++i) {
      curve.points.push_back({(length ? 1e3 : 1.0) * values[i], record.response.chain.factor[i]});
    }
    panel.title = outcome_line(record);
    panel.curves.push_back(std::move(curve));
  }
  if (records.size() > 1) panel.title.clear();
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace plastica::report
