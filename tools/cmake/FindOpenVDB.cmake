# Finds OpenVDB by its headers and library. Debian 12's own find module, which lies where CMake does not look,
# also asks for parts of Boost that nothing here needs.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
find_library(OpenVDB_LIBRARY openvdb)
find_library(OpenVDB_IMATH_LIBRARY Imath)
find_path(OpenVDB_IMATH_INCLUDE_DIR Imath/half.h)
find_package(TBB REQUIRED)
find_package(Threads REQUIRED)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVDB REQUIRED_VARS OpenVDB_LIBRARY OpenVDB_INCLUDE_DIR OpenVDB_IMATH_LIBRARY
                                                        OpenVDB_IMATH_INCLUDE_DIR)
if(OpenVDB_FOUND AND NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVDB::openvdb PROPERTIES
    IMPORTED_LOCATION "${OpenVDB_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenVDB_INCLUDE_DIR};${OpenVDB_IMATH_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${OpenVDB_IMATH_LIBRARY};TBB::tbb;Threads::Threads")
endif()
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_LIBRARY OpenVDB_IMATH_LIBRARY OpenVDB_IMATH_INCLUDE_DIR)
