#pragma once

#include <cstddef>

#include "plastica/io/toml.hpp"
#include "sweeps/check/claim.hpp"

/// Parts of the check file's reader; not installed.
namespace plastica::sweeps {

/// Reads which of the kinds a claim is. @throws InputError if it is none, or two, or none of those
/// that its subject has
void read_claim_kind(const io::TomlTable& table, Claim& claim);

/// Reads what is wanted of it.
/// @param sweep  of a claim about a sweep or a scene; else null
/// @throws InputError if nothing is wanted, or the sweep has no such number
void read_limits(const io::TomlTable& table, const Sweep* sweep, Claim& claim);

/// Refuses a claim that holds whatever happens.
/// @param count  of cases or fits that it may be about
/// @throws InputError
void refuse_sure(const io::TomlTable& table, const Claim& claim, std::size_t count);

}  // namespace plastica::sweeps
