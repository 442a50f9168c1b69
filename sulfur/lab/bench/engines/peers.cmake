# Adaptors of the engines that `sulfur_lab bench` compares with. Each is built where its library is
# found; none is needed. Every library is looked for by a header that only it has, and its paths
# are given to its own adaptor alone, so that libraries whose headers have the same names (Box2D 2
# and 3) can be used side by side.
#
#   Box2D 2.4, Chipmunk 7, Bullet 3: Debian's libbox2d-dev, libchipmunk-dev, libbullet-dev
#   Box2D 3, LiquidFun: no packages; build and install them, then configure with
#     -DSULFUR_BOX2D_V3=PREFIX -DSULFUR_LIQUIDFUN=PREFIX
set(SULFUR_BOX2D_V3 "" CACHE PATH "Prefix of an installed Box2D 3, for sulfur_lab bench")
set(SULFUR_LIQUIDFUN "" CACHE PATH "Prefix of an installed LiquidFun, for sulfur_lab bench")

# sulfur_peer(<name> <what> FILE <adaptor> HEADER <header> LIBRARIES <names>... [PREFIX <prefix>]
#   [SUFFIXES <include folder>...]): adds the adaptor if the library is found, and sets <name>_FOUND.
function(sulfur_peer name what)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "FILE;HEADER;PREFIX" "LIBRARIES;SUFFIXES")
  set(found TRUE)
  find_path(SULFUR_${name}_INCLUDE ${arg_HEADER} HINTS ${arg_PREFIX}/include
    PATH_SUFFIXES ${arg_SUFFIXES})
  mark_as_advanced(SULFUR_${name}_INCLUDE)
  if(NOT SULFUR_${name}_INCLUDE)
    # Without its headers, a library of the name is another one; it must not be remembered.
    message(STATUS "sulfur_lab bench: ${what} not found")
    return()
  endif()
  # A library lies beside its headers; another one of the same name may lie elsewhere.
  get_filename_component(beside "${SULFUR_${name}_INCLUDE}/../lib" ABSOLUTE)
  set(libraries)
  foreach(library ${arg_LIBRARIES})
    find_library(SULFUR_${name}_${library} ${library}
      HINTS ${arg_PREFIX}/lib ${arg_PREFIX}/lib64 ${beside} ${beside}/${CMAKE_LIBRARY_ARCHITECTURE})
    mark_as_advanced(SULFUR_${name}_${library})
    if(NOT SULFUR_${name}_${library})
      set(found FALSE)
    endif()
    list(APPEND libraries ${SULFUR_${name}_${library}})
  endforeach()
  if(NOT found)
    message(STATUS "sulfur_lab bench: ${what} not found")
    return()
  endif()
  add_library(sulfur_peer_${name} OBJECT bench/engines/${arg_FILE})
  sulfur_target(sulfur_peer_${name})
  target_include_directories(sulfur_peer_${name}
    PRIVATE ${PROJECT_SOURCE_DIR}/sulfur/lab)
  target_include_directories(sulfur_peer_${name} SYSTEM BEFORE
    PRIVATE ${SULFUR_${name}_INCLUDE})
  target_link_libraries(sulfur_peer_${name} PRIVATE sulfur::sulfur)
  set(${name}_FOUND TRUE PARENT_SCOPE)
  set(${name}_LIBRARIES ${libraries} PARENT_SCOPE)
endfunction()

# sulfur_use_peer(<name>): links an adaptor and its library into the laboratory.
function(sulfur_use_peer name)
  target_sources(sulfur_lab_parts PRIVATE $<TARGET_OBJECTS:sulfur_peer_${name}>)
  target_link_libraries(sulfur_lab_parts PRIVATE ${${name}_LIBRARIES})
  set_property(SOURCE bench/engines.cpp APPEND PROPERTY COMPILE_DEFINITIONS SULFUR_BENCH_${name})
endfunction()

sulfur_peer(BOX2D_V3 "Box2D 3" FILE box2d_v3_engine.cpp HEADER box2d/id.h
  LIBRARIES box2d PREFIX ${SULFUR_BOX2D_V3})
if(BOX2D_V3_FOUND)
  sulfur_use_peer(BOX2D_V3)
endif()

sulfur_peer(BOX2D_V2 "Box2D 2.4" FILE box2d_v2_engine.cpp HEADER box2d/b2_body.h LIBRARIES box2d)
if(BOX2D_V2_FOUND)
  sulfur_use_peer(BOX2D_V2)
endif()

sulfur_peer(CHIPMUNK "Chipmunk" FILE chipmunk_engine.cpp HEADER chipmunk/chipmunk.h
  LIBRARIES chipmunk)
if(CHIPMUNK_FOUND)
  sulfur_use_peer(CHIPMUNK)
endif()

sulfur_peer(BULLET "Bullet" FILE bullet_engine.cpp HEADER btBulletDynamicsCommon.h SUFFIXES bullet
  LIBRARIES BulletSoftBody BulletDynamics BulletCollision LinearMath)
if(BULLET_FOUND)
  sulfur_use_peer(BULLET)
endif()

# LiquidFun contains a Box2D 2.3 with the symbols of Box2D 2.4 and other contents. It is linked
# into one object with its adaptor, of which only the adaptor's functions remain visible.
sulfur_peer(LIQUIDFUN "LiquidFun" FILE liquidfun_engine.cpp HEADER Box2D/Particle/b2Particle.h
  LIBRARIES liquidfun PREFIX ${SULFUR_LIQUIDFUN})
if(LIQUIDFUN_FOUND)
  # Symbols that are unique in the whole program cannot be hidden.
  target_compile_options(sulfur_peer_LIQUIDFUN PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/liquidfun_closed.o)
  add_custom_command(OUTPUT ${object}
    COMMAND ${CMAKE_LINKER} --relocatable --force-group-allocation -o ${object}
      $<TARGET_OBJECTS:sulfur_peer_LIQUIDFUN> ${LIQUIDFUN_LIBRARIES}
    COMMAND ${CMAKE_OBJCOPY} --wildcard
      --keep-global-symbol=_ZN6sulfur3lab5bench13makeLiquidFun*
      --keep-global-symbol=_ZN6sulfur3lab5bench16liquidFunVersion* ${object}
    DEPENDS sulfur_peer_LIQUIDFUN $<TARGET_OBJECTS:sulfur_peer_LIQUIDFUN> ${LIQUIDFUN_LIBRARIES}
    COMMENT "Closing LiquidFun off from Box2D" VERBATIM COMMAND_EXPAND_LISTS)
  target_sources(sulfur_lab_parts PRIVATE ${object})
  set_source_files_properties(${object} TARGET_DIRECTORY sulfur_lab_parts
    PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  set_property(SOURCE bench/engines.cpp APPEND PROPERTY COMPILE_DEFINITIONS SULFUR_BENCH_LIQUIDFUN)
endif()
