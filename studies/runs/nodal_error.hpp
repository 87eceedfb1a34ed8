#pragma once
#include "mms/solution.hpp"
#include "solver/mpm.hpp"
#include "studies/problems/body.hpp"
#include "studies/runs/norms.hpp"

namespace mpmvv::runs {

/// Returns the norms of δ_i = |a_i - a(X_i, t)| with X_i + u(X_i, t) = x_i, W (A.1) and (A.2), over the nodes i that
/// lie in the body or, across periodic faces, in one of its images. The a_i are mapped anew from the particles at the
/// solver's time t, because a step leaves those of its start. Nodes on a face that holds them count: the component that
/// it holds is exact there, the others are the method's own. The nodes of a moving wall get its acceleration in a step
/// alone, so there must be none. Of the images of a node across periodic faces one counts. Ghost nodes do not count,
/// nor do nodes too light to be accelerated. A control point of an open-knot basis counts as the node at its abscissa.
/// Throws std::runtime_error where the particles cannot be mapped (`Mpm::fault`).
template <int D>
ErrorNorms acceleration_errors(solver::Mpm<D>& mpm, const mms::ManufacturedSolution<D>& solution,
                               const problems::Body<D>& body);

extern template ErrorNorms acceleration_errors(solver::Mpm<1>&, const mms::ManufacturedSolution<1>&,
                                               const problems::Body<1>&);
extern template ErrorNorms acceleration_errors(solver::Mpm<2>&, const mms::ManufacturedSolution<2>&,
                                               const problems::Body<2>&);
extern template ErrorNorms acceleration_errors(solver::Mpm<3>&, const mms::ManufacturedSolution<3>&,
                                               const problems::Body<3>&);

}  // namespace mpmvv::runs
