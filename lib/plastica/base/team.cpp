#include "plastica/base/team.hpp"

#include <string>
#include <utility>

#include "plastica/base/check.hpp"

namespace plastica {
namespace {

// What each process says at a meeting; of all, each word's largest is heard.
enum Word : std::size_t {
  kLeaves,   ///< 1: it has left the run, this is its last meeting
  kStopped,  ///< 1: it was stopped
  kDigest,
  kInverse,  ///< the digest's complement: with it the smallest is heard, too
  kFailed,  ///< size - rank of a process that has failed, so that the first is heard; 0: it has not
};

}  // namespace

TeamWire::Words Team::gather(bool leaves, bool fails, bool stopped, std::uint64_t digest) {
  TeamWire::Words own{};
  own[kLeaves] = leaves ? 1 : 0;
  own[kStopped] = stopped ? 1 : 0;
  own[kDigest] = digest;
  own[kInverse] = ~digest;
  own[kFailed] = fails ? size() - rank() : 0;
  const TeamWire::Words heard = wire_->largest(own);
  if (heard[kLeaves] != 0) {
    ended_ = true;
    if (!leaves) {
      // The failed one leaves with this meeting; the others leave from here.
      throw TeamLeft(heard[kFailed] != 0);
    }
  }
  return heard;
}

void Team::meet() { gather(false, false, false, 0); }

void Team::agree(std::uint64_t digest, std::string_view what) {
  const TeamWire::Words heard = gather(false, false, false, digest);
  if (heard[kDigest] == ~heard[kInverse]) return;
  ended_ = true;  // all of them leave here
  if (!leads()) throw TeamLeft(true);
  throw InputError({}, "processes", std::to_string(size()),
                   "do not have the same " + std::string(what));
}

std::optional<std::size_t> Team::next(StopFlag stop) {
  const std::lock_guard lock(mutex_);
  if (is_raised(stop) || wire_->is_closed()) return {};
  if (part_.begin == part_.end) {
    const std::optional<std::uint64_t> number = wire_->count_up();
    if (!number || *number >= parts_.size()) return {};
    part_ = parts_[static_cast<std::size_t>(*number)];
  }
  return part_.begin++;
}

bool Team::share(std::size_t count, StopFlag stop,
                 const std::function<void(const NextIndex&)>& work) {
  meet();
  parts_ = GuidedParts(count, size());
  part_ = {};
  wire_->open_counter();
  has_shared_ = true;
  try {
    work([this, stop] { return next(stop); });
  } catch (...) {
    // Before what listens to reports is gone.
    end_sharing(true);
    throw;
  }
  end_sharing(is_raised(stop));
  return gather(false, false, is_raised(stop), 0)[kStopped] != 0;
}

void Team::end_sharing(bool stopped) {
  if (leads() && stopped) wire_->close_counter();
  wire_->end_counter(stopped);
  wire_->on_report({});
}

bool Team::leave(bool failed) {
  if (ended_) return failed && leads();
  const TeamWire::Words heard = gather(true, failed, false, 0);
  return failed && heard[kFailed] == size() - rank();
}

bool share(Team* team, std::size_t count, StopFlag stop,
           const std::function<void(const NextIndex&)>& work) {
  if (team != nullptr) return team->share(count, stop, work);
  work({});
  return is_raised(stop);
}

}  // namespace plastica
