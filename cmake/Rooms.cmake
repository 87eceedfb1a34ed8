# What a room is, said once, where it is made: its target, how it is optimized, what it links. The sanitizers
# (tests/Sanitized.cmake) and the batches of tests follow from that.

# How a target's sources compile:
#   COMPUTES  what a run calls: as the preset says. Programs link it first (mpmvv_computing, mpmvv_linked_objects): of a
#             function of a header that several rooms hold the linker takes the first.
#   ALGEBRA   dense algebra at -O1: as the preset says it runs a tenth faster, at -Og it takes 1.6 times as long
#   OTHER     all else at -Og: compiles in two thirds to four fifths of the time that -O1 takes, and `mpmvv score` of
#             590,000 particles runs 1.13 times as long
# With the sanitizers everything compiles faster when it is left as it is.
set(mpmvv_computing_rooms mpmvv_solver mpmvv_mms mpmvv_runs)
list(TRANSFORM mpmvv_computing_rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE mpmvv_computing)
function(mpmvv_optimize target kind)
  set(COMPUTES "")
  set(ALGEBRA $<$<CONFIG:Release>:-O1>)
  set(OTHER $<$<CONFIG:Release,Mutants>:-Og>)
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0> ${${kind}})
endfunction()

# mpmvv_room(FOLDER KIND LINKS...): the room of studies in a folder; it may include what it links.
function(mpmvv_room folder kind)
  get_filename_component(name ${folder} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_library(mpmvv_${name} STATIC ${sources})
  target_link_libraries(mpmvv_${name} PUBLIC mpmvv_flags ${ARGN} PRIVATE fmt::fmt)
  mpmvv_optimize(mpmvv_${name} ${kind})
  set_property(GLOBAL APPEND PROPERTY MPMVV_ROOMS ${name})
endfunction()

# All of the project that a target links, be it by way of others.
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

# The objects of all that a target links, what computes first: before the target's own ones in a program they are those
# of which the linker takes what several hold.
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
