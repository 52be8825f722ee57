# CITATION.cff must be what citation tools expect (Citation File Format 1.2.0) and must name the
# version that CMake builds.
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${citation_file} lines)

# The keys of the first level, with what stands on their line.
set(keys "")
set(n_authors 0)
foreach(line IN LISTS lines)
  if(line MATCHES "\t")
    message(FATAL_ERROR "YAML knows no tabs: ${line}")
  elseif(line MATCHES "^([a-z-]+): *(.*)$")
    set(key ${CMAKE_MATCH_1})
    set(value "${CMAKE_MATCH_2}")
    if(key IN_LIST keys)
      message(FATAL_ERROR "the key ${key} stands twice")
    endif()
    list(APPEND keys ${key})
    string(REGEX REPLACE "^\"(.*)\"$" "\\1" value_of_${key} "${value}")
  elseif(line MATCHES "^[^ #]")
    message(FATAL_ERROR "neither a key nor a part of one: ${line}")
  elseif(key STREQUAL "authors" AND line MATCHES "^  - (name|family-names): *[^ ]")
    math(EXPR n_authors "${n_authors} + 1")
  endif()
endforeach()

# What the format knows on this level, and what it demands.
set(known abstract authors cff-version commit contact date-released doi identifiers keywords license
  license-url message preferred-citation references repository repository-artifact repository-code
  title type url version)
foreach(key IN LISTS keys)
  if(NOT key IN_LIST known)
    message(FATAL_ERROR "the Citation File Format has no key ${key}")
  endif()
endforeach()
foreach(key authors cff-version message title version license)
  if(NOT key IN_LIST keys)
    message(FATAL_ERROR "the key ${key} is missing")
  endif()
endforeach()
if(n_authors EQUAL 0)
  message(FATAL_ERROR "no author has a name")
endif()

foreach(expected "cff-version=1.2.0" "version=${version}" "license=Apache-2.0" "type=software")
  string(REGEX MATCH "^([^=]+)=(.*)$" matched "${expected}")
  if(NOT value_of_${CMAKE_MATCH_1} STREQUAL CMAKE_MATCH_2)
    message(FATAL_ERROR
      "${CMAKE_MATCH_1} is '${value_of_${CMAKE_MATCH_1}}' and should be '${CMAKE_MATCH_2}'")
  endif()
endforeach()
