#include "studies/checks/check.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::checks {

const std::vector<Check>& checks() {
  static const std::vector<Check> all{
      {"bases", "x", &check_bases},
      {"open-bases", "x", &check_open_bases},
      {"gimp-kinks", "x", &check_gimp_kinks},
      {"jump-errors", "x", &check_jump_errors},
      {"force-quadrature", "h", &check_force_quadrature},
      {"density-extent", "x", &check_density_extent},
      {"ghost-mass", "step", &check_ghost_mass},
      {"one-particle", "step", &check_one_particle},
      {"cube-voxels", "x", &check_cube_voxels},
      {"square-particles", "x", &check_square_particles},
      {"ring-particles", "x", &check_ring_particles},
      {"ring-rows", "x", &check_ring_rows},
      {"vortex-particles", "x", &check_vortex_particles},
      {"derived-solutions", "x", &check_derived_solutions},
      {"mapping-residuals", "x", &check_mapping_residuals},
      {"mapping-properties", "property", &check_mapping_properties},
      {"mapping-figures", "x", &check_mapping_figures},
      {"full-mass-inverse", "order", &check_full_mass_inverse},
      {"high-order-spectra", "order", &check_high_order_spectra},
      {"pic-updates", "x", &check_pic_updates},
      {"shock-profiles", "x", &check_shock_profiles},
      {"shock-grids", "cells", &check_shock_grids},
      {"pulse-profiles", "x", &check_pulse_profiles},
      {"elongation", "elongation", &check_elongation},
      {"impact-work", "cells", &check_impact_work},
      {"wall-spectra", "order", &check_wall_spectra},
  };
  return all;
}

const Check& find_check(const std::string& name, const std::string& where) {
  return support::find_named(checks(), name, "check", where);
}

void CheckResult::add_curve(const std::string& name, const std::vector<double>& x, const std::vector<double>& y) {
  records::Series curve{name, {}, {}, {}};
  for (std::size_t k = 0; k < x.size(); ++k) curve.points.push_back({x[k], records::Status::ok, "", {{"y", y[k]}}});
  series.push_back(curve);
}

}  // namespace mpmvv::checks
