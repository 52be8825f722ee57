# Writes the API pages, and fails on any warning of Doxygen:
#   cmake -DDOXYGEN=doxygen -DFOLDER=build/api -P api_docs.cmake
#
# A warning is accepted in one case only: a data member, or an operator beside a struct, without a
# comment of its own. `std::string name;` says enough, and Doxygen cannot tell these from functions.
execute_process(COMMAND ${DOXYGEN} ${FOLDER}/Doxyfile WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE status)
file(READ ${FOLDER}/warnings.txt warnings)
string(REGEX REPLACE "[^\n]*Member [^\n]* \\((variable|friend)\\) [^\n]* is not documented\\.\n" ""
  warnings "${warnings}")
if(NOT status EQUAL 0 OR NOT warnings STREQUAL "")
  message(NOTICE "${warnings}")
  message(FATAL_ERROR "Doxygen ended with ${status}; its warnings stand above")
endif()
if(NOT EXISTS ${FOLDER}/html/index.html)
  message(FATAL_ERROR "no pages in ${FOLDER}/html")
endif()
