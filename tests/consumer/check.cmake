# Installs the build into an empty prefix, builds the project beside this file against it as a user
# would, and runs it: cmake -D build=… -D scratch=… -D generator=… -D compiler=… -P check.cmake
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line}\nends with ${result}:\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${scratch})
step(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/installed)
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${scratch}/build -G ${generator}
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${scratch}/installed)
step(${CMAKE_COMMAND} --build ${scratch}/build)

# How we compile is our own affair.
file(READ ${scratch}/build/compile_commands.json commands)
if(commands MATCHES " (-ffp-contract|-W|-O|-fopenmp)")
  message(FATAL_ERROR "the package changes its user's flags:\n${commands}")
endif()

# prints(PROGRAM TEXT): the program prints exactly this.
function(prints program expected)
  step(${scratch}/build/${program})
  if(NOT text STREQUAL expected)
    message(FATAL_ERROR "${program} prints\n${text}\ninstead of\n${expected}")
  endif()
endfunction()

prints(consumer
  "210.0 MPa\n355.0 MPa\n145.0 MPa\n355.0 MPa\n0.0 MPa\nbroke at 2.17 % strain\n")
prints(fit "bar 2e+11\nyoungs_modulus 2.1e+11\nyield_stress 3.55e+08\nbreak_strain 0.01836\n")
prints(breaking "1.8 ms: joint 3 holds\n4.0 ms: joint 1 is cut\n")
prints(beam "pushed 68.04 mm, stays bent 0.71 mm\n")
prints(api "a version
0 warnings
completed, tip 1.000 of the closed form
completed completed 355 MPa
it rings, told
section.width = -1: must be positive and finite
")
