#pragma once

namespace mpmvv::mms {

/// Isotropic elastic constants and density. Units: Pa, Pa, kg/m³.
struct Elasticity {
  double youngs_modulus;
  double poissons_ratio;
  double density;

  double lambda() const { return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)); }
  double mu() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
};

}  // namespace mpmvv::mms
