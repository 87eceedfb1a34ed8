#include <unistd.h>

#include <cstring>
#include <string_view>

#include "mpmvv_build_info.hpp"

/// Refuses a processor without the instructions that the program is built for, in one line, before the first of them
/// would end the program. This file is compiled for every amd64 processor (cli/CMakeLists.txt).
namespace mpmvv::cli {

namespace {

constexpr int usage_error = 2;

void refuse(std::string_view line) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line.data(), line.size());
  _exit(usage_error);
}

bool is_built_with(const char* flag) {
  return std::strstr(build_info::flags, flag) != nullptr;
}

[[gnu::constructor(101)]] void require_processor() {
  __builtin_cpu_init();
  if (is_built_with("-march=x86-64-v3") && !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")))
    refuse(
        "mpmvv: this processor lacks what the program is built for, AVX2 and FMA (x86-64-v3); built from its sources "
        "with -DMPMVV_ARCH=x86-64 it runs on every one\n");
  if (is_built_with("-march=x86-64-v4") && !(__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
                                             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd")))
    refuse(
        "mpmvv: this processor lacks what the program is built for, AVX-512 (x86-64-v4); built from its sources with "
        "-DMPMVV_ARCH=x86-64 it runs on every one\n");
  if (is_built_with("-mavx512vl") && !__builtin_cpu_supports("avx512vl"))
    refuse(
        "mpmvv: this processor lacks what the program is built for, AVX-512; built from its sources with "
        "-DMPMVV_ARCH=x86-64-v3 it needs AVX2 and FMA alone\n");
}

}  // namespace
}  // namespace mpmvv::cli
