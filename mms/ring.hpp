#pragma once
#include "mms/radial.hpp"

namespace mpmvv::mms {

/// The ring of W §5.2, in plane strain, for any ν: Ring(A, {R_I, R_O}, material).
class Ring final : public Radial<2> {
 public:
  using Radial::Radial;
};

}  // namespace mpmvv::mms
