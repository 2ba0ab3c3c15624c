# The integrators' drivers are templates. Each mode × kernel row × backend is instantiated in a translation unit of its
# own, so that they build in parallel and no unit takes minutes. The lists are those of variants.h.
set(ROPELIGHT_VARIANTS "${PROJECT_SOURCE_DIR}/render/kernels/variants.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${ROPELIGHT_VARIANTS}")

# Sets `result` to the words of an X-macro: "#define RL_MODES(X) X(ray) X(path)" gives ray;path.
function(ropelight_words macro result)
  file(STRINGS "${ROPELIGHT_VARIANTS}" line REGEX "^#define ${macro}\\(X\\)")
  string(REGEX MATCHALL "X\\([a-z_0-9]+\\)" words "${line}")
  list(TRANSFORM words REPLACE "X\\((.*)\\)" "\\1")
  if(NOT words)
    message(FATAL_ERROR "${ROPELIGHT_VARIANTS} has no line '#define ${macro}(X) X(name) …'")
  endif()
  set(${result} "${words}" PARENT_SCOPE)
endfunction()

# Adds the translation units of one backend (cpu, cuda) with the given file extension (cpp, cu) to the target.
function(ropelight_instantiate target backend extension)
  ropelight_words(RL_MODES modes)
  ropelight_words(RL_ROWS rows)
  foreach(mode IN LISTS modes)
    foreach(row IN LISTS rows)
      set(output "${PROJECT_BINARY_DIR}/instantiate/${backend}_${mode}_${row}.${extension}")
      configure_file("${PROJECT_SOURCE_DIR}/cmake/instantiate.cpp.in" "${output}" @ONLY)
      target_sources(${target} PRIVATE "${output}")
    endforeach()
  endforeach()
endfunction()
