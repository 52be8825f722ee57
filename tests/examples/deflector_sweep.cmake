# A deflector holds back more than the bare stem, and the steepest one more than the flat one.
include(${CMAKE_CURRENT_LIST_DIR}/output.cmake)
run_program()

# The columns: angle, retention, launch length, peak force.
number(bare "none +([0-9.]+)")
foreach(angle 0 15 30 45 60 75)
  number(retention_${angle} "\n${angle} +([0-9.]+)")
  expect(${retention_${angle}} GREATER ${bare})
  expect(${retention_${angle}} LESS 1.0)
endforeach()
# Measured 0.60 and 0.81; equal designs scatter by about 0.02 at this spacing.
in_last_digits(flat ${retention_0})
in_last_digits(steep ${retention_75})
math(EXPR gain "${steep} - ${flat}")
expect(${gain} GREATER 100)
