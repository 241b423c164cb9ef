#pragma once

namespace plastica::testing {

/// Whether AddressSanitizer watches. It makes tests tens of times slower and looks for other faults
/// than wrong numbers: what is only one more number of the same code is left out then.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#elif defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace plastica::testing
