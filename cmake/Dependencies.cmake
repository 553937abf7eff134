# The Debian packages that the project stands on; scripts/setup.sh installs them.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(SUNDIALS REQUIRED COMPONENTS cvode nvecserial)
include(cmake/sundials_version.cmake)
pkg_check_modules(YAML REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(EXPAT REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(JANSSON REQUIRED IMPORTED_TARGET jansson)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)

find_library(KLU_LIBRARY klu REQUIRED)
find_library(AMD_LIBRARY amd REQUIRED)
find_library(COLAMD_LIBRARY colamd REQUIRED)
find_library(BTF_LIBRARY btf REQUIRED)
find_library(SUITESPARSECONFIG_LIBRARY suitesparseconfig REQUIRED)
find_path(SUITESPARSE_INCLUDE klu.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(METIS_LIBRARY metis REQUIRED)
find_path(METIS_INCLUDE metis.h REQUIRED)

add_library(hawser_klu INTERFACE)
target_include_directories(hawser_klu SYSTEM INTERFACE ${SUITESPARSE_INCLUDE} ${METIS_INCLUDE})
target_link_libraries(hawser_klu INTERFACE ${KLU_LIBRARY} ${AMD_LIBRARY} ${COLAMD_LIBRARY} ${BTF_LIBRARY}
                                           ${SUITESPARSECONFIG_LIBRARY} ${METIS_LIBRARY} ${CMAKE_DL_LIBS})
