# Makes rooms: the target of each, how it is optimized and what it links are said once, where the room is made. What the
# sanitizers (tests/Sanitized.cmake) and the batches of tests do follows from that.

# How a target's sources compile:
#   COMPUTES  what a run calls: optimized as the preset says. Programs link it first (mpmvv_computing,
#             mpmvv_linked_objects), because the linker takes the first copy of a header's function that several rooms
#             hold.
#   ALGEBRA   dense algebra at -O1: at the preset's level it would run a tenth faster, at -Og 1.6 times as long
#   OTHER     all else at -Og: compiles in two thirds to four fifths of the time that -O1 takes, and `mpmvv score` of
#             590,000 particles runs 1.13 times as long. The headers of libraries that these targets include are compiled
#             once for all, which saves a tenth of the time that the program takes to compile.
# With the sanitizers (RelWithDebInfo) all are left at -O0, which compiles faster.
set(mpmvv_computing_rooms mpmvv_solver mpmvv_mms mpmvv_runs)
list(TRANSFORM mpmvv_computing_rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE mpmvv_computing)
function(mpmvv_optimize target kind)
  set(COMPUTES "")
  set(ALGEBRA $<$<CONFIG:Release>:-O1>)
  set(OTHER $<$<CONFIG:Release,Mutants>:-Og>)
  set(HEADERS ${OTHER})  # of mpmvv_headers, which the targets of the kind OTHER share
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0> ${${kind}})
  # With CMAKE_POSITION_INDEPENDENT_CODE an executable has other flags than a library, and no compiler shares then.
  if(kind STREQUAL "OTHER" AND NOT CMAKE_POSITION_INDEPENDENT_CODE)
    target_precompile_headers(${target} REUSE_FROM mpmvv_headers)
    target_link_libraries(${target} PRIVATE ${mpmvv_shared_headers})  # for tools that read the headers themselves
  endif()
endfunction()

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers.cpp CONTENT "")
set(mpmvv_shared_headers Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
add_library(mpmvv_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/headers.cpp)
target_link_libraries(mpmvv_headers PRIVATE mpmvv_flags ${mpmvv_shared_headers})
# What ccache kept may be older than the header that CMake has written anew; clang++ would refuse it.
target_compile_options(mpmvv_headers PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
target_precompile_headers(mpmvv_headers PRIVATE
  <algorithm> <array> <charconv> <chrono> <cmath> <filesystem> <functional> <map> <memory> <mutex> <numeric> <optional>
  <ranges> <set> <span> <sstream> <string> <unordered_map> <variant> <vector>
  <Eigen/LU> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)
mpmvv_optimize(mpmvv_headers HEADERS)

# mpmvv_room(FOLDER KIND LINKS...): the room of studies in a folder; it may include what it links.
function(mpmvv_room folder kind)
  get_filename_component(name ${folder} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_library(mpmvv_${name} STATIC ${sources})
  target_link_libraries(mpmvv_${name} PUBLIC mpmvv_flags ${ARGN} PRIVATE fmt::fmt)
  mpmvv_optimize(mpmvv_${name} ${kind})
  set_property(GLOBAL APPEND PROPERTY MPMVV_ROOMS ${name})
endfunction()

# All targets of the project that a target links, directly or by way of others.
function(mpmvv_linked target result)
  get_target_property(links ${target} INTERFACE_LINK_LIBRARIES)
  list(FILTER links INCLUDE REGEX "^mpmvv_")
  list(REMOVE_ITEM links mpmvv_flags)
  set(all ${links})
  foreach(link IN LISTS links)
    mpmvv_linked(${link} more)
    list(APPEND all ${more})
  endforeach()
  list(REMOVE_DUPLICATES all)
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# The objects of all that a target links, those that compute first. They stand before the target's own objects in a
# program, so that the linker takes what several objects hold from them.
function(mpmvv_linked_objects target result)
  mpmvv_linked(${target} linked)
  set(rest ${linked})
  list(REMOVE_ITEM rest ${mpmvv_computing_rooms})
  set(objects "")
  foreach(library IN LISTS mpmvv_computing_rooms rest)
    if(library IN_LIST linked)
      get_target_property(type ${library} TYPE)
      if(type STREQUAL "STATIC_LIBRARY")
        list(APPEND objects $<TARGET_OBJECTS:${library}>)
      endif()
    endif()
  endforeach()
  set(${result} ${objects} PARENT_SCOPE)
endfunction()

# The rooms that do not see the solver, and those that do.
function(mpmvv_rooms apart beside_solver)
  get_property(rooms GLOBAL PROPERTY MPMVV_ROOMS)
  set(without "")
  set(with "")
  foreach(room IN LISTS rooms)
    mpmvv_linked(mpmvv_${room} linked)
    if("mpmvv_solver" IN_LIST linked)
      list(APPEND with ${room})
    else()
      list(APPEND without ${room})
    endif()
  endforeach()
  set(${apart} ${without} PARENT_SCOPE)
  set(${beside_solver} ${with} PARENT_SCOPE)
endfunction()
