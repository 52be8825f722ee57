# The target api_docs: HTML pages of the public headers, in build/api/html. Needs Doxygen; without it
# there is no such target. A public thing without a description is an error.
find_package(Doxygen 1.9.4 QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(api_input "${PROJECT_SOURCE_DIR}/docs/api/mainpage.md")
foreach(component IN LISTS parapet_installed_components)
  get_target_property(source_dir parapet_${component} SOURCE_DIR)
  list(APPEND api_input "${source_dir}/include")
endforeach()
list(TRANSFORM api_input PREPEND "\"")
list(TRANSFORM api_input APPEND "\"")
list(JOIN api_input " " api_input)
configure_file(${PROJECT_SOURCE_DIR}/docs/api/Doxyfile.in ${PROJECT_BINARY_DIR}/api/Doxyfile @ONLY)
add_custom_target(api_docs
  COMMAND ${CMAKE_COMMAND} -DDOXYGEN=$<TARGET_FILE:Doxygen::doxygen>
          -DFOLDER=${PROJECT_BINARY_DIR}/api -P ${PROJECT_SOURCE_DIR}/cmake/api_docs.cmake
  COMMENT "Writing the API pages to ${PROJECT_BINARY_DIR}/api/html"
  VERBATIM)
