#include "solver/mpm_impl.hpp"

namespace mpmvv::solver {
template class ConsistentMass<2>;
template class Mpm<2>;
}  // namespace mpmvv::solver
