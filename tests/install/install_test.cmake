# Proves that an installed Parapet can be used by others: the package is found after its prefix
# has moved, no build setting leaks, a program on the solver alone runs, a program on all
# libraries links, the installed examples build and run, and the installed program starts.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_or_fail.cmake)

file(REMOVE_RECURSE ${work_dir})
file(MAKE_DIRECTORY ${work_dir})
run_or_fail("install" ${CMAKE_COMMAND} --install ${build_dir} --config ${config}
  --prefix ${work_dir}/first)
# No path of the first prefix may be left in the package.
file(RENAME ${work_dir}/first ${work_dir}/prefix)

set(flags "")
if(sanitize)
  set(flags -DCMAKE_CXX_FLAGS=-fsanitize=${sanitize})
endif()
# Configures and builds a project against the moved installation, in a folder named after it.
function(build_against_installed name source_dir)
  run_or_fail("configure the ${name}" ${CMAKE_COMMAND}
    -S ${source_dir} -B ${work_dir}/${name} -G ${generator}
    -DCMAKE_MAKE_PROGRAM=${make_program} -DCMAKE_CXX_COMPILER=${compiler}
    -DCMAKE_BUILD_TYPE=${config} -DCMAKE_PREFIX_PATH=${work_dir}/prefix ${flags} ${ARGN})
  run_or_fail("build the ${name}" ${CMAKE_COMMAND} --build ${work_dir}/${name} --config ${config})
endfunction()

build_against_installed(consumer ${consumer_dir} -Dwanted_version=${version})

run_or_fail("step a flow with parapet::flow" ${work_dir}/consumer/bin/step_a_flow)
message(STATUS "${output}")
run_or_fail("simulate with parapet::solver" ${work_dir}/consumer/bin/simulate_once)
message(STATUS "${output}")
run_or_fail("use every library" ${work_dir}/consumer/bin/use_all)
message(STATUS "${output}")
build_against_installed(examples ${work_dir}/prefix/${doc_dir}/examples)
run_or_fail("run an example" ${work_dir}/examples/own_search)
message(STATUS "${output}")
run_or_fail("start the installed program" ${work_dir}/prefix/bin/parapet --help)
run_or_fail("start its validation" ${work_dir}/prefix/bin/parapet validate --list)
