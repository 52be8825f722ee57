# The libraries, their headers and the CMake package that find_package(parapet) finds. The program
# and the shipped specs are installed by the folders that own them.
#
# Each library is a component with an export set of its own, so that a consumer of the solver alone
# needs OpenMP and nothing else. parapet_build_settings stays at home: libraries link it through
# BUILD_INTERFACE, and tests/install checks that no warning flag reaches a consumer.

include(CMakePackageConfigHelpers)

set(parapet_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/parapet)
set(parapet_installed_components "")
set(parapet_component_table "")  # the part of ParapetComponents.cmake that the package needs
foreach(component IN LISTS parapet_chosen_components)
  if(parapet_programs_${component})
    continue()
  endif()
  list(APPEND parapet_installed_components ${component})
  string(APPEND parapet_component_table
    "set(_parapet_needs_${component} ${parapet_needs_${component}})\n"
    "set(_parapet_packages_${component} ${parapet_packages_${component}})\n")
  get_target_property(source_dir parapet_${component} SOURCE_DIR)
  install(TARGETS parapet_${component} EXPORT parapet_${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${source_dir}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp")
  install(EXPORT parapet_${component} FILE parapet-${component}-targets.cmake
    NAMESPACE parapet:: DESTINATION ${parapet_package_dir})
endforeach()
foreach(package IN LISTS parapet_chosen_packages)
  string(APPEND parapet_component_table
    "set(_parapet_find_${package} ${parapet_find_${package}})\n")
endforeach()

configure_package_config_file(cmake/parapet-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/parapet-config.cmake
  INSTALL_DESTINATION ${parapet_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/parapet-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/parapet-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/parapet-config-version.cmake
  DESTINATION ${parapet_package_dir})

install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
