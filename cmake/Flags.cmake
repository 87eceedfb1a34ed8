# One interface target carries the language level and the warnings; every target of the project links it. Warnings are
# errors with the presets only: with other flags a compiler may warn of what is not there.
include(CheckCXXSourceRuns)

set(MPMVV_ARCH "auto" CACHE STRING
  "value of -march, or 'auto': x86-64-v3 where the processor has it, with the registers of AVX-512 in space")
set(MPMVV_SANITIZE "" CACHE STRING "sanitizers to build with, as in -fsanitize=")

set(mpmvv_arch_flag "")
# Only the sources for space use 32 registers of four numbers instead of 16: with g++ 12 a step in space then takes 0.9
# of the time, but one in the plane 1.03 of it. Results are the same to the last bit (tests/cli/install_test.cpp).
set(mpmvv_flags_in_space "")
if(MPMVV_ARCH STREQUAL "auto" AND CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  message(STATUS "MPMVV_ARCH=auto: this machine cannot ask the other's processor, so -march is left to the compiler")
elseif(MPMVV_ARCH STREQUAL "auto")
  set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3")
  check_cxx_source_runs("int main() { return !(__builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\")); }"
                        MPMVV_HAS_X86_64_V3)
  if(MPMVV_HAS_X86_64_V3)
    set(mpmvv_arch_flag -march=x86-64-v3)
    check_cxx_source_runs("int main() { return !__builtin_cpu_supports(\"avx512vl\"); }" MPMVV_HAS_AVX512VL)
    if(MPMVV_HAS_AVX512VL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      set(mpmvv_flags_in_space -mavx512vl -mprefer-vector-width=256)
    endif()
  endif()
  unset(CMAKE_REQUIRED_FLAGS)
elseif(MPMVV_ARCH STREQUAL "native")
  message(FATAL_ERROR "MPMVV_ARCH=native: results of two processors could not be told apart (x86-64-v3 or another name)")
elseif(MPMVV_ARCH)
  set(mpmvv_arch_flag -march=${MPMVV_ARCH})
endif()

# How g++ arranges the code of solver and mms. It copies matrices with 32 bytes at once, so that a load does not wait
# for two stores, and unrolls the loops over a CPDI particle's corners: on an Intel processor a case takes 0.965 (cube),
# 0.9 (impact) or 0.88 (shell with cpdi) of the time that it takes without. Results are the same to the last bit, too.
# With studies/runs they were not: g++ fused other products of an angular momentum there.
set(mpmvv_tuning "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND mpmvv_arch_flag STREQUAL "-march=x86-64-v3")
  set(mpmvv_tuning -mtune=skylake-avx512 --param=max-completely-peeled-insns=500)
endif()

add_library(mpmvv_flags INTERFACE)
target_include_directories(mpmvv_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(mpmvv_flags INTERFACE cxx_std_20)
# Matrices of packs (solver/simd/pack.hpp) are aligned like registers of four numbers, also where registers are shorter.
target_compile_definitions(mpmvv_flags INTERFACE EIGEN_MAX_STATIC_ALIGN_BYTES=32)
# NaN and infinity keep their meaning: neither of these two flags assumes that they do not occur.
target_compile_options(mpmvv_flags INTERFACE
  ${mpmvv_arch_flag} -ffp-contract=fast -fno-math-errno -fno-trapping-math
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-psabi)  # on passing four numbers where no register holds them: such functions are inlined
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(mpmvv_flags INTERFACE
    -Wno-restrict  # g++ 12 sees an overlap in "text" + std::string() that is not there (GCC bug 105651)
    -Wno-subobject-linkage  # in a batch g++ takes a file's anonymous namespace for that of a header
    # The compiler collects garbage from 1 GiB on instead of 128 MiB: it takes a tenth less time, and 1.7 GiB at most
    # for a room.
    --param=ggc-min-heapsize=1000000)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    # It takes every reference that a function with a temporary argument returns for one to that argument.
    target_compile_options(mpmvv_flags INTERFACE -Wno-dangling-reference)
  endif()
  if(mpmvv_arch_flag MATCHES "x86-64-v4")
    # g++ 12 warns of uninitialized variables in its own header for AVX-512 (GCC bug 105593).
    target_compile_options(mpmvv_flags INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized)
  endif()
else()
  target_compile_options(mpmvv_flags INTERFACE -Wno-sign-conversion)  # g++'s -Wconversion leaves it out in C++
endif()
if(MPMVV_SANITIZE)
  # The code that a sanitizer adds raises false warnings, so warnings are left to the other builds. The checks that are
  # left out double the time to compile the solver, and the address sanitizer finds most of what they find.
  target_compile_options(mpmvv_flags INTERFACE -w -fsanitize=${MPMVV_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
  target_link_options(mpmvv_flags INTERFACE -fsanitize=${MPMVV_SANITIZE})
endif()
