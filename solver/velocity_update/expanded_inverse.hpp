#pragma once
#include <algorithm>

#include "solver/array.hpp"
#include "solver/mass_product.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

/// The inverse of the consistent mass matrix expanded to k terms, N §2.2, m̃_k⁻¹ = Σ_{l<k} (I - S⁺S)^l m⁻¹ with the
/// lumped m. Applied by its Horner form
///   w = w₁, then k - 1 times w ← w₁ + w - S⁺S w,   S⁺S w = m⁻¹ SᵀM S w,
/// which keeps round-off at 1e-16, where the sum that N prints alternates: 2e-13 lost at k = 16. S⁺S w on a node is a
/// mean over its particles with weights m_p N_ip / m_i however small its mass is: no node has to be left out.
template <int D>
class ExpandedInverse {
 public:
  using Field = Array<Padded<D>>;

  /// Of so many terms.
  ExpandedInverse(const Step<D>& s, int order)
      : order_(order), product_(s, order - 1), start_(s.grid().size()), image_(s.grid().size(), Padded<D>::Zero()) {}

  /// w = m̃_k⁻¹ m w₁, from the lumped velocities w₁ given. Walls hold nothing meanwhile; or, held nodes eliminated, they
  /// keep w₁ there, and the rest of w tends to the solution of (m̃ w)_i = m_i w₁_i on the nodes i that are free.
  void apply(Step<D>& s, bool eliminates, Field& w) {
    Padded<D>*const start = start_.data(), *const image = image_.data(), *const sum = w.data();
    const Padded<D + 1>* const lumped = s.grid().p.data();
    s.for_nodes([start, image, sum](std::size_t n) {
      start[n] = sum[n];
      image[n].setZero();
    });
    const auto add = [image, sum](std::size_t n) {
      sum[n] += image[n];
      image[n].setZero();
    };
    product_.prepare(s);
    for (int term = 1; term < order_; ++term) {
      product_.add(s, w, image_);
      s.sum_images(image_);
      s.for_nodes([=](std::size_t n) {
        image[n] = start[n] - 1 / lumped[n][D] * image[n];
        if (!eliminates) add(n);
      });
      if (!eliminates) continue;
      s.constrain(image_);
      s.for_nodes(add);
    }
  }

 private:
  int order_;
  MassProduct<D> product_;
  Field start_, image_;  ///< w₁; w₁ - S⁺S w, zero before that
};

}  // namespace mpmvv::solver
