# plastica_require(PACKAGE [arguments of find_package…]): finds a package that the libraries link,
# and notes it for plasticaConfig.cmake: who links our static libraries links these too. What is
# headers alone is found by find_package and linked inside $<BUILD_INTERFACE:…> instead.
macro(plastica_require package)
  find_package(${package} REQUIRED ${ARGN})
  string(JOIN " " plastica_arguments ${package} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY PLASTICA_DEPENDENCIES "${plastica_arguments}")
endmacro()

# plastica_include_by_name(TARGET NAME HEADER PACKAGE): takes a header that is all there is of a
# library and brings no file for find_package. PACKAGE is Debian's name.
function(plastica_include_by_name target name header package)
  find_path(PLASTICA_INCLUDE_${name} ${header})
  mark_as_advanced(PLASTICA_INCLUDE_${name})
  if(NOT PLASTICA_INCLUDE_${name})
    message(FATAL_ERROR
      "${header} is not found (Debian: ${package}; -DPLASTICA_INCLUDE_${name}=PATH says where)")
  endif()
  target_include_directories(${target} PRIVATE ${PLASTICA_INCLUDE_${name}})
endfunction()

# plastica_link_by_name(TARGET NAME HEADER PACKAGE): links a library that brings no file for
# find_package. Who links our installed static library finds it by its name. PACKAGE is Debian's name.
function(plastica_link_by_name target name header package)
  find_library(PLASTICA_LIBRARY_${name} ${name})
  find_path(PLASTICA_INCLUDE_${name} ${header})
  mark_as_advanced(PLASTICA_LIBRARY_${name} PLASTICA_INCLUDE_${name})
  foreach(variable PLASTICA_LIBRARY_${name} PLASTICA_INCLUDE_${name})
    if(NOT ${variable})
      message(FATAL_ERROR
        "lib${name} with ${header} is not found (Debian: ${package}; -D${variable}=PATH says where)")
    endif()
  endforeach()
  target_include_directories(${target} PRIVATE ${PLASTICA_INCLUDE_${name}})
  target_link_libraries(${target} PRIVATE
    $<BUILD_INTERFACE:${PLASTICA_LIBRARY_${name}}> $<INSTALL_INTERFACE:${name}>)
endfunction()
