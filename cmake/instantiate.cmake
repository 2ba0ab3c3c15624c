# The integrators' drivers are templates. Each mode × kernel row × backend is instantiated in a translation unit of its
# own, so that they build in parallel and no unit takes minutes.
set(ROPELIGHT_MODES ray path sppm)
set(ROPELIGHT_ROWS basic full)

# Adds the translation units of one backend (cpu, cuda) with the given file extension (cpp, cu) to the target.
function(ropelight_instantiate target backend extension)
  file(GLOB header CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/render/integrator/instantiate.h")
  if(NOT header)
    return()
  endif()
  foreach(MODE IN LISTS ROPELIGHT_MODES)
    foreach(ROW IN LISTS ROPELIGHT_ROWS)
      set(output "${PROJECT_BINARY_DIR}/instantiate/${backend}_${MODE}_${ROW}.${extension}")
      configure_file("${PROJECT_SOURCE_DIR}/cmake/instantiate.cpp.in" "${output}" @ONLY)
      target_sources(${target} PRIVATE "${output}")
    endforeach()
  endforeach()
endfunction()
