# What `cmake --install` puts where. The library needs neither SDL nor wxWidgets: the headless
# preset installs it alone; other builds also install the programs that they built.
#
#   include/, lib/               headers and libraries
#   lib/cmake/sulfur/            for find_package(sulfur)
#   lib/sulfur/python/           the binding for Python
#   lib/pkgconfig/               sulfur.pc, sulfur-c.pc, sulfur-scene.pc
#   bin/, share/sulfur/          programs, their assets and levels
#   share/doc/sulfur/            licence, changelog, README with its pictures, examples
#
# sulfur/c, sulfur/scene and the programs install themselves, the former into the export set
# sulfurTargets.
include(CMakePackageConfigHelpers)

install(TARGETS sulfur EXPORT sulfurTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
set_target_properties(sulfur_scene PROPERTIES INSTALL_RPATH "$ORIGIN")
install(DIRECTORY sulfur/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# It looks for libsulfur_c beside the folder sulfur.
install(DIRECTORY sulfur/python/sulfur DESTINATION ${CMAKE_INSTALL_LIBDIR}/sulfur/python
  FILES_MATCHING PATTERN *.py)
install(FILES sulfur/examples/hello.c sulfur/examples/hello.cpp
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(DIRECTORY sulfur/python/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
  FILES_MATCHING PATTERN *.py)
# What README.md links to comes along.
install(FILES LICENSE README.md ARCHITECTURE.md CHANGELOG.md CONTRIBUTING.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES docs/measurements.md docs/sandbox.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY docs/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs FILES_MATCHING PATTERN *.png)

# --- find_package(sulfur) ---------------------------------------------------------------------
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sulfur)
install(EXPORT sulfurTargets NAMESPACE sulfur:: DESTINATION ${package_dir})
configure_package_config_file(cmake/sulfurConfig.cmake.in sulfurConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(sulfurConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/sulfurConfig.cmake
  ${PROJECT_BINARY_DIR}/sulfurConfigVersion.cmake
  DESTINATION ${package_dir})

# --- pkg-config -------------------------------------------------------------------------------
# Paths are relative to the .pc files, so that an installed tree may be moved.
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(SULFUR_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH to_prefix /${pkgconfig_dir} /)
  string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
  set(SULFUR_PC_PREFIX "\${pcfiledir}/${to_prefix}")
endif()
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY "\${prefix}"
  OUTPUT_VARIABLE SULFUR_PC_INCLUDEDIR)
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY "\${prefix}"
  OUTPUT_VARIABLE SULFUR_PC_LIBDIR)
# Whoever uses the library must be compiled with the same options of these two.
set(SULFUR_PC_FLAGS "")
set(SULFUR_PC_CFLAGS "")
if(SULFUR_SANITIZE)
  set(SULFUR_PC_FLAGS " -fsanitize=address,undefined")
endif()
if(SULFUR_REAL_DOUBLE)
  set(SULFUR_PC_CFLAGS " -DSULFUR_REAL_DOUBLE")
endif()
foreach(module sulfur sulfur-c sulfur-scene)
  configure_file(cmake/${module}.pc.in ${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION ${pkgconfig_dir})
endforeach()

# --- programs, where they are built -----------------------------------------------------------
# Each installs itself; here they learn to find the project's shared libraries beside them,
# wherever the tree is moved.
set(SULFUR_PROGRAMS)
foreach(program quaoar quaoar_solve sulfurchamber sulfur_lab atlax_pack)
  if(TARGET ${program})
    list(APPEND SULFUR_PROGRAMS ${program})
    set_target_properties(${program} PROPERTIES
      INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  endif()
endforeach()
