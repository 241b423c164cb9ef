#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace plastica {

/// What the processes of a team tell one another, and how: what `Team` needs of MPI.
class TeamWire {
 public:
  /// What a process has counted; what, its user knows.
  using Counts = std::array<std::uint64_t, 3>;
  using Words = std::array<std::uint64_t, 5>;

  TeamWire() = default;
  TeamWire(const TeamWire&) = delete;
  TeamWire& operator=(const TeamWire&) = delete;
  virtual ~TeamWire() = default;

  virtual std::size_t rank() const = 0;  ///< of this process, 0 … size-1
  virtual std::size_t size() const = 0;

  /// The largest of each word over all processes. Waits for all of them.
  virtual Words largest(const Words& own) = 0;

  /// Begins to hand out 0, 1, 2, …, to be called by all.
  virtual void open_counter() = 0;
  /// The next number, which no other process gets; nothing once the counter is closed. One call at
  /// a time in each process.
  virtual std::optional<std::uint64_t> count_up() = 0;
  /// Whether the counter is closed, as this process knows; others than process 0 learn it soon. One
  /// call at a time in each process.
  virtual bool is_closed() = 0;
  /// Lets `count_up` of all processes give nothing from now on. Of process 0 alone.
  virtual void close_counter() = 0;
  /// Ends the handing out; to be called by all. Process 0 waits for the others, and closes the
  /// counter when one of them says that it was stopped.
  virtual void end_counter(bool stopped) = 0;

  /// Tells process 0 what this one has counted, soon. By any thread, between the opening and the
  /// end of the counter.
  virtual void report(const Counts& own) = 0;
  /// Sets what is called in process 0, by a thread of its own, with the sum of what the others have
  /// reported.
  virtual void on_report(std::function<void(const Counts& others)> heard) = 0;
};

}  // namespace plastica
