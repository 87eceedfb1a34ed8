# Run by `cmake -P` with NAME, PROGRAM and FILE: writes to FILE a test of CTest for each suite of a test program, named
# after both ("solver/Kernels"). A process for each case would take as long to start as the median case to run.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=-*Nightly.* OUTPUT_VARIABLE list
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+[.]( |\n)" suites "\n${list}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no suite")
endif()
get_filename_component(folder ${FILE} DIRECTORY)
set(tests "")
foreach(line IN LISTS suites)
  string(REGEX REPLACE "^\n(.+)[.].$" "\\1" suite "${line}")
  string(APPEND tests "add_test([=[${NAME}/${suite}]=] [=[${PROGRAM}]=] --gtest_brief=1 [=[--gtest_filter=${suite}.*]=])\n"
    "set_tests_properties([=[${NAME}/${suite}]=] PROPERTIES WORKING_DIRECTORY [=[${folder}]=])\n")
endforeach()
file(WRITE ${FILE} "${tests}")
