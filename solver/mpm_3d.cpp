#include "solver/mpm_impl.hpp"

namespace mpmvv::solver {
template class ConsistentMass<3>;
template class Mpm<3>;
}  // namespace mpmvv::solver
