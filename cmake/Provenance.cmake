# mpmvv_provenance: the header mpmvv_build_info.hpp, brought up to date by every build, rewritten only when it differs.
# Its flags are those that the solver is compiled with, as the generator sees them.
set(mpmvv_build_info_dir ${PROJECT_BINARY_DIR}/generated)
string(TOUPPER "${CMAKE_BUILD_TYPE}" mpmvv_config)
set(mpmvv_common_flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${mpmvv_config}}")

add_custom_target(mpmvv_build_info
  COMMAND ${CMAKE_COMMAND}
    "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "-DBINARY_DIR=${PROJECT_BINARY_DIR}"
    "-DHEADER=${mpmvv_build_info_dir}/mpmvv_build_info.hpp"
    "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DFLAGS=${mpmvv_common_flags} $<JOIN:$<TARGET_PROPERTY:mpmvv_solver,COMPILE_OPTIONS>, >"
    "-DTUNING=$<JOIN:${mpmvv_tuning}, >"
    "-DFLAGS_IN_SPACE=$<$<CONFIG:Release>:$<JOIN:${mpmvv_flags_in_space}, >>"
    -P ${CMAKE_CURRENT_LIST_DIR}/BuildInfo.cmake
  BYPRODUCTS ${mpmvv_build_info_dir}/mpmvv_build_info.hpp
  COMMENT "Digest of the sources"
  VERBATIM)

add_library(mpmvv_provenance INTERFACE)
target_include_directories(mpmvv_provenance INTERFACE ${mpmvv_build_info_dir})
add_dependencies(mpmvv_provenance mpmvv_build_info)
