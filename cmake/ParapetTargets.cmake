# Compile settings shared by every target of the project.

add_library(parapet_build_settings INTERFACE)
target_compile_options(parapet_build_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${PARAPET_WARNINGS_AS_ERRORS}>:-Werror>
  # SIMD needs errno-free maths; NaN checks and repeatable bits forbid -ffast-math, and fused
  # multiply-adds are kept out so that every instruction set gives the same bits.
  -fno-math-errno -ffp-contract=off)
if(PARAPET_SANITIZE)
  target_compile_options(parapet_build_settings INTERFACE
    -fsanitize=${PARAPET_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(parapet_build_settings INTERFACE -fsanitize=${PARAPET_SANITIZE})
endif()

# parapet_unity(TARGET): with PARAPET_UNITY its sources are compiled ten at a time: most of the time
# goes into the headers of JSON and Eigen, which are then read and instantiated once for ten.
function(parapet_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${PARAPET_UNITY} UNITY_BUILD_BATCH_SIZE 10)
endfunction()

# parapet_shareable(TARGET): the same objects go into the program and into the Python module. Hidden
# symbols keep position-independent code as fast as the other: calls within a library stay direct and
# can be inlined (measured: docs/performance.md).
function(parapet_shareable target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# parapet_library(NAME sources...): static library parapet_NAME with the alias parapet::NAME and
# its public headers in NAME/include.
function(parapet_library name)
  add_library(parapet_${name} STATIC ${ARGN})
  add_library(parapet::${name} ALIAS parapet_${name})
  set_target_properties(parapet_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(parapet_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_compile_features(parapet_${name} PUBLIC cxx_std_20)
  target_link_libraries(parapet_${name} PRIVATE $<BUILD_INTERFACE:parapet_build_settings>)
  parapet_shareable(parapet_${name})
  parapet_unity(parapet_${name})
endfunction()

# parapet_test(NAME LABEL label SOURCES ... LIBRARIES ...): a GoogleTest program registered with
# CTest under the label of its folder.
function(parapet_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LIBRARIES" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(CMAKE_CROSSCOMPILING)  # tests run under an emulator
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main parapet_build_settings)
  target_compile_options(${name} PRIVATE ${PARAPET_TEST_OPTIONS})
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 120 NO_PRETTY_VALUES
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
endfunction()
