#pragma once

#include <string>

namespace plastica::fuzz {

/// Reads a result file of whatever kind, writes what it holds, reads that, and makes the reports of
/// it. What is written twice has the same bytes.
/// @throws Broken, or what else breaks the contract
void read_result(const std::string& path);

}  // namespace plastica::fuzz
