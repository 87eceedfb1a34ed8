#include "reports/axis_label.hpp"

#include <map>

#include "studies/records/record.hpp"

namespace mpmvv::reports {

std::string error_axis_label(const std::string& quantity) {
  static const std::map<std::string, std::string> labels{
      {"", "error"},
      {"l1", "mean displacement error (m)"},
      {"l2", "RMS displacement error (m)"},
      {"linf", "largest displacement error (m)"},
      {"l1_all_steps", "mean displacement error, worst step (m)"},
      {"l2_all_steps", "RMS displacement error, worst step (m)"},
      {"linf_all_steps", "largest displacement error over all steps (m)"},
      {"nodal_l1", "mean error of nodal acceleration (m/s²)"},
      {"nodal_l2", "RMS error of nodal acceleration (m/s²)"},
      {"nodal_linf", "largest error of nodal acceleration (m/s²)"},
      {"velocity_error", "velocity error (% of the problem's speed)"},
      {"stress_error", "RMS stress error (Pa)"},
      {"energy_loss", "energy lost / initial energy"},
      {"mass_change", "relative change of mass"},
      {"momentum_change", "relative change of momentum"},
      {"angular_momentum_change", "relative change of angular momentum"}};
  const auto known = labels.find(quantity);
  return known == labels.end() ? records::with_unit(quantity) : known->second;
}

std::string limit_axis_label(const std::string& key) {
  return key == "cfl" ? "CFL number" : key == "smoothing_length" ? "smoothing length / h" : key;
}

}  // namespace mpmvv::reports
