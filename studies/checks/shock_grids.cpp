#include "studies/checks/shocked_bar.hpp"

namespace mpmvv {

CheckResult check_shock_grids() {
  const std::vector<double> cells{8, 10, 13, 16, 20};
  const mms::Hugoniot shock = theoretical_shock();
  std::vector<double> plateau, front, temperature;
  for (const double n : cells) {
    const ShockedBar bar({"FMPM(4)", "fmpm", "4", true}, static_cast<int>(n), "2.4e-6", shock);
    plateau.push_back(bar.plateau(bar.pressure).mean / shock.pressure());
    temperature.push_back(bar.plateau(bar.temperature).mean / shock.temperature());
    front.push_back(bar.front / bar.expected_front);
  }
  CheckResult result;
  result.add_curve("plateau pressure", cells, plateau);
  result.add_curve("plateau temperature", cells, temperature);
  result.add_curve("way of the front", cells, front);
  return result;
}

}  // namespace mpmvv
