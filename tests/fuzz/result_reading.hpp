#pragma once

#include <string>

namespace plastica::fuzz {

/// Reads a result file of whatever kind and makes the reports of it.
/// @param again  also writes what it holds, reads that, and compares the file with itself, which
///               takes four times as long. What is written twice has the same bytes
/// @throws Broken, or what else breaks the contract
void read_result(const std::string& path, bool again);

}  // namespace plastica::fuzz
