#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks::profiles {

/// A run that a check looks at while it proceeds, of all particles or without those that are images of others.
template <int D>
class MovingBody {
 public:
  explicit MovingBody(const std::vector<settings::Setting>& settings, solver::Images images = solver::Images::none)
      : MovingBody(settings::make_case(settings), images) {}
  MovingBody(cases::Case c, solver::Images images)
      : case_(std::move(c)),
        prepared_(runs::prepare_case<D>(case_, problems::find_problem(case_.problem.name, "the check"), 1, images)),
        mpm_(std::move(prepared_.scene)) {}

  const cases::Resolution& resolution() const { return case_.resolution; }
  const solver::Mpm<D>& mpm() const { return mpm_; }
  const mms::ManufacturedSolution<D>& solution() const { return *prepared_.setup.solution; }
  const std::vector<solver::Vec<D>>& X() const { return prepared_.X; }  ///< reference positions by particle id
  /// Returns how many particles of the body a particle stands for, itself and its images.
  int count_of(std::uint32_t id) const { return prepared_.count_of(id); }

  /// Advances the run until `step` steps are done. Throws std::runtime_error when the run blows up.
  void step_to(std::int64_t step) {
    for (; step_ < step; ++step_)
      if (!mpm_.step(case_.resolution.dt)) throw std::runtime_error(case_.problem.name + ": " + mpm_.fault());
  }

 private:
  cases::Case case_;
  runs::PreparedCase<D> prepared_;
  solver::Mpm<D> mpm_;
  std::int64_t step_ = 0;
};

/// Returns the particles that `wanted(id)` chooses, seen along z: positions, and the widths of their voxels where the
/// basis takes widths.
template <int D, class Wanted>
records::Series particle_panel(const std::string& name, const solver::Mpm<D>& mpm, const Wanted& wanted) {
  const auto& particles = mpm.particles();
  records::Series panel{name, {}, {}, {}};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (!wanted(particles.id[p])) continue;
    records::Point point{particles.x[p][0], records::Status::ok, "", {{"y", particles.x[p][1]}}};
    if (!particles.l.empty()) {
      point.y["width_x"] = particles.l[p][0] * mpm.grid().h();
      point.y["width_y"] = particles.l[p][1] * mpm.grid().h();
    }
    panel.points.push_back(point);
  }
  return panel;
}

}  // namespace mpmvv::checks::profiles
