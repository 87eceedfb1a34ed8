# The test programs of a sanitized tree, which take from MPMVV_PLAIN what need not be compiled again: the cases above all.
#
# Address and undefined behaviour: every room of the program is instrumented. The cases are those of the plain build,
# which try all bases in all dimensions; compiled again, they took as long as the program, with two bases in the plane.
# Not seen are mistakes of the cases themselves, and of the rooms' templates and inlined functions where a case makes
# its own of them.
set(MPMVV_PLAIN "" CACHE PATH "build folder without sanitizers, whose cases and rooms are linked")

# Left out are what counts allocations or asks for too much memory, long runs whose code shorter ones cover at least in
# part (in space, fewer pairs of an integrator with a boundary are left; where several bases run the same kernels, one of
# them), what reads the tree's own text or walks its pages, and the comparisons of numbers of threads, which are the
# thread sanitizer's.
set(not_sanitized
  "*Nightly*:Allocation*:*DoesNotDecideTheSquare*:*MassCutoff*:Textbook*:TimeOrder*:*IsHalfAPeriod*:*CannotEnd*:*LittleMemory*"
  ":*ScenesInSpaceMoveAlike:*ContinueIntoSpace:*NoKindOfValueIsABug:*APathOfAnyKind*:*AClosedOrFullStream*"
  ":*EndsWithExamplesThatRun:*EveryCaseOfTheTreeIsOne:*AllOfTheWorkEachOnce:*TheirLongestPieceAllows"
  ":OutsideProblems.TheWave*:OutsideProblems.FromRest*:*SplinesLoseOrder*:*AreThoseOfEverySolution:CostCommand*"
  ":Docs*:Layers*:Manual.Names*:*FitsATerminalOf80Columns:*AreCostedBefore*:*WallsLeaveFree/*cpdi"
  ":HowTo*:OwnStudies*:OtherCodes.FromNothing*:Names.NeverShare*:ConformingFill/1.WholeBody*:OutsideProblems.WithoutABody*"
  ":Kernels.*/gimp:Kernels.*/ugimp:Kernels.*/cpgimp:Kernels.*/bspline2_open:Kernels.*/bspline3"
  ":Part.Of*:*EveryProblemFollowsItsSolution:*ImpactLosesSomeOfItsEnergy:*NumberOfThreads*")
string(CONCAT not_sanitized ${not_sanitized})

# One test for each program: a process for each case would take longer to start than the cases to run.
function(mpmvv_sanitized_test name filter)
  add_test(NAME test_${name} COMMAND test_${name} --gtest_brief=1 --gtest_filter=${filter})
endfunction()

# The objects of the rooms stand before the cases: of what both instantiate the linker takes the first.
function(mpmvv_instrumented_rooms name)
  set(cases ${MPMVV_PLAIN}/tests/libcases_${name}.a)
  list(TRANSFORM ARGN PREPEND mpmvv_ OUTPUT_VARIABLE rooms)
  list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  add_executable(test_${name} ${objects})
  target_link_libraries(test_${name} PRIVATE
    "$<LINK_LIBRARY:WHOLE_ARCHIVE,${cases}>" ${rooms} GTest::gtest_main GTest::gmock fmt::fmt)
  mpmvv_sanitized_test(${name} -${not_sanitized})
endfunction()

mpmvv_rooms(read_rooms run_rooms)

# Threads: the solver has them, and the pool of cases, which is studies/plan's. These two rooms are instrumented, and
# their cases that run threads; the other rooms are the plain build's, in which a race of two cases over the same memory
# would not be seen.
if(MPMVV_SANITIZE STREQUAL "thread")
  foreach(room ${read_rooms} ${run_rooms} mms)
    set_target_properties(mpmvv_${room} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endforeach()
  # Of the bases one with knots at the faces and one with particles' domains.
  set(threaded "ThreadPool*:Slabs*:Repeatable.*:*/bspline3_open:*/cpdi:Wall.Threads*:Admission.*:StudyRunner.*")
  set(not_threaded "*MassCutoff*:*.NumberOfThreadsDoesNotMatter/cpdi")
  add_executable(test_solver solver/fault_test.cpp solver/repeatability_test.cpp solver/stencils.cpp
    solver/surface_load_test.cpp solver/thread_pool_test.cpp solver/wall_test.cpp)
  file(GLOB plan CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/studies/plan/*.cpp)
  add_executable(test_studies ${plan} studies/plan/admission_test.cpp studies/plan/study_runner_test.cpp)
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
    mpmvv_sanitized_test(${name} ${threaded}-${not_threaded})
  endforeach()
else()
  # The longest first.
  mpmvv_instrumented_rooms(cli ${read_rooms} goldens)
  set_tests_properties(test_cli PROPERTIES ENVIRONMENT MPMVV_PROGRAM=$<TARGET_FILE:mpmvv>)
  mpmvv_instrumented_rooms(studies ${read_rooms} ${run_rooms} solver mms)
  mpmvv_instrumented_rooms(solver solver mms)
  mpmvv_instrumented_rooms(reports ${read_rooms} reports)
  mpmvv_instrumented_rooms(mms mms)
  mpmvv_instrumented_rooms(goldens ${read_rooms} goldens)
endif()
