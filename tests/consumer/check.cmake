# Packs the build as a Debian package, installs that into an empty root, builds the project beside this
# file against it as a user would, runs it and the command, and removes the package: cmake -D build=… -D scratch=… -D generator=… -D compiler=… -P check.cmake
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line}\nends with ${result}:\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${scratch})
step(${CMAKE_CPACK_COMMAND} --config ${build}/CPackConfig.cmake -B ${scratch}/packed)
file(GLOB package ${scratch}/packed/*.deb)
step(dpkg-deb --info ${package})
if(NOT text MATCHES "Depends: [^\n]*libhdf5" OR NOT text MATCHES "Recommends: gnuplot-nox")
  message(FATAL_ERROR "the package does not say what it needs:\n${text}")
endif()
set(root ${scratch}/root)
file(MAKE_DIRECTORY ${root}/var/lib/dpkg/info ${root}/var/lib/dpkg/updates)
file(TOUCH ${root}/var/lib/dpkg/status)
# What the package needs is on this machine, not in that root.
set(dpkg dpkg --root=${root} --log=${scratch}/dpkg.log --force-not-root --force-depends)
step(${dpkg} --install ${package})
set(installed ${root}/usr)
step(${installed}/bin/plastica --help)
string(REGEX MATCHALL "\n  [a-z]+  " commands "${text}")
list(LENGTH commands count)
file(GLOB pages ${installed}/share/man/man1/plastica-*.1.gz)
list(LENGTH pages count_of_pages)
# Each command has a page.
if(count LESS 15 OR NOT count EQUAL count_of_pages)
  message(FATAL_ERROR "${count} commands and ${count_of_pages} pages:\n${text}")
endif()
foreach(file bash-completion/completions/plastica zsh/vendor-completions/_plastica
    fish/vendor_completions.d/plastica.fish doc/plastica/copyright doc/plastica/docs/README.md)
  if(NOT EXISTS ${installed}/share/${file})
    message(FATAL_ERROR "the package lacks ${file}")
  endif()
endforeach()
if(python)
  step(${CMAKE_COMMAND} -E env PYTHONPATH=${installed}/lib/python3/dist-packages ${python} -B -c
    "import plastica
print(plastica.__file__, plastica.simulate(plastica.Scene(drive={'strain': [0, 1e-3]})).status)")
  if(NOT text MATCHES "^${installed}/.* completed\n$")
    message(FATAL_ERROR "the package's Python is another:\n${text}")
  endif()
endif()
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${scratch}/build -G ${generator}
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${installed})
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
prints(breaking
  "0.4 ms: joint 4 holds\n3.7 ms: joint 0 is cut\nbroken, energy off by 0.02 %\n")
prints(beam "pushed 68.04 mm, stays bent 0.71 mm\n")
prints(api "a version
0 warnings
completed, tip 1.000 of the closed form
completed completed 355 MPa
it rings, told
section.width = -1: must be positive and finite
")

step(${dpkg} --purge plastica)
if(EXISTS ${installed})
  file(GLOB_RECURSE left LIST_DIRECTORIES true ${installed}/*)
  message(FATAL_ERROR "the package leaves behind ${installed} ${left}")
endif()
