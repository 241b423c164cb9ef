// How long a process of a team waits for its next part, and how long process 0 is busy with the
// answer. To be started by mpirun; prints microseconds.

#include <chrono>
#include <cstdio>
#include <thread>

#include "cli/mpi_wire.hpp"

int main() {
  using std::chrono::steady_clock;
  const auto wire = plastica::cli::join_mpi();
  for (const int pause : {0, 5000}) {  // of the asking process between two questions [us]
    constexpr int kOften = 20'000;
    constexpr int kSeldom = 200;
    const int questions = pause == 0 ? kOften : kSeldom;
    wire->open_counter();
    double waited = 0.0;
    const auto begin = steady_clock::now();
    if (wire->rank() > 0) {
      for (int i = 0; i < questions; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(pause));
        const auto asked = steady_clock::now();
        (void)wire->count_up();
        waited += std::chrono::duration<double>(steady_clock::now() - asked).count();
      }
    }
    wire->end_counter(false);
    const double took = std::chrono::duration<double>(steady_clock::now() - begin).count();
    if (wire->rank() == 1) {
      std::printf("pause %d us: %.1f us from question to answer\n", pause,
                  1e6 * waited / questions);
    }
    if (wire->rank() == 0 && pause == 0) {
      const double all = questions * static_cast<double>(wire->size() - 1);
      std::printf("%zu processes: %.1f us a question\n", wire->size(), 1e6 * took / all);
    }
  }
}
