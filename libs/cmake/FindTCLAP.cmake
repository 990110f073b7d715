# The header-only command line parser of Debian's libtclap-dev, as the target TCLAP::TCLAP.
find_path(TCLAP_INCLUDE_DIR tclap/CmdLine.h)
mark_as_advanced(TCLAP_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TCLAP REQUIRED_VARS TCLAP_INCLUDE_DIR)

if(TCLAP_FOUND AND NOT TARGET TCLAP::TCLAP)
  add_library(TCLAP::TCLAP INTERFACE IMPORTED)
  target_include_directories(TCLAP::TCLAP INTERFACE ${TCLAP_INCLUDE_DIR})
endif()
