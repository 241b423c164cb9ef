# plastica_options: how every target of ours is compiled; never handed to a user's targets.
add_library(plastica_options INTERFACE)
target_compile_options(plastica_options INTERFACE
  # Results must not depend on which operations a compiler chooses to fuse: fused
  # multiply-adds are written out where they are wanted.
  -ffp-contract=off
  # Our functions are those that a program is linked with, whatever else it loads: within one of our
  # libraries they are called, and inlined, straight.
  -fno-semantic-interposition)
if(PLASTICA_WARNINGS_AS_ERRORS)
  target_compile_options(plastica_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror
    # GCC 12 reports a false overlap inside std::string's operator+ (GCC bug 105651), and reads of
    # what an empty std::optional<std::string> does not hold (GCC bug 105562 and its kin).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict$<SEMICOLON>-Wno-maybe-uninitialized>
    # Templates combine masks of lanes by & and |; of one scenario a mask is a bool.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
endif()
