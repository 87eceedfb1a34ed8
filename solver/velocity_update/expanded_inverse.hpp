#pragma once
#include "solver/array.hpp"
#include "solver/mass_product.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

/// The inverse of the consistent mass matrix expanded to k terms, N §2.2, m̃_k⁻¹ = Σ_{l<k} (I - S⁺S)^l m⁻¹ with the
/// lumped m. It is applied in Horner's form,
///   w = w₁, then k - 1 times w ← w₁ + w - S⁺S w,   S⁺S w = m⁻¹ SᵀM S w,
/// which keeps round-off at 1e-16. The sum that N prints alternates in sign and loses digits: 2e-13 at k = 16. On a
/// node S⁺S w is a mean over its particles with weights m_p N_ip / m_i, however small its mass is: no node has to be
/// left out.
template <int D>
class ExpandedInverse {
 public:
  using Field = Array<Padded<D>>;

  /// `order` is the number k of terms.
  ExpandedInverse(const Step<D>& s, int order)
      : order_(order), product_(s, order - 1), start_(s.grid().size()), image_(s.grid().size(), Padded<D>::Zero()) {}

  /// Sets w = m̃_k⁻¹ m w₁, where w₁ are the lumped velocities that w holds before. Faces and walls hold nothing
  /// meanwhile, unless `eliminates` is true: held nodes then keep w₁, and the rest of w tends to the solution of
  /// (m̃ w)_i = m_i w₁_i on the nodes i that are free.
  void apply(Step<D>& s, bool eliminates, Field& w) {
    Padded<D>*const start = start_.data(), *const image = image_.data(), *const sum = w.data();
    const Padded<D + 1>* const mass_and_momentum = s.grid().p.data();
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
        image[n] = start[n] - 1 / mass_and_momentum[n][D] * image[n];
        if (!eliminates) add(n);
      });
      if (!eliminates) continue;
      s.constrain(image_);
      s.for_nodes(add);
    }
  }

  MassProduct<D>& product() { return product_; }

 private:
  int order_;
  MassProduct<D> product_;
  Field start_, image_;  ///< w₁, and w₁ - S⁺S w; the latter is zero before each product
};

}  // namespace mpmvv::solver
