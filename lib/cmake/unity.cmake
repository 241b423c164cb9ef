# With CMAKE_UNITY_BUILD, as in the presets release, asan-ubsan and tsan, several sources are compiled
# as one: a third of the time for all of them, and twice for one alone. Then no two sources of a
# folder, or of a test program, may give one name to unlike things of their unnamed namespaces.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# plastica_unity(TARGET FOLDERS…): compiles the target's sources in each of these folders by about
# eight; those in other folders, and those with SKIP_UNITY_BUILD_INCLUSION, alone.
function(plastica_unity target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(folder ${ARGN})
    string(REPLACE "/" "_" group ${folder})
    set(inside ${sources})
    list(FILTER inside INCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
    list(LENGTH inside count)
    math(EXPR batches "(${count} + 4) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
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
