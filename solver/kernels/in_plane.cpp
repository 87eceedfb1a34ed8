#include "solver/kernels/compiled.hpp"

template struct mpmvv::solver::Compiled<2>;
