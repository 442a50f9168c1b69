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
  # Clang warns of every float that is handed on as a double; GCC of those that slip into a product.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-double-promotion>)
  # With it, ccache keeps what is compiled with a precompiled header.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<COMPILE_LANG_AND_ID:CXX,Clang>:SHELL:-Xclang -fno-pch-timestamp>")
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
  sulfur_in_few_files(${target})
endfunction()

# sulfur_in_few_files(<target>): with SULFUR_UNITY, up to a dozen sources of a folder are compiled as
# one, which takes less than half of the time. Each must have names of its own in its folder, or stay
# by itself (sulfur_alone).
function(sulfur_in_few_files target)
  if(NOT SULFUR_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(count 0)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    math(EXPR part "${count} / 12")
    math(EXPR count "${count} + 1")
    if(NOT folder STREQUAL last_folder)
      set(part 0)
      set(count 1)
      set(last_folder ${folder})
    endif()
    string(MAKE_C_IDENTIFIER "${folder}_${part}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # What is local to a function hides names of other files.
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
endfunction()

# sulfur_alone(<sources>...): they are never compiled together with others.
function(sulfur_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# sulfur_precompile(<target> <headers>...): with SULFUR_UNITY, only for targets of many sources; in
# others too little is compiled for it to pay.
function(sulfur_precompile target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(NOT SULFUR_UNITY OR count GREATER 40)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
