# Stages that depend on the scene are compiled once for each kernel row and backend, each in a translation unit of its
# own, so that they build in parallel and no unit takes minutes. The lists are those of render/launch/.
set(ROPELIGHT_ROW_LIST "${PROJECT_SOURCE_DIR}/render/launch/rows.h")
set(ROPELIGHT_STAGE_LIST "${PROJECT_SOURCE_DIR}/render/launch/stages.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${ROPELIGHT_ROW_LIST}" "${ROPELIGHT_STAGE_LIST}")

# Sets `result` to the entries of an X-macro: "#define RL_ROWS(X) X(basic) X(mesh)" gives basic;mesh. Of an entry with
# two words both are kept: "TraceCamera trace_camera".
function(ropelight_words file macro result)
  file(READ "${file}" text)
  string(REGEX REPLACE "\\\\\n" "" text "${text}")
  string(REGEX MATCH "#define ${macro}\\(X\\)[^\n]*" line "${text}")
  string(REGEX MATCHALL "X\\([A-Za-z_0-9]+[^)]*\\)" words "${line}")
  list(TRANSFORM words REPLACE "X\\((.*)\\)" "\\1")
  list(TRANSFORM words REPLACE ", *" " ")
  list(REMOVE_ITEM words X)
  if(NOT words)
    message(FATAL_ERROR "${file} has no list '#define ${macro}(X) X(name) …'")
  endif()
  set(${result} "${words}" PARENT_SCOPE)
endfunction()

# Adds the translation units of one backend (cpu, cpu64, cuda) with the given file extension (cpp, cu) to the target.
# cpu64 is the CPU's code in double precision, cpu_faults a copy that tests can spoil: both in the last row alone.
function(ropelight_instantiate target backend extension)
  ropelight_words("${ROPELIGHT_STAGE_LIST}" RL_STAGES stages)
  ropelight_words("${ROPELIGHT_ROW_LIST}" RL_ROWS rows)
  if(ROPELIGHT_LAST_ROW_ONLY OR backend MATCHES "cpu.")
    list(GET rows -1 rows)
  endif()
  string(REGEX REPLACE "cpu.+" "cpu" backend_header "${backend}")
  set(definitions_cpu64 ROPELIGHT_DOUBLE=1)
  set(definitions_cpu_faults ROPELIGHT_TEST_TARGET=cpu_faults RL_FAULTS=1)
  foreach(entry IN LISTS stages)
    string(REGEX REPLACE " .*" "" stage "${entry}")
    string(REGEX REPLACE ".* " "" header "${entry}")
    foreach(row IN LISTS rows)
      set(output "${PROJECT_BINARY_DIR}/instantiate/${backend}_${stage}_${row}.${extension}")
      configure_file("${PROJECT_SOURCE_DIR}/cmake/instantiate.cpp.in" "${output}" @ONLY)
      target_sources(${target} PRIVATE "${output}")
      set_source_files_properties("${output}" PROPERTIES COMPILE_DEFINITIONS "${definitions_${backend}}")
    endforeach()
  endforeach()
endfunction()
