#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::checks {

/// What a check measured: named numbers, and curves (series of points with the quantity `y`).
struct CheckResult {
  std::vector<records::Value> values;
  std::vector<records::Series> series;

  void add(const std::string& name, double value, const std::string& meaning) {
    values.push_back({name, value, meaning});
  }
  void add_curve(const std::string& name, const std::vector<double>& x, const std::vector<double>& y);
};

/// A measurement for claims about a property rather than about convergence. Each is a function in a file of
/// studies/checks/, is declared below, and has a line in checks.cpp.
struct Check {
  std::string name;
  std::string abscissa;  ///< the name of the curves' x; "h" where x is a step size
  CheckResult (*run)();
};

const std::vector<Check>& checks();

/// Returns the check with this name. Throws a UsageError with the known names where there is none.
const Check& find_check(const std::string& name, const std::string& where);

CheckResult check_bases();
CheckResult check_open_bases();
CheckResult check_gimp_kinks();
CheckResult check_jump_errors();
CheckResult check_force_quadrature();
CheckResult check_density_extent();
CheckResult check_ghost_mass();
CheckResult check_one_particle();
CheckResult check_cube_voxels();
CheckResult check_square_particles();
CheckResult check_ring_particles();
CheckResult check_ring_rows();
CheckResult check_vortex_particles();
CheckResult check_derived_solutions();
CheckResult check_mapping_residuals();
CheckResult check_mapping_properties();
CheckResult check_mapping_figures();
CheckResult check_full_mass_inverse();
CheckResult check_high_order_spectra();
CheckResult check_pic_updates();
CheckResult check_shock_profiles();
CheckResult check_shock_grids();
CheckResult check_pulse_profiles();
CheckResult check_elongation();
CheckResult check_impact_work();
CheckResult check_wall_spectra();

}  // namespace mpmvv::checks
