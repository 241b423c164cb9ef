# plastica_require(PACKAGE [arguments of find_package…]): finds a package that the libraries link,
# and notes it for plasticaConfig.cmake: who links our static libraries links these too. What is
# headers alone is found by find_package and linked inside $<BUILD_INTERFACE:…> instead.
macro(plastica_require package)
  find_package(${package} REQUIRED ${ARGN})
  string(JOIN " " plastica_arguments ${package} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY PLASTICA_DEPENDENCIES "${plastica_arguments}")
endmacro()
