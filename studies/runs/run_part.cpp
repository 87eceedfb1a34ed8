#include "studies/runs/run_part.hpp"

#include "solver/boundary/boundaries.hpp"
#include "studies/runs/run_case.hpp"

namespace mpmvv::runs {

namespace {

/// Turns the numbers of a part into those of the whole, which consists of so many mirror images of the part, itself
/// included. Their momenta cancel.
void add_mirror_images(int images, records::Record& r) {
  r.particles *= images;
  for (double* energy : {&r.energy.kinetic, &r.energy.strain, &r.energy.initial_total}) *energy *= images;
  for (double* change : {&r.balance.momentum, &r.balance.angular_momentum}) *change *= 0;
}

}  // namespace

std::optional<records::Record> run_part(const cases::Case& whole, const settings::Part& part, int threads,
                                        const std::function<void(std::int64_t)>& tell_steps) {
  records::Record r = run_without_images(part.body, part.images, threads, tell_steps);
  if (r.status != records::Status::ok) return std::nullopt;
  if (part.mirror_images > 1) add_mirror_images(part.mirror_images, r);
  // The part has planes of symmetry in the place of periodic faces, across which the whole has no such change.
  if (whole.scheme.boundary.find(solver::Periodic::word) != std::string::npos)
    r.balance.angular_momentum = records::not_measured;
  r.the_case = whole;
  r.images = part.count();
  return r;
}

}  // namespace mpmvv::runs
