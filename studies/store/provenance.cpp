#include "studies/store/provenance.hpp"

#include <fmt/chrono.h>

#include <fstream>

#include "mpmvv_build_info.hpp"

namespace mpmvv::store {

namespace {

std::string cpu_model() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::string time_text(std::chrono::system_clock::time_point time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

Provenance current_provenance() {
  return {.digest = build_info::digest,
          .commit = build_info::commit,
          .dirty = build_info::dirty,
          .compiler = build_info::compiler,
          .flags = build_info::flags,
          .build_type = build_info::build_type,
          .cpu = cpu_model(),
          .time = time_text(std::chrono::system_clock::now())};
}

Provenance with_present_time(Provenance provenance) {
  provenance.time = time_text(std::chrono::system_clock::now());
  return provenance;
}

}  // namespace mpmvv::store
