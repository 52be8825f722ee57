# What Parapet is made of, as SPDX 2.3 (https://spdx.github.io/spdx-spec/v2.3/): the packages that this
# configuration was built with, their versions and licences. Written when the build is configured and
# installed with the documentation.

# Licence (SPDX expression) and origin of each package of ParapetComponents.cmake.
set(parapet_licence_OpenMP "GPL-3.0-or-later WITH GCC-exception-3.1")
set(parapet_origin_OpenMP "https://gcc.gnu.org/projects/gomp/")
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set(parapet_licence_OpenMP "Apache-2.0 WITH LLVM-exception")
  set(parapet_origin_OpenMP "https://openmp.llvm.org/")
endif()
set(parapet_licence_Eigen3 "MPL-2.0")
set(parapet_origin_Eigen3 "https://eigen.tuxfamily.org/")
set(parapet_licence_NLopt "LGPL-2.1-or-later")
set(parapet_origin_NLopt "https://github.com/stevengj/nlopt")
set(parapet_licence_nlohmann_json "MIT")
set(parapet_origin_nlohmann_json "https://github.com/nlohmann/json")
set(parapet_licence_muparser "BSD-2-Clause")
set(parapet_origin_muparser "https://github.com/beltoforion/muparser")
set(parapet_licence_ZLIB "Zlib")
set(parapet_origin_ZLIB "https://zlib.net/")
set(parapet_licence_fmt "MIT")
set(parapet_origin_fmt "https://github.com/fmtlib/fmt")
set(parapet_licence_spdlog "MIT")
set(parapet_origin_spdlog "https://github.com/gabime/spdlog")
set(parapet_licence_CLI11 "BSD-3-Clause")
set(parapet_origin_CLI11 "https://github.com/CLIUtils/CLI11")
set(parapet_licence_cpp-httplib "MIT")
set(parapet_origin_cpp-httplib "https://github.com/yhirose/cpp-httplib")
set(parapet_licence_cairo "LGPL-2.1-only OR MPL-1.1")
set(parapet_origin_cairo "https://www.cairographics.org/")

# The version that was found; NOASSERTION where the package does not say.
function(parapet_found_version package out)
  string(TOUPPER ${package} upper)
  set(version NOASSERTION)
  foreach(candidate IN ITEMS ${package}_VERSION ${upper}_VERSION ${package}_CXX_VERSION
                            ${package}_VERSION_STRING)
    if(${candidate})
      set(version ${${candidate}})
      break()
    endif()
  endforeach()
  set(${out} ${version} PARENT_SCOPE)
endfunction()

# One package as JSON. LICENCE is NOASSERTION where nobody has looked.
function(parapet_sbom_package out name version licence origin)
  set(json "{}")
  foreach(pair IN ITEMS "SPDXID|SPDXRef-Package-${name}" "name|${name}" "versionInfo|${version}"
                        "downloadLocation|${origin}" "licenseConcluded|${licence}"
                        "licenseDeclared|${licence}" "copyrightText|NOASSERTION")
    string(REGEX MATCH "^([^|]*)[|](.*)$" matched "${pair}")
    string(JSON json SET "${json}" ${CMAKE_MATCH_1} "\"${CMAKE_MATCH_2}\"")
  endforeach()
  string(JSON json SET "${json}" filesAnalyzed false)
  set(${out} "${json}" PARENT_SCOPE)
endfunction()

function(parapet_write_sbom file)
  parapet_sbom_package(own parapet ${PROJECT_VERSION} Apache-2.0 NOASSERTION)
  set(packages "[]")
  set(relations "[{\"spdxElementId\": \"SPDXRef-DOCUMENT\", \"relationshipType\": \"DESCRIBES\", \"relatedSpdxElement\": \"SPDXRef-Package-parapet\"}]")
  string(JSON packages SET "${packages}" 0 "${own}")
  set(n 1)
  foreach(package IN LISTS parapet_chosen_packages)
    if(NOT parapet_licence_${package})
      continue()  # Threads: the C library
    endif()
    parapet_found_version(${package} version)
    string(REPLACE "_" "-" name ${package})  # SPDX identifiers have no underscores
    parapet_sbom_package(json ${name} "${version}" "${parapet_licence_${package}}"
      "${parapet_origin_${package}}")
    string(JSON packages SET "${packages}" ${n} "${json}")
    string(JSON relations SET "${relations}" ${n}
      "{\"spdxElementId\": \"SPDXRef-Package-parapet\", \"relationshipType\": \"DEPENDS_ON\", \"relatedSpdxElement\": \"SPDXRef-Package-${name}\"}")
    math(EXPR n "${n} + 1")
  endforeach()
  # SOURCE_DATE_EPOCH, which CMake honours, makes the file repeatable.
  string(TIMESTAMP created "%Y-%m-%dT%H:%M:%SZ" UTC)
  string(SHA1 content "${packages}")
  set(document "{}")
  foreach(pair IN ITEMS "spdxVersion|SPDX-2.3" "dataLicense|CC0-1.0" "SPDXID|SPDXRef-DOCUMENT"
                        "name|parapet-${PROJECT_VERSION}"
                        "documentNamespace|urn:parapet:${PROJECT_VERSION}:${content}")
    string(REGEX MATCH "^([^|]*)[|](.*)$" matched "${pair}")
    string(JSON document SET "${document}" ${CMAKE_MATCH_1} "\"${CMAKE_MATCH_2}\"")
  endforeach()
  string(JSON document SET "${document}" creationInfo
    "{\"created\": \"${created}\", \"creators\": [\"Tool: parapet-${PROJECT_VERSION}\", \"Tool: cmake-${CMAKE_VERSION}\"]}")
  string(JSON document SET "${document}" packages "${packages}")
  string(JSON document SET "${document}" relationships "${relations}")
  # As it was while nothing but its date changes, so that nothing is installed anew for that.
  if(EXISTS "${file}")
    file(READ "${file}" old)
    string(JSON old_name ERROR_VARIABLE none GET "${old}" documentNamespace)
    string(JSON new_name GET "${document}" documentNamespace)
    if(old_name STREQUAL new_name)
      return()
    endif()
  endif()
  file(WRITE "${file}" "${document}\n")
endfunction()

parapet_write_sbom(${CMAKE_BINARY_DIR}/parapet.spdx.json)
install(FILES ${CMAKE_BINARY_DIR}/parapet.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
