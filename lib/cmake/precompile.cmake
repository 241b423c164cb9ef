# With the headers of others precompiled the sanitized build takes some 900 CPU-seconds in place of
# 1 050. A compiler cache saves more, and does not know such headers.
option(PLASTICA_PRECOMPILED_HEADERS "Precompile what sources include of others" OFF)

# plastica_precompile(TARGET HEADERS…): each source of the target begins with these, if the option is
# on. It still includes what it uses: other builds have no such headers.
function(plastica_precompile target)
  if(PLASTICA_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
