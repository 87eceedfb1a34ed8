#include "solver/mpm_impl.hpp"

namespace mpmvv::solver {
template class Mpm<2>;
}
