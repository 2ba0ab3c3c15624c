# Flags of all our code. No flag here may change a value: results are the same bits at every optimisation level.
function(ropelight_compile_options target)
  # Fused multiply-adds would break the exactness that edge tests rely on; errno and traps nobody reads.
  set(host -ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND host -Wno-restrict)  # false alarms on std::string (GCC bug 105651)
  endif()
  if(ROPELIGHT_WERROR)
    list(APPEND host -Werror)
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CUDA>:SHELL:-Werror all-warnings>")
  endif()
  if(ROPELIGHT_NATIVE)
    list(APPEND host -march=native)
  endif()
  if(ROPELIGHT_SANITIZE)
    list(APPEND host -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()

  list(JOIN host "," host_for_nvcc)
  target_compile_options(${target} PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:${host};-Wpedantic;-Wundef>"
    "$<$<COMPILE_LANGUAGE:CUDA>:--expt-relaxed-constexpr;-lineinfo>"
    "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${host_for_nvcc}>")
endfunction()
