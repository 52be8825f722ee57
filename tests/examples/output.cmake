# What the tests of the examples share. CMake compares decimal numbers but does not calculate with
# them, so sums are taken in whole units of the last digit printed.

# Runs the program, keeps what it prints in `output`, and fails when the program does.
macro(run_program)
  execute_process(COMMAND ${program} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit code ${status}:\n${output}${errors}")
  endif()
endmacro()

# number(VARIABLE REGEX): the first group of REGEX in `output`, which must be a decimal number.
function(number variable regex)
  string(REGEX MATCH "${regex}" found "${output}")
  set(text "${CMAKE_MATCH_1}")
  if(NOT found OR NOT text MATCHES "^-?[0-9]+\\.[0-9]+$")
    message(FATAL_ERROR "no number at '${regex}' in:\n${output}")
  endif()
  set(${variable} ${text} PARENT_SCOPE)
endfunction()

# in_last_digits(VARIABLE DECIMAL): 68.1000 becomes 681000.
function(in_last_digits variable decimal)
  string(REPLACE "." "" digits "${decimal}")
  string(REGEX REPLACE "^(-?)0+([0-9])" "\\1\\2" digits "${digits}")
  set(${variable} ${digits} PARENT_SCOPE)
endfunction()

# expect(CONDITION...): the condition of an if(), or the test fails and shows the output.
function(expect)
  if(NOT (${ARGN}))
    list(JOIN ARGN " " condition)
    message(FATAL_ERROR "expected ${condition} in:\n${output}")
  endif()
endfunction()
