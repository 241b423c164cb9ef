#include "plastica/io/scene_rules.hpp"

#include <algorithm>

namespace plastica::io {
namespace {

/// One thing that must hold, and what is said where it does not.
struct Agreement {
  bool holds;
  std::string_view path;
  std::string_view rule;
};

bool within(int value, int first, int last) { return value >= first && value <= last; }

bool are_joints(const SceneRecord& record) {
  const auto last = static_cast<int>(record.outline.segments());
  for (const ChainBreak& event : record.response.chain.events) {
    for (const BrokenJoint& joint : event.joints) {
      if (!within(joint.joint, 0, last)) return false;
    }
  }
  return true;
}

bool are_fragments(const SceneRecord& record) {
  const auto last = static_cast<int>(record.outline.segments()) - 1;
  for (const ChainBreak& event : record.response.chain.events) {
    for (const Fragment& fragment : event.fragments) {
      if (!within(fragment.first, 0, last) || !within(fragment.last, fragment.first, last))
        return false;
    }
  }
  return true;
}

bool are_frames(const std::vector<std::size_t>& frames, std::size_t samples) {
  if (samples == 0) return frames.empty();
  return !frames.empty() && frames.front() == 0 && frames.back() < samples;
}

/// Times of a motion rise from 0 on; those of a path that arcs lead fall and rise again.
bool rises_if_moved(const SceneRecord& record, const std::vector<double>& time) {
  if (record.setup.solver.analysis == Analysis::Statics) return true;
  return std::ranges::is_sorted(time) && (time.empty() || time.front() >= 0.0);
}

std::vector<double> times_of(const std::vector<ChainBreak>& events) {
  std::vector<double> times;
  times.reserve(events.size());
  for (const ChainBreak& event : events) times.push_back(event.time);
  return times;
}

bool spans_the_beam(const std::vector<double>& ends) {
  return ends.empty() || (ends.size() > 1 && ends.front() == 0.0 && ends.back() == 1.0);
}

}  // namespace

void check_agreement(const Hdf5Group& root, const SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  const Response& response = record.response;
  const std::size_t samples = response.samples;
  const std::size_t segments = record.outline.segments();
  const bool coupon = record.outline.ends.empty();
  const std::size_t of_probes = response.probes.empty() ? samples : response.probes[0].size();
  const ChainHistory& chain = response.chain;
  const bool at_rest = record.setup.solver.analysis == Analysis::Statics;
  const std::array agreements{
      Agreement{spans_the_beam(record.outline.ends), "beam/ends", "must begin with 0, end with 1"},
      Agreement{coupon == scene.is_coupon(), "drive/strain",
                "must be there for a coupon, and not for a beam"},
      Agreement{coupon == (record.level == Level::Coupon), "scene/level",
                "must be coupon for a coupon alone"},
      Agreement{coupon || segments == static_cast<std::size_t>(scene.beam.segments), "beam/width",
                "must have a row for each of beam.segments"},
      Agreement{!scene.gravity_history.time.empty(), "gravity/history_time", "must have a time"},
      Agreement{of_probes == samples, "outcome/samples",
                "is not the number of samples of the file"},
      Agreement{coupon || response.chain.time.size() == samples, "outcome/samples",
                "is not the number of samples of the file"},
      Agreement{!coupon || samples <= scene.drive.strain.size(), "drive/strain",
                "must have a strain for each sample"},
      Agreement{!response.event || response.event->sample < scene.drive.strain.size(),
                "coupon_break/sample", "must be a sample of the drive"},
      Agreement{rises_if_moved(record, response.chain.time), "path/time",
                "must rise from 0 on in a motion"},
      Agreement{rises_if_moved(record, times_of(response.chain.events)), "events/time",
                "must rise from 0 on in a motion"},
      Agreement{are_frames(response.chain.frame_sample, coupon ? 0 : samples), "path/frame_sample",
                "must rise and be samples of the file"},
      Agreement{!at_rest || chain.velocity.empty(), "segments/velocity",
                "must not be there: the beam is at rest"},
      Agreement{chain.velocity.empty() || !chain.spin.empty(), "segments/spin",
                "must be there beside segments/velocity"},
      Agreement{chain.spin.empty() || !chain.velocity.empty(), "segments/velocity",
                "must be there beside segments/spin"},
      Agreement{are_joints(record), "events/joints/joint", "must be a joint of the beam"},
      Agreement{are_fragments(record), "events/fragments",
                "must be ranges of the beam's segments"}};
  for (const Agreement& agreement : agreements) {
    if (!agreement.holds) refuse_value(root, agreement.path, "", agreement.rule);
  }
}

}  // namespace plastica::io
