#include "studies/codes/matching.hpp"

#include <fmt/format.h>

#include "studies/codes/output_fault.hpp"

namespace mpmvv::codes {

using records::Status;

namespace {

/// Ids count from 1 in the order in which particles fill the body.
std::vector<std::size_t> match_ids(const Snapshot& s, std::size_t particles) {
  std::vector<std::size_t> found;
  std::vector<bool> taken(particles, false);
  for (const std::int64_t id : s.id) {
    if (id < 1 || id > static_cast<std::int64_t>(particles))
      throw OutputFault(Status::failed,
                        fmt::format("particle {} in {} (the case has particles 1 to {})", id, s.file, particles));
    const auto p = static_cast<std::size_t>(id - 1);
    if (taken[p]) throw OutputFault(Status::failed, fmt::format("particle {} stands twice in {}", id, s.file));
    taken[p] = true;
    found.push_back(p);
  }
  return found;
}

}  // namespace

template <int D>
std::vector<std::size_t> match(const CaseParticles<D>& particles, const Output& output) {
  const Snapshot& end = output.end;
  if (end.size() != particles.size())
    throw OutputFault(Status::failed,
                      fmt::format("{} particles in {}, the case has {}", end.size(), end.file, particles.size()));
  if (!end.id.empty()) return match_ids(end, particles.size());
  throw OutputFault(Status::failed, fmt::format("nothing in {} says which particle is which (an id)", end.file));
}

template std::vector<std::size_t> match<1>(const CaseParticles<1>&, const Output&);
template std::vector<std::size_t> match<2>(const CaseParticles<2>&, const Output&);
template std::vector<std::size_t> match<3>(const CaseParticles<3>&, const Output&);

}  // namespace mpmvv::codes
