# With the headers of others precompiled the sanitized build takes a seventh less time, the tests in
# any build a tenth, which have them always. A compiler cache saves more, and does not know such
# headers: with one there are none. CMAKE_DISABLE_PRECOMPILE_HEADERS turns all off.
option(PLASTICA_PRECOMPILED_HEADERS "Precompile what sources include of others, but in tests" OFF)

# plastica_precompile(TARGET HEADERS…): each source of the target begins with these, if the option is
# on. It still includes what it uses: other builds have no such headers.
function(plastica_precompile target)
  if(PLASTICA_PRECOMPILED_HEADERS AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
