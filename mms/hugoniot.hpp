#pragma once
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace mpmvv::mms {

/// The constants of a solid with ργ = ρ₀γ₀ whose shocks run at U = c₀ + S₁ u into material at rest, c₀² = K/ρ₀. SI
/// units.
struct ShockedSolid {
  double bulk_modulus, density, hugoniot_slope, gamma, heat_capacity, temperature;
};

/// The state behind a steady shock that a piston of speed u drives, N §3.5, from the jumps of mass, momentum and
/// energy:
///   ρ₀ U = ρ (U - u),   p = ρ₀ U u,   e = p u/(ρ₀ U) - u²/2 = u²/2.
/// The temperature follows along the Hugoniot p(η) = K η/(1 - S₁η)², e = p η/(2ρ₀) with η = 1 - ρ₀/ρ. There
/// T dS = de + p d(1/ρ) = (η dp - p dη)/(2ρ₀), and also T dS = C (dT - γ₀ T dη). Hence
///   T = e^{γ₀η} (T₀ + ∫₀^η e^{-γ₀s} K S₁ s²/(1 - S₁s)³ ds / (ρ₀ C)).
class Hugoniot {
 public:
  Hugoniot(const ShockedSolid& solid, double piston_speed) : solid_(solid), u_(piston_speed) {}

  double shock_speed() const {
    return std::sqrt(solid_.bulk_modulus / solid_.density) + solid_.hugoniot_slope * u_;  // in reference coordinates
  }
  double compression() const { return u_ / shock_speed(); }
  double density() const { return solid_.density / (1 - compression()); }
  double pressure() const { return solid_.density * shock_speed() * u_; }
  double energy() const { return 0.5 * u_ * u_; }

  double temperature() const {
    const double K = solid_.bulk_modulus, S = solid_.hugoniot_slope, gamma = solid_.gamma;
    const double eta = compression();
    const auto heat = [=](double s) { return std::exp(-gamma * s) * K * S * s * s / std::pow(1 - S * s, 3); };
    const double heating = boost::math::quadrature::gauss<double, 30>::integrate(heat, 0.0, eta);
    return std::exp(gamma * eta) * (solid_.temperature + heating / (solid_.density * solid_.heat_capacity));
  }

 private:
  ShockedSolid solid_;
  double u_;
};

}  // namespace mpmvv::mms
