# cpack: Debian packages of the program (parapet), of the libraries (libparapet-dev) and, where it is
# built, of the Python package (python3-parapet). The preset
# `deb` builds what they hold and nothing else:
#
#   cmake --preset deb && cmake --build --preset deb && cpack --config build-deb/CPackConfig.cmake

set(PARAPET_MAINTAINER "The Parapet authors <parapet@localhost>" CACHE STRING
  "who answers for the Debian packages: Name <address>")

set(CPACK_GENERATOR DEB)
# Each package has a summary of its own, the first line of its description.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_VENDOR "The Parapet authors")
set(CPACK_PACKAGE_CONTACT "${PARAPET_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL program development)
if(PARAPET_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# What Debian's policy wants beside the files, and only there (see the script).
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/complete.cmake)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME parapet)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Cairo finds fonts by name; the pictures want these.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"finds better debris-flow barriers
Parapet simulates a Herschel-Bulkley debris flow against rigid barriers,
with or without a deflector plate on the crest (a parapet), by
delta-plus-SPH in two dimensions, and lets an optimiser drive the
simulation: hold back as much as possible, launch the overflow as short
as possible, within given limits. Every design that was tried is logged
as JSON.")

# The libraries are static, so their users link what they stand on.
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/debian-packages.txt package_lines REGEX " build ")
set(development_depends "")
foreach(line IN LISTS package_lines)
  string(REGEX MATCH "^[^ ]+" name "${line}")
  if(name MATCHES "-dev$|^pkg-config$" AND NOT name MATCHES "gtest|cli11|spdlog")
    list(APPEND development_depends ${name})
  endif()
endforeach()
list(JOIN development_depends ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libparapet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"debris flow against barriers, libraries and headers
Parapet simulates a Herschel-Bulkley debris flow against rigid barriers
by delta-plus-SPH in two dimensions, and lets an optimiser drive the
simulation.
.
This package holds the static libraries, the headers, a CMake package
that find_package(parapet) finds, and examples.")

# Its module holds the libraries and is of one minor version of Python.
if(PARAPET_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(python_versions "${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-parapet)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${python_versions}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-distributed")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"debris flow against barriers, for Python and clusters
Parapet simulates a Herschel-Bulkley debris flow against rigid barriers
by delta-plus-SPH in two dimensions, and lets an optimiser drive the
simulation.
.
This package holds the module parapet: cases, simulations and studies
as Python objects, the search by ask and tell, and studies whose
simulations run on the workers of a Dask cluster.")
endif()

include(CPack)
