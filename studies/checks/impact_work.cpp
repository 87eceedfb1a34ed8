#include <Eigen/LU>
#include <cmath>
#include <string>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/checks/profiles/particle_panel.hpp"
#include "studies/problems/parameters.hpp"
#include "studies/settings/part.hpp"

namespace mpmvv::checks {

namespace {

using Mat = solver::Mat<2>;
using Material = solver::NeoHookeanSquare;

/// A Kirchhoff stress in plane strain, split as N's code keeps it: τ = s - p I, p = -tr τ/3.
struct SplitStress {
  double pressure = 0;
  Mat deviator = Mat::Zero();

  SplitStress() = default;
  SplitStress(const Material& material, const Mat& F) {
    const Mat tau = material.kirchhoff(F);
    const double J = F.determinant(), tau_zz = material.lambda / 2 * (J * J - 1);
    pressure = -(tau.trace() + tau_zz) / 3;
    deviator = tau + pressure * Mat::Identity();
  }
};

/// The energy that two blocks have lost in the impact, N §3.1: with the strain energy W(F), and with the one that N's
/// code adds up,
///   U' = U - n (p + p')/2 (1 - ΔJ^(-1/n)) + (s + s')/2 : Δt L,   exp(Δt L) = F' F⁻¹, ΔJ = det F' / det F,
/// where n is how often a step updates F. The parts of a step are taken as equal, which changes what they add by a
/// thousandth. Right for the pressure would be -p ln ΔJ: Neohookean::MPMConstitutiveLaw (docs/misprints.md, C5).
class CountedBlocks {
 public:
  CountedBlocks(const cases::Case& c, int updates)
      : CountedBlocks(settings::part_of(c).value_or(settings::Part{c}), updates) {}

  double loss() const { return loss_; }                  ///< over the energy at the start
  double counted_loss() const { return counted_loss_; }  ///< the same, as N's code counts it

 private:
  CountedBlocks(const settings::Part& part, int updates) : updates_(updates), blocks_(part.body, part.images) {
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
    const Mat change = F * F_[id].inverse(), A = change - Mat::Identity();
    const Mat L_dt =
        A - A * A / 2 + A * A * A / 3;  // ln(I + A), |A| < 0.01: the next term is 1e-7 of the first at most
    const SplitStress now(material_, F);
    const double shear = (now.deviator + stress_[id].deviator).cwiseProduct(L_dt).sum() / 2;
    const double dilation = updates_ * (1 - std::pow(change.determinant(), -1.0 / updates_));
    work_ += V0 * (shear - (now.pressure + stress_[id].pressure) / 2 * dilation);
    F_[id] = F, stress_[id] = now;
  }

  int updates_;
  Material material_ =
      problems::material_of<Material>(problems::complete_parameters(problems::find_problem("impact", "the check"), {}));
  profiles::MovingBody<2> blocks_;
  std::vector<Mat> F_;               ///< by particle id, of the step before
  std::vector<SplitStress> stress_;  ///< the same
  double work_ = 0, loss_ = 0, counted_loss_ = 0;
};

struct Method {
  const char *name, *integrator;
  int updates;  ///< of F in a step
  settings::Setting update, more;
};

CountedBlocks run(const Method& method, int cells) {
  const std::vector<settings::Setting> settings{{"problem", "impact", ""},
                                                {"basis", "cpdi", ""},
                                                {"ppc", "2", ""},
                                                {"deformation", "exponential", ""},
                                                {"dt", "1e-6", ""},
                                                {"cells", std::to_string(cells), ""},
                                                {"integrator", method.integrator, ""},
                                                method.update,
                                                method.more};
  return {settings::make_case(settings), method.updates};
}

}  // namespace

/// Measures what N's code would say of the energy of N's blocks: study n-fig5-work, claim N-fig5. x is the number of
/// cells per 10 mm.
CheckResult check_impact_work() {
  const settings::Setting flip{"velocity_update", "flip", ""}, fmpm{"velocity_update", "fmpm", ""};
  const settings::Setting second{"position", "second-order", ""}, eight{"order", "8", ""}, sixteen{"order", "16", ""};
  CheckResult result;
  for (const Method& method :
       {Method{"FLIP, USAVG+", "usavg+", 2, flip, second}, Method{"FMPM(8), USL", "usl", 1, fmpm, eight},
        Method{"FMPM(8), USF", "usf", 1, fmpm, eight}, Method{"FMPM(16), USL", "usl", 1, fmpm, sixteen}}) {
    std::vector<double> cells, losses, counted;
    for (const int n : {4, 8, 16}) {
      const CountedBlocks blocks = run(method, n);
      cells.push_back(n), losses.push_back(blocks.loss()), counted.push_back(blocks.counted_loss());
    }
    result.add_curve(method.name, cells, losses);
    result.add_curve(std::string(method.name) + ", as N's code counts", cells, counted);
  }
  return result;
}

}  // namespace mpmvv::checks
