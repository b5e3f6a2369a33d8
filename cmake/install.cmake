# What is installed, in two components: `runtime` (headers, package files, the catalogue) and `generator` (the command, installed by
# generator/). What was not built is left out: a build of one target can be installed too. Packages: CPack. Target: uninstall.
if(NOT ALEMBERT_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)
set(package_folder ${ALEMBERT_PACKAGE_FOLDER})

install(TARGETS alembert_runtime EXPORT alembert-runtime-targets FILE_SET HEADERS COMPONENT runtime)
install(EXPORT alembert-runtime-targets NAMESPACE alembert:: DESTINATION ${package_folder} COMPONENT runtime)
configure_package_config_file(cmake/alembertConfig.cmake.in ${PROJECT_BINARY_DIR}/package/alembertConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/alembertConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/alembertConfig.cmake ${PROJECT_BINARY_DIR}/package/alembertConfigVersion.cmake
              cmake/AlembertAddMechanism.cmake DESTINATION ${package_folder} COMPONENT runtime)
file(RELATIVE_PATH relative_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" relative_prefix "${relative_prefix}")
configure_file(cmake/alembert.pc.in ${PROJECT_BINARY_DIR}/package/alembert.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/alembert.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT runtime)

# The package of Python that runs the command, where Debian's Python looks.
if(TARGET alembert)
  install(DIRECTORY src/python/alembert DESTINATION lib/python3/dist-packages COMPONENT generator
          FILES_MATCHING PATTERN *.py PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()

foreach(component runtime generator)
  if(EXISTS ${PROJECT_SOURCE_DIR}/LICENSE AND (component STREQUAL runtime OR TARGET alembert))
    set(document_package_runtime libalembert-dev)
    set(document_package_generator alembert-tools)
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${document_package_${component}} RENAME copyright
            COMPONENT ${component})
  endif()
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake
                    COMMENT "Removing what this build has installed" USES_TERMINAL VERBATIM)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_VENDOR alembert)
  set(CPACK_PACKAGE_CONTACT "the authors of alembert")
  set(CPACK_COMPONENTS_ALL runtime)
  if(TARGET alembert)
    list(APPEND CPACK_COMPONENTS_ALL generator)
  endif()
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libalembert-dev)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS alembert-tools)
  set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Runtime library and CMake functions for mechanisms written by alembert")
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_NAME alembert-tools)
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_SHLIBDEPS ON)
  # The package of Python needs numpy, and a compiler for what alembert.load() writes.
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_RECOMMENDS "python3-numpy, gcc | c-compiler")
  set(CPACK_COMPONENT_GENERATOR_DESCRIPTION "${PROJECT_DESCRIPTION}")
  include(CPack)
endif()
