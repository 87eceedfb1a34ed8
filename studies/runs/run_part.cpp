#include "studies/runs/run_part.hpp"

#include "studies/runs/run_case.hpp"
#include "studies/settings/part.hpp"

namespace mpmvv::runs {

std::optional<records::Record> run_part(const cases::Case& whole, const cases::Case& part, int threads) {
  records::Record r = run_case(part, threads);
  if (r.status != records::Status::ok) return std::nullopt;
  const int images = settings::images_of_part(part);
  r.the_case = whole;
  r.images = images;
  r.particles *= images;
  for (double* energy : {&r.energy.kinetic, &r.energy.strain, &r.energy.initial_total}) *energy *= images;
  for (double* change : {&r.balance.momentum, &r.balance.angular_momentum}) *change *= 0;  // those of images cancel
  return r;
}

}  // namespace mpmvv::runs
