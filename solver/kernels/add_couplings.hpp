#pragma once
#include "solver/mass_matrix.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// A block kernel: M_ij += Σ_p m_p N_ip N_jp, where there is a matrix. It leaves particles as they are.
template <int D>
struct AddCouplings {
  const Particles<D>& particles;
  MassMatrix<D>* matrix;  ///< may be null

  template <class Shape>
  void operator()(const Shape& block, const Grid<D>& grid) const {
    if constexpr (D < 3)
      if (matrix) matrix->add_block(block, grid, particles.m);
  }
};

}  // namespace mpmvv::solver
