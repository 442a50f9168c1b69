# What every target of the project is compiled with.
#
# sulfur_target(<target>) sets the language level, the warnings and the flags on
# which determinism stands: no contraction of a*b+c into a fused multiply-add and
# no fast-math, so that every compiler and instruction set gives the same bits.
function(sulfur_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -ffp-contract=off -fno-fast-math
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
    -Woverloaded-virtual -Wcast-align -Wunused -Wnull-dereference -Wdouble-promotion)
  # With it, ccache keeps what is compiled with a precompiled header.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  if(SULFUR_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(SULFUR_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(SULFUR_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
    # With what the sanitizers insert, GCC no longer sees what is initialised.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# sulfur_in_few_files(<target> [sources that stay by themselves]): with SULFUR_UNITY, several sources
# are compiled as one, which takes a third of the time. Each must have names of its own, or stay by
# itself.
function(sulfur_in_few_files target)
  if(NOT SULFUR_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  # They hide each other's names.
  target_compile_options(${target} PRIVATE -Wno-shadow)
endfunction()
