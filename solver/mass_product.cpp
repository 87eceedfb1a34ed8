#include "solver/mass_product.hpp"

#include <variant>

#include "solver/kernels/add_mass_product.hpp"
#include "solver/stencils/any_block.hpp"
#include "solver/stencils/node_boxes.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Whether this many products take less time with an assembled matrix than by sweeps, each of which evaluates stencils
/// anew. Time per particle in ns, in the plane with four particles a cell:
///                     a sweep   assembling   then each product
///   W = 3                   9           28                   3
///   W = 4                  13           50                   6
///   W = 3, domains         29           53                   4
template <int D>
bool is_worth_a_matrix(const AnyBasis& basis, int products) {
  return std::visit(
      [products]<class B>(const B&) {
        constexpr int W = box_width<BlockOf<D, B>>;
        return B::width == ParticleWidth::domain ? products >= W : 2 * products > power(W, D);
      },
      basis);
}

}  // namespace

template <int D>
MassProduct<D>::MassProduct(const Step<D>& s, int products) {
  if constexpr (may_assemble)
    if (is_worth_a_matrix<D>(s.scene().basis, products)) matrix_.emplace(s);
}

template <int D>
MassMatrix<D>* MassProduct<D>::matrix() {
  return matrix_ ? &*matrix_ : nullptr;
}

template <int D>
void MassProduct<D>::prepare(Step<D>& s) {
  if constexpr (may_assemble) {
    if (!matrix_ || assembled_after_ == s.moves()) return;
    assembled_after_ = s.moves();
    is_assembled_ = matrix_->assemble(s);
  }
}

template <int D>
void MassProduct<D>::add(Step<D>& s, const Field& u, Field& field) {
  if constexpr (may_assemble)
    if (is_assembled_) return matrix_->add(s, u, field);
  s.sweep({AddMassProduct<D>{s.particles(), u, field}});
}

template class MassProduct<1>;
template class MassProduct<2>;
template class MassProduct<3>;

}  // namespace mpmvv::solver
