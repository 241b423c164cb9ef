# With CMAKE_UNITY_BUILD, as in the presets release, asan-ubsan and tsan, several sources are compiled
# as one: headers and templates that they share are read and compiled once. By 16 in place of 8 a
# sanitized build takes two thirds of the time, the optimized lib/run too. One source alone takes
# longer: -DCMAKE_UNITY_BUILD_BATCH_SIZE=4 suits whoever edits. No two sources of a folder, or of a
# test program, may give one name to unlike things of their unnamed namespaces.
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
endif()

# plastica_unity(TARGET FOLDERS…): compiles the target's sources in each of these folders by about
# so many; those in other folders, and those with options of their own, alone.
function(plastica_unity target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(folder ${ARGN})
    string(REPLACE "/" "_" group ${folder})
    set(inside ${sources})
    list(FILTER inside INCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
    list(LENGTH inside count)
    set(batches 0)  # a size of 0: all of them as one
    if(CMAKE_UNITY_BUILD_BATCH_SIZE GREATER 0)
      math(EXPR batches
        "(${count} + ${CMAKE_UNITY_BUILD_BATCH_SIZE} / 2) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
    endif()
    if(batches LESS 1)
      set(batches 1)
    endif()
    set(number 0)
    foreach(source ${inside})
      math(EXPR batch "${number} * ${batches} / ${count}")
      math(EXPR number "${number} + 1")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target}
        PROPERTIES UNITY_GROUP ${group}_${batch})
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
