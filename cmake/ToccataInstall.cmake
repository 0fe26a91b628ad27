# Install rules: the libraries with their headers, a CMake package, relocatable pkg-config files, and the command.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(TOCCATA_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/Toccata)
install(TARGETS toccata toccata_reports EXPORT ToccataTargets)
install(DIRECTORY include/toccata DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT ToccataTargets NAMESPACE Toccata:: DESTINATION ${TOCCATA_CMAKE_FOLDER})
# A package of its own: who asks for it needs MPI.
if(TOCCATA_WITH_MPI)
  install(TARGETS toccata_distributed EXPORT ToccataDistributedTargets)
  install(EXPORT ToccataDistributedTargets NAMESPACE Toccata:: DESTINATION ${TOCCATA_CMAKE_FOLDER})
endif()
if(TOCCATA_BUILD_COMMAND)
  install(TARGETS toccata_command)
  if(TOCCATA_WITH_MPI)
    install(TARGETS toccata_check_ranks toccata_crowd_ranks)
  endif()
endif()

configure_package_config_file(cmake/ToccataConfig.cmake.in ToccataConfig.cmake INSTALL_DESTINATION ${TOCCATA_CMAKE_FOLDER})
write_basic_package_version_file(ToccataConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ToccataConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ToccataConfigVersion.cmake
        DESTINATION ${TOCCATA_CMAKE_FOLDER})

# From <prefix>/<libdir>/pkgconfig back to the prefix, so that the installed tree can be moved.
file(RELATIVE_PATH TOCCATA_PREFIX_FROM_PKGCONFIG /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
# A static library does not bring what it needs, so who links it names that too.
if(BUILD_SHARED_LIBS)
  set(TOCCATA_PC_REQUIRES Requires.private)
else()
  set(TOCCATA_PC_REQUIRES Requires)
endif()
set(TOCCATA_PC_URDF)
if(NOT BUILD_SHARED_LIBS)
  foreach(library IN LISTS TOCCATA_URDF_LIBRARIES)
    string(APPEND TOCCATA_PC_URDF " -l${library}")
  endforeach()
endif()
configure_file(cmake/toccata.pc.in toccata.pc @ONLY)
configure_file(cmake/toccata-reports.pc.in toccata-reports.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/toccata.pc ${CMAKE_CURRENT_BINARY_DIR}/toccata-reports.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
