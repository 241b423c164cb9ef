// What a build without MPI has in place of mpi_wire.cpp.
#include "cli/mpi_wire.hpp"

namespace plastica::cli {

std::unique_ptr<MpiWire> join_mpi() { return nullptr; }

}  // namespace plastica::cli
