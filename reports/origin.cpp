#include "reports/origin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "studies/store/version.hpp"

namespace mpmvv::reports {

namespace {

auto all_but_time(const store::Provenance& p) {
  return std::tie(p.digest, p.commit, p.dirty, p.compiler, p.flags, p.build_type, p.cpu);
}

const std::string& time_of(const Origin& origin) {
  return origin.provenance.time;
}

}  // namespace

std::vector<Origin> origins_of(const Provenances& provenances) {
  std::vector<Origin> origins;
  for (const auto& [study, provenance] : provenances) {
    auto origin = std::ranges::find_if(
        origins, [&](const Origin& o) { return all_but_time(o.provenance) == all_but_time(provenance); });
    if (origin == origins.end()) origin = origins.insert(origin, {provenance, 0});
    ++origin->studies;
    origin->provenance.time = std::max(time_of(*origin), provenance.time);
  }
  std::ranges::stable_sort(origins, std::ranges::greater(), time_of);
  return origins;
}

std::string studies_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "study" : "studies");
}

std::string versions_text(const std::vector<Origin>& origins) {
  std::vector<std::string> versions;
  for (const Origin& origin : origins) {
    const auto& p = origin.provenance;
    const std::string version = store::in_short(p.commit + (p.dirty ? "-dirty" : ""));
    if (std::ranges::find(versions, version) == versions.end()) versions.push_back(version);
  }
  return fmt::format("{}", fmt::join(versions, ", "));
}

}  // namespace mpmvv::reports
