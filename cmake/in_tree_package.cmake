# find_package(alembert) finds this build, in this project and in those that it is part of: the targets are there already.
include(CMakePackageConfigHelpers)
file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/alembert-config.cmake "set(alembert_FOUND TRUE)\n")
write_basic_package_version_file(${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/alembert-config-version.cmake COMPATIBILITY SameMajorVersion)
