# libhawser, shared and static, from the objects of all folders, and what `cmake --install` puts in place: both
# libraries, the header, the pkg-config file and the CMake package (the program installs itself in cli/).
include(CMakePackageConfigHelpers)
get_property(object_targets GLOBAL PROPERTY HAWSER_OBJECTS)
set(objects "")
foreach(target ${object_targets})
    list(APPEND objects $<TARGET_OBJECTS:${target}>)
endforeach()

# What the folders link outside the project. A new library belongs here too, and its licence in NOTICE: tests/install builds
# a consumer of the static library from nothing but this list.
set(HAWSER_PRIVATE_PACKAGES yaml-0.1 expat jansson zlib nlopt libzip) # known to pkg-config
if(HAWSER_HDF5)
    list(APPEND HAWSER_PRIVATE_PACKAGES ${HDF5_MODULE_NAME})
endif()
if(HAWSER_SHAPELIB)
    list(APPEND HAWSER_PRIVATE_PACKAGES shapelib)
endif()
set(HAWSER_PRIVATE_LIBRARIES ${KLU_LIBRARY} ${AMD_LIBRARY} ${COLAMD_LIBRARY} ${BTF_LIBRARY}
                             ${SUITESPARSECONFIG_LIBRARY} ${METIS_LIBRARY} ${HAWSER_MESHOPTIMIZER} ${HAWSER_SUNDIALS_MPI})
list(TRANSFORM HAWSER_PRIVATE_LIBRARIES REPLACE "^.*/lib([^/]*)[.](so|a)$" "-l\\1")
foreach(name ${HAWSER_SUNDIALS_NAMES})
    list(APPEND HAWSER_PRIVATE_LIBRARIES -l${name})
endforeach()
list(APPEND HAWSER_PRIVATE_LIBRARIES -lm -lpthread -ldl)

# The SONAME's number changes with every change that a program built before could trip over (docs/guide/c.md, "Growing"): below
# 1.0 with the minor version, from then on with the major one.
set(hawser_soversion ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(hawser_soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()

# Only hawser_* leaves the shared library: cmake/hawser.map.
add_library(hawser_shared SHARED ${objects})
set_target_properties(hawser_shared PROPERTIES ${HAWSER_SHIPPED_PROPERTIES}
    OUTPUT_NAME hawser EXPORT_NAME hawser LINKER_LANGUAGE C
    VERSION ${PROJECT_VERSION} SOVERSION ${hawser_soversion}
    LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/hawser.map)
target_link_options(hawser_shared PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/hawser.map
                                          $<$<CONFIG:Release>:-Wl,-z,defs>)
target_link_libraries(hawser_shared PRIVATE
    SUNDIALS::cvode SUNDIALS::nvecserial PkgConfig::YAML PkgConfig::EXPAT PkgConfig::JANSSON ${HAWSER_HDF5_LIBRARY} PkgConfig::ZLIB
    PkgConfig::NLOPT PkgConfig::LIBZIP ${HAWSER_SHAPELIB} ${HAWSER_MESHOPTIMIZER} hawser_klu ${HAWSER_THREADS_LIBRARY} m)
target_include_directories(hawser_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

# The static library is one object in which everything but hawser_* has become local: a program that links it may have
# names like sim_new of its own. It depends on the targets, not on their objects, which Make knows only inside them.
set(whole ${PROJECT_BINARY_DIR}/hawser_whole.o)
add_custom_command(OUTPUT ${whole}
    COMMAND ${CMAKE_LINKER} -r -o ${whole} ${objects}
    COMMAND ${CMAKE_OBJCOPY} --wildcard "--keep-global-symbol=hawser_*" ${whole}
    DEPENDS ${object_targets} COMMAND_EXPAND_LISTS VERBATIM)
add_library(hawser_static STATIC ${whole})
set_target_properties(hawser_static PROPERTIES OUTPUT_NAME hawser LINKER_LANGUAGE C)

install(TARGETS hawser_shared EXPORT hawserTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS hawser_static ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES LICENSE NOTICE CHANGELOG.md README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY cases/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/cases)
install(FILES packaging/hawser.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/hawser.bash DESTINATION share/bash-completion/completions RENAME hawser)
install(FILES packaging/_hawser DESTINATION share/zsh/site-functions)
# The catalogue is found by its place beside program and library (io/case/library.c), also in a build.
install(DIRECTORY library/ DESTINATION share/hawser/library FILES_MATCHING PATTERN "*.yaml")
install(FILES web/dist/desk.html web/dist/convert.cjs DESTINATION share/hawser)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/hawser)
foreach(name desk.html convert.cjs)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/web/dist/${name} ${PROJECT_BINARY_DIR}/share/hawser/${name} SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/library ${PROJECT_BINARY_DIR}/share/hawser/library SYMBOLIC)
install(DIRECTORY include/hawser DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")

# The pkg-config file finds the prefix from its own place, so that the tree may be moved.
file(RELATIVE_PATH HAWSER_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
list(JOIN HAWSER_PRIVATE_PACKAGES " " HAWSER_PC_REQUIRES)
list(JOIN HAWSER_PRIVATE_LIBRARIES " " HAWSER_PC_LIBRARIES)
configure_file(cmake/hawser.pc.in hawser.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/hawser.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hawser)
configure_package_config_file(cmake/hawserConfig.cmake.in hawserConfig.cmake INSTALL_DESTINATION ${package_dir}
                              PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(hawserConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hawserConfig.cmake ${PROJECT_BINARY_DIR}/hawserConfigVersion.cmake
        DESTINATION ${package_dir})
install(EXPORT hawserTargets NAMESPACE hawser:: DESTINATION ${package_dir})
