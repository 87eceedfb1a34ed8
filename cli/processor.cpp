#include <unistd.h>

#include <cstring>
#include <string_view>

#include "mpmvv_build_info.hpp"

/// A processor without the instructions that the program is built for gets a line, before the first of them would end
/// the program. This file is compiled for every amd64 processor (cli/CMakeLists.txt).
namespace mpmvv::cli {

namespace {

constexpr std::string_view refusal =
    "mpmvv: this processor lacks what the program is built for, AVX2 and FMA (x86-64-v3); built from its sources with "
    "-DMPMVV_ARCH=x86-64 it runs on every one\n";
constexpr int usage_error = 2;

[[gnu::constructor(101)]] void require_processor() {
  if (std::strstr(build_info::flags, "-march=x86-64-v3") == nullptr) return;
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return;
  [[maybe_unused]] const auto written = write(STDERR_FILENO, refusal.data(), refusal.size());
  _exit(usage_error);
}

}  // namespace
}  // namespace mpmvv::cli
