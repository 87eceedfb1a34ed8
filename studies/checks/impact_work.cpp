#include <Eigen/LU>
#include <string>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/checks/profiles/particle_panel.hpp"
#include "studies/settings/part.hpp"

namespace mpmvv::checks {

namespace {

using Mat = solver::Mat<2>;

/// The Kirchhoff stress of N (6) in plane strain, split as N's code keeps it.
struct SplitStress {
  double pressure = 0;  ///< -tr τ/3
  Mat deviator = Mat::Zero();

  SplitStress() = default;
  SplitStress(const Mat& F, double lambda, double mu) {
    const Mat B = F * F.transpose();
    const double J = F.determinant(), third = (B.trace() + 1) / 3;
    pressure = -(lambda / 2 * (J * J - 1) + mu * (third - 1));
    deviator = mu * (B - third * Mat::Identity());
  }
};

/// The energy of two blocks, N §3.1, with the strain energy W(F), and with the one that N's code adds up step by step,
///   U' = U - (p + p')/2 (1 - 1/ΔJ) + (s + s')/2 : Δt L,   exp(Δt L) = F' F⁻¹,
/// where -p ln ΔJ would be right for the pressure's part: Neohookean::MPMConstitutiveLaw (docs/misprints.md, C5).
class CountedBlocks {
 public:
  explicit CountedBlocks(const std::vector<settings::Setting>& settings)
      : CountedBlocks(settings::part_of(settings::make_case(settings)).value()) {}

  double loss() const { return loss_; }                  ///< over the energy at the start
  double counted_loss() const { return counted_loss_; }  ///< the same, as N's code counts it

 private:
  static constexpr double E = 1e7, nu = 0.33;
  static constexpr double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));

  explicit CountedBlocks(const settings::Part& part) : blocks_(part.body, part.images) {
    const auto& particles = blocks_.mpm().particles();
    F_.assign(particles.size(), Mat::Identity());
    stress_.resize(particles.size());
    const double start = blocks_.mpm().kinetic_energy();
    for (std::int64_t step = 1; step <= blocks_.resolution().steps; ++step) {
      blocks_.step_to(step);
      for (std::size_t p = 0; p < particles.size(); ++p) add_work(particles.id[p], particles.F[p], particles.V0[p]);
    }
    const double kinetic = blocks_.mpm().kinetic_energy();
    loss_ = 1 - (kinetic + blocks_.mpm().strain_energy()) / start;
    counted_loss_ = 1 - (kinetic + count(part.images) * work_) / start;
  }

  void add_work(std::uint32_t id, const Mat& F, double V0) {
    if (F == F_[id]) return;
    const Mat change = F * F_[id].inverse(), A = change - Mat::Identity();
    const Mat L_dt = A - A * A / 2 + A * A * A / 3;  // ln(I + A); the next term is below 1e-9 of the first
    const SplitStress now(F, lambda, mu);
    work_ += V0 * ((now.deviator + stress_[id].deviator).cwiseProduct(L_dt).sum() / 2 -
                   (now.pressure + stress_[id].pressure) / 2 * (1 - 1 / change.determinant()));
    F_[id] = F, stress_[id] = now;
  }

  profiles::MovingBody<2> blocks_;
  std::vector<Mat> F_;               ///< by particle id, of the step before
  std::vector<SplitStress> stress_;  ///< the same
  double work_ = 0, loss_ = 0, counted_loss_ = 0;
};

}  // namespace

/// Measures what N's code would say of the energy of the blocks of n-fig3a and n-fig5: claims N-fig3a, N-fig5. x is the
/// number of cells per 10 mm.
CheckResult check_impact_work() {
  struct Method {
    const char *name, *integrator, *update;
    settings::Setting more;
  };
  const settings::Setting second{"position", "second-order", ""}, eight{"order", "8", ""}, sixteen{"order", "16", ""};
  CheckResult result;
  for (const auto& [name, integrator, update, more] :
       {Method{"FLIP, USAVG+", "usavg+", "flip", second}, Method{"FMPM(8), USL", "usl", "fmpm", eight},
        Method{"FMPM(8), USF", "usf", "fmpm", eight}, Method{"FMPM(16), USL", "usl", "fmpm", sixteen}}) {
    std::vector<double> cells, losses, counted;
    for (const int n : {4, 8, 16}) {
      const CountedBlocks blocks({{"problem", "impact", ""},
                                  {"basis", "cpdi", ""},
                                  {"ppc", "2", ""},
                                  {"deformation", "exponential", ""},
                                  {"dt", "1e-6", ""},
                                  {"cells", std::to_string(n), ""},
                                  {"integrator", integrator, ""},
                                  {"velocity_update", update, ""},
                                  more});
      cells.push_back(n), losses.push_back(blocks.loss()), counted.push_back(blocks.counted_loss());
    }
    result.add_curve(name, cells, losses);
    result.add_curve(std::string(name) + ", as N's code counts", cells, counted);
  }
  return result;
}

}  // namespace mpmvv::checks
