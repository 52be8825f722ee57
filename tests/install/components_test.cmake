# Proves PARAPET_COMPONENTS: each component configures with the packages that it needs and no other;
# the solver alone is built, installed and used with a compiler and OpenMP; a wrong name is refused.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_or_fail.cmake)
include(${source_dir}/cmake/ParapetComponents.cmake)
set(all_components ${parapet_components})

file(REMOVE_RECURSE ${work_dir})
file(MAKE_DIRECTORY ${work_dir})
set(common -G ${generator} -DCMAKE_MAKE_PROGRAM=${make_program} -DCMAKE_CXX_COMPILER=${compiler}
  -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O0")  # quick to compile
if(sanitize)
  list(APPEND common -DCMAKE_CXX_FLAGS=-fsanitize=${sanitize})
endif()

# Options that hide every package which the components do not need.
function(hidden_packages result components)
  set(PARAPET_COMPONENTS ${components})
  include(${source_dir}/cmake/ParapetComponents.cmake)
  set(hidden ${parapet_packages} PkgConfig GTest benchmark Pagmo)
  list(REMOVE_ITEM hidden ${parapet_chosen_packages})
  if("cairo" IN_LIST parapet_chosen_packages)
    list(REMOVE_ITEM hidden PkgConfig)
  endif()
  list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
  set(${result} ${hidden} PARENT_SCOPE)
endfunction()

foreach(component IN LISTS all_components)
  hidden_packages(hidden ${component})
  file(REMOVE ${work_dir}/configured/CMakeCache.txt)
  run_or_fail("configure ${component} with its packages alone" ${CMAKE_COMMAND}
    -S ${source_dir} -B ${work_dir}/configured ${common} -DPARAPET_BUILD_TESTS=OFF
    -DPARAPET_COMPONENTS=${component} ${hidden})
endforeach()

hidden_packages(hidden solver)
run_or_fail("configure the solver alone" ${CMAKE_COMMAND} -S ${source_dir} -B ${work_dir}/solver
  ${common} -DPARAPET_COMPONENTS=solver ${hidden})
run_or_fail("build the solver alone" ${CMAKE_COMMAND} --build ${work_dir}/solver --parallel 2)
run_or_fail("install the solver alone" ${CMAKE_COMMAND} --install ${work_dir}/solver
  --prefix ${work_dir}/prefix)
run_or_fail("configure a program on it" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/solver_alone
  -B ${work_dir}/program ${common} -DCMAKE_PREFIX_PATH=${work_dir}/prefix ${hidden})
run_or_fail("build it" ${CMAKE_COMMAND} --build ${work_dir}/program)
run_or_fail("simulate with it" ${work_dir}/program/simulate_once)
message(STATUS "${output}")

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${source_dir} -B ${work_dir}/wrong ${common}
    -DPARAPET_COMPONENTS=solver,desings
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
string(REGEX REPLACE "[ \n]+" " " out "${out}")
if(status EQUAL 0 OR NOT out MATCHES "no component \"desings\"; there are: all,[a-z, ]* solver, designs,")
  message(FATAL_ERROR "a component that does not exist was not refused (${status}):\n${out}")
endif()
