# Compiles ropelight::version into a target. The commit is looked up at every build, and the one small file that holds
# it is rewritten only when it changed. Run as a script (cmake -P), this file does that look-up.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  function(ropelight_version target)
    set(output "${PROJECT_BINARY_DIR}/generated/version.cpp")
    add_custom_target(${target}_version
      COMMAND "${CMAKE_COMMAND}" -D "source=${PROJECT_SOURCE_DIR}" -D "number=${PROJECT_VERSION}" -D "output=${output}"
              -P "${PROJECT_SOURCE_DIR}/cmake/version.cmake"
      BYPRODUCTS "${output}" COMMENT "Looking up the version" VERBATIM)
    add_dependencies(${target} ${target}_version)
    target_sources(${target} PRIVATE "${output}")
  endfunction()
  return()
endif()

set(version "${number}")
execute_process(COMMAND git describe --always --dirty --exclude=* WORKING_DIRECTORY "${source}"
                OUTPUT_VARIABLE commit RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT failed)
  string(APPEND version "+${commit}")
endif()
configure_file("${source}/cmake/version.cpp.in" "${output}" @ONLY)
