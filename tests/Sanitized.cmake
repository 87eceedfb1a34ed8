# The test programs of a sanitized tree. What need not be compiled again, above all the cases, they take from
# MPMVV_PLAIN.
#
# Address and undefined behaviour: every room of the program is instrumented. The cases are those of the plain build,
# which try all bases in all dimensions. Compiled again with only two bases in the plane, they took as long as the
# program. Mistakes are not seen in the cases themselves, nor in templates and inlined functions of the rooms where a
# case has its own copy of them.
set(MPMVV_PLAIN "" CACHE PATH "build folder without sanitizers, whose cases and rooms are linked")

# Sets `filter` to the cases that a file names: one pattern of GoogleTest's filters a line, '-' before those left out.
function(mpmvv_filter file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} patterns REGEX "^[^#]")
  set(left_out ${patterns})
  list(FILTER patterns EXCLUDE REGEX "^-")
  list(FILTER left_out INCLUDE REGEX "^-")
  list(TRANSFORM left_out REPLACE "^-" "")
  string(JOIN ":" patterns ${patterns})
  string(JOIN ":" left_out ${left_out})
  set(filter "${patterns}-${left_out}" PARENT_SCOPE)
endfunction()

# Two tests for each program, half of its cases each: a process for each case would take longer to start than the case
# to run.
function(mpmvv_sanitized_test name)
  foreach(shard 0 1)
    add_test(NAME test_${name}_${shard} COMMAND test_${name} --gtest_brief=1 --gtest_filter=${filter})
    set_tests_properties(test_${name}_${shard} PROPERTIES
      ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${shard};MPMVV_PROGRAM=${PROJECT_BINARY_DIR}/mpmvv")
  endforeach()
endfunction()

# The objects of the rooms stand before the cases, so that the linker takes their instrumented copy of what both
# instantiate.
function(mpmvv_instrumented_rooms name)
  set(cases ${MPMVV_PLAIN}/tests/libcases_${name}.a)
  list(TRANSFORM ARGN PREPEND mpmvv_ OUTPUT_VARIABLE rooms)
  list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  add_executable(test_${name} ${objects})
  target_link_libraries(test_${name} PRIVATE
    "$<LINK_LIBRARY:WHOLE_ARCHIVE,${cases}>" ${rooms} GTest::gtest_main GTest::gmock fmt::fmt)
  mpmvv_sanitized_test(${name})
endfunction()

mpmvv_rooms(read_rooms run_rooms)

# Threads: the solver has them, and the pool of cases in studies/plan. Only these two rooms and their cases that run
# threads are instrumented. The other rooms are the plain build's: a race of two cases over their memory would not be
# seen.
if(MPMVV_SANITIZE STREQUAL "thread")
  foreach(room ${read_rooms} ${run_rooms} mms)
    set_target_properties(mpmvv_${room} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endforeach()
  mpmvv_filter(sanitized_threads.txt)
  # The longest first.
  file(GLOB plan CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/studies/plan/*.cpp)
  add_executable(test_studies ${plan} studies/plan/admission_test.cpp studies/plan/study_runner_test.cpp)
  add_executable(test_solver solver/fault_test.cpp solver/repeatability_test.cpp solver/stencils.cpp
    solver/surface_load_test.cpp solver/thread_pool_test.cpp solver/wall_test.cpp)
  list(REMOVE_ITEM run_rooms plan)
  list(TRANSFORM read_rooms REPLACE "(.+)" "${MPMVV_PLAIN}/studies/libmpmvv_\\1.a" OUTPUT_VARIABLE read)
  list(TRANSFORM run_rooms REPLACE "(.+)" "${MPMVV_PLAIN}/studies/libmpmvv_\\1.a" OUTPUT_VARIABLE plain)
  list(APPEND plain ${read} ${MPMVV_PLAIN}/mms/libmpmvv_mms.a)
  list(JOIN plain "," plain)
  target_link_libraries(test_studies PRIVATE
    "$<LINK_GROUP:RESCAN,${plain}>" SQLite::SQLite3 tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json
    pugixml::pugixml ZLIB::ZLIB)
  foreach(name solver studies)
    target_compile_options(test_${name} PRIVATE -O0)
    target_compile_definitions(test_${name} PRIVATE MPMVV_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_link_libraries(test_${name} PRIVATE mpmvv_solver GTest::gtest_main GTest::gmock fmt::fmt)
    mpmvv_sanitized_test(${name})
  endforeach()
else()
  mpmvv_filter(sanitized_memory.txt)
  # The longest first.
  mpmvv_instrumented_rooms(cli ${read_rooms} goldens)
  # These tests start the program hundreds of times, and half of each start's time went into the search for leaks, the
  # memory of frames that have returned and the place of each allocation. The other test programs have all three for the
  # other rooms. For cli, test_cli_leaks has them: it runs some of these tests again.
  string(JOIN ":" quick_starts strict_string_checks=1 detect_stack_use_after_return=0 quarantine_size_mb=4
    malloc_context_size=1 external_symbolizer_path=/usr/bin/addr2line)
  set_property(TEST test_cli_0 test_cli_1 APPEND PROPERTY ENVIRONMENT
    LSAN_OPTIONS=detect_leaks=0 ASAN_OPTIONS=${quick_starts})
  mpmvv_instrumented_rooms(studies ${read_rooms} ${run_rooms} solver mms)
  mpmvv_instrumented_rooms(solver solver mms)
  mpmvv_instrumented_rooms(reports ${read_rooms} reports)
  mpmvv_instrumented_rooms(mms mms)
  mpmvv_instrumented_rooms(goldens ${read_rooms} goldens)
  mpmvv_filter(sanitized_leaks.txt)
  add_test(NAME test_cli_leaks COMMAND test_cli --gtest_brief=1 --gtest_filter=${filter})
  set_tests_properties(test_cli_leaks PROPERTIES ENVIRONMENT MPMVV_PROGRAM=${PROJECT_BINARY_DIR}/mpmvv)
endif()
