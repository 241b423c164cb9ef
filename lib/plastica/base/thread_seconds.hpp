#pragma once

namespace plastica {

/// CPU time of this thread so far [s]: what else the machine does is not counted.
double thread_seconds();

}  // namespace plastica
