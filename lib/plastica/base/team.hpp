#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "plastica/base/guided_parts.hpp"
#include "plastica/base/next_index.hpp"
#include "plastica/base/stop_flag.hpp"
#include "plastica/base/team_wire.hpp"

namespace plastica {

/// Thrown where another process of the team has left it.
class TeamLeft : public std::runtime_error {
 public:
  /// @param failed  whether it has failed, and says why; else it was stopped
  explicit TeamLeft(bool failed)
      : std::runtime_error("another process of the run has left it"), failed_(failed) {}

  bool failed() const { return failed_; }

 private:
  bool failed_;
};

/// The processes that compute one run together. All of them read the same inputs; each computes
/// what it gets when it is free. Process 0 leads: it computes, too, and it alone writes the result.
///
/// All processes make the same calls in the same order, but for `report`. Whichever fails
/// leaves, and the others throw TeamLeft from where they would wait for it next.
class Team {
 public:
  using Counts = TeamWire::Counts;

  explicit Team(std::unique_ptr<TeamWire> wire) : wire_(std::move(wire)) {}

  std::size_t rank() const { return wire_->rank(); }
  std::size_t size() const { return wire_->size(); }
  bool leads() const { return rank() == 0; }

  /// Waits for all. @throws TeamLeft
  void meet();
  /// Waits for all, each with a digest of what must be the same in all of them.
  /// @param what  "inputs", for the error
  /// @throws TeamLeft; InputError in process 0 if it is not the same, and TeamLeft in the others
  void agree(std::uint64_t digest, std::string_view what);

  /// Has `work` do 0 … count-1, each in one of the processes: it is given what hands them out.
  /// Waits until all have done theirs. @return whether any of them was stopped
  /// @throws TeamLeft, and what `work` throws
  bool share(std::size_t count, StopFlag stop, const std::function<void(const NextIndex&)>& work);

  /// Whether work has ever been shared.
  bool has_shared() const { return has_shared_; }

  /// See `TeamWire`; while work is shared.
  void report(const Counts& own) { wire_->report(own); }
  void on_report(std::function<void(const Counts& others)> heard) {
    wire_->on_report(std::move(heard));
  }

  /// To be called by each process last, whether it has failed or not. Waits for all.
  /// @return whether this one has failed and none before it: it says why
  bool leave(bool failed);

 private:
  std::optional<std::size_t> next(StopFlag stop);
  void end_sharing(bool stopped);
  TeamWire::Words gather(bool leaves, bool fails, bool stopped, std::uint64_t digest);

  std::unique_ptr<TeamWire> wire_;
  std::mutex mutex_;  ///< of the part
  GuidedParts parts_;
  GuidedParts::Part part_;
  bool has_shared_ = false;
  bool ended_ = false;  ///< the others wait for nobody any more
};

/// Has `work` do 0 … count-1, with the others of a team where there is one.
/// @param team  null: there is none. @return whether it was stopped
bool share(Team* team, std::size_t count, StopFlag stop,
           const std::function<void(const NextIndex&)>& work);

}  // namespace plastica
