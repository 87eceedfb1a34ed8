#pragma once
#include "mms/radial.hpp"

namespace mpmvv::mms {

/// A spherical shell with the radial motion of the ring of W §5.2, for any ν: Shell(A, {R_I, R_O}, material).
class Shell final : public Radial<3> {
 public:
  using Radial::Radial;
};

}  // namespace mpmvv::mms
