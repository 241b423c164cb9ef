# plastica_require(PACKAGE [arguments of find_package…]): finds a package that the libraries link,
# and notes it for plasticaConfig.cmake: who links our static libraries links these too. What is
# headers alone is found by find_package and linked inside $<BUILD_INTERFACE:…> instead.
macro(plastica_require package)
  find_package(${package} REQUIRED ${ARGN})
  string(JOIN " " plastica_arguments ${package} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY PLASTICA_DEPENDENCIES "${plastica_arguments}")
endmacro()

# plastica_require_library(NAME HEADER PACKAGE): looks for a library that is linked by its name, since
# it brings no file for find_package; PACKAGE is Debian's name.
function(plastica_require_library name header package)
  find_library(PLASTICA_LIBRARY_${name} ${name})
  find_path(PLASTICA_HEADER_${name} ${header})
  mark_as_advanced(PLASTICA_LIBRARY_${name} PLASTICA_HEADER_${name})
  foreach(what LIBRARY HEADER)
    if(NOT PLASTICA_${what}_${name})
      message(FATAL_ERROR "lib${name} with its header ${header} is needed (Debian: ${package})")
    endif()
  endforeach()
endfunction()
