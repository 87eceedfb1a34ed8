# The solutions as libraries for other projects: find_package(mpmvv), targets mpmvv::mms_c and mpmvv::mms. They are a
# component of their own, because users of the program need none of it: cmake --install build/release --component
# library.
include(CMakePackageConfigHelpers)

set(mpmvv_package ${CMAKE_INSTALL_LIBDIR}/cmake/mpmvv)
configure_package_config_file(cmake/mpmvvConfig.cmake.in ${PROJECT_BINARY_DIR}/mpmvvConfig.cmake
  INSTALL_DESTINATION ${mpmvv_package} PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mpmvvConfigVersion.cmake COMPATIBILITY SameMinorVersion)

set(mpmvv_library COMPONENT library EXCLUDE_FROM_ALL)
install(TARGETS mpmvv_mms mpmvv_mms_c ${mpmvv_library})
install(FILES mms/c/mpmvv_mms.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${mpmvv_library})
install(DIRECTORY mms DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mpmvv ${mpmvv_library} FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_BINARY_DIR}/mpmvvConfig.cmake ${PROJECT_BINARY_DIR}/mpmvvConfigVersion.cmake
  DESTINATION ${mpmvv_package} ${mpmvv_library})
