#pragma once
#include "mms/radii.hpp"

namespace mpmvv::mms {

/// The profile w(R) = c3 R³ + c2 R² + c1 R, W (60), with the constants W (61): w(R_O) = 1, and
/// w' = 3 c3 (R - R_I) (R - R_O) vanishes at both radii.
class RadialProfile {
 public:
  /// Throws std::invalid_argument where W (61) is singular, at R_O = 3 R_I.
  RadialProfile(const Radii& radii);

  /// w/R. This and the next three are for any scalar type.
  template <class T>
  T over_R(const T& R) const {
    return (c3_ * R + c2_) * R + c1_;
  }
  /// (w/R)'
  template <class T>
  T over_R_slope(const T& R) const {
    return 2 * c3_ * R + c2_;
  }
  /// w'
  template <class T>
  T slope(const T& R) const {
    return 3 * c3_ * (R - radii_.inner) * (R - radii_.outer);
  }
  /// w''
  template <class T>
  T curvature(const T& R) const {
    return 3 * c3_ * (2 * R - radii_.inner - radii_.outer);
  }

  /// Returns max |w| over the body.
  double largest() const;

  /// Returns the maximum of |w'| and |w/R| over the body. A motion A w(R) cos ωt keeps det F positive as long as |A| is
  /// below the inverse of this maximum.
  double steepest() const;

  /// Returns the R with R + T w(R) = r, in the body and around it as far as R + T w(R) grows with R. Throws
  /// std::domain_error beyond.
  double reference_radius(double T, double r) const;

 private:
  Radii radii_;
  double c3_, c2_, c1_;
};

}  // namespace mpmvv::mms
