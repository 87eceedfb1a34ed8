#include <stdexcept>
#include <string>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/runs/norms.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks {

using settings::Setting;

namespace {

/// The bar of N §3.4 in one dimension, stretched until it separates: until two neighbours are 1.5 times as far apart as
/// the elongation alone makes them. A run that blows up before that says nothing of the bar, so it ends the check.
class PulledBar {
 public:
  explicit PulledBar(const std::vector<Setting>& scheme) : c_(settings::make_case(settings(scheme))) {
    runs::PreparedCase<1> prepared = runs::prepare_case<1>(c_, problems::find_problem(c_.problem.name, ""), 1);
    solver::Mpm<1> mpm(std::move(prepared.scene));
    const double rate = c_.problem.parameters.at("rate"), spacing = prepared.X[1][0] - prepared.X[0][0];
    x_.resize(prepared.X.size());
    for (std::int64_t step = 1; step <= c_.resolution.steps && !separated_; ++step) {
      if (!mpm.step(c_.resolution.dt)) throw std::runtime_error("elongation: " + mpm.fault());
      const double elongation = 100 * rate * mpm.time();
      separated_ = largest_spacing(mpm.particles()) > 1.5 * spacing * (1 + elongation / 100);
      elongation_ = elongation;
      if (elongation < 5 * static_cast<double>(errors_.size() + 1) && !separated_) continue;
      runs::ErrorNorms norms;
      for (std::size_t p = 0; p < x_.size(); ++p)
        norms.add(std::abs(mpm.particles().v[p][0] - rate * prepared.X[mpm.particles().id[p]][0]));
      elongations_.push_back(elongation);
      errors_.push_back(100 / prepared.setup.speed * norms.l2());
    }
  }

  void add_to(CheckResult& result, const std::string& name, const std::string& meaning) const {
    result.add(name, elongation_, meaning + ": elongation at separation, else at the end, %");
    result.add(name + "_separated", separated_ ? 1 : 0, meaning + ": 1 when it has separated by 690 %");
    result.add_curve(meaning, elongations_, errors_);
  }

 private:
  static std::vector<Setting> settings(const std::vector<Setting>& scheme) {
    std::vector<Setting> all{{"problem", "stretch-1d", ""},
                             {"integrator", "usl", ""},
                             {"cells", "16", ""},
                             {"ppc", "2", ""},
                             {"cfl", "0.1", ""},
                             {"end_time", "2760", ""}};
    all.insert(all.end(), scheme.begin(), scheme.end());
    return all;
  }

  double largest_spacing(const solver::Particles<1>& particles) {
    for (std::size_t p = 0; p < x_.size(); ++p) x_[particles.id[p]] = particles.x[p][0];
    double largest = 0;
    for (std::size_t p = 1; p < x_.size(); ++p) keep_larger(largest, x_[p] - x_[p - 1]);
    return largest;
  }

  cases::Case c_;
  std::vector<double> x_;  ///< positions by particle id, which is the order along the bar
  double elongation_ = 0;
  bool separated_ = false;
  std::vector<double> elongations_, errors_;
};

}  // namespace

/// Measures the elongation at which the bar separates, N §3.4, fourth observation. The walls are as deep as N advises:
/// 1 cell for CPDI and 1.5 for B2CPDI.
CheckResult check_elongation() {
  CheckResult result;
  const Setting cpdi{"basis", "cpdi", ""}, splines{"basis", "b2cpdi", ""};
  const Setting fmpm{"velocity_update", "fmpm", ""}, two{"order", "2", ""}, four{"order", "4", ""};
  const Setting deeper{"wall_depth", "1.5", ""}, eliminated{"wall_method", "elimination", ""};
  PulledBar({cpdi, fmpm, two}).add_to(result, "cpdi", "FMPM(2), CPDI");
  PulledBar({splines, fmpm, two, deeper}).add_to(result, "b2cpdi", "FMPM(2), B2CPDI");
  PulledBar({cpdi, fmpm, four, eliminated}).add_to(result, "eliminated", "FMPM(4), CPDI, elimination");
  return result;
}

}  // namespace mpmvv::checks
