#pragma once
#include <string>

namespace mpmvv::reports {

/// What a text is written for.
enum class Notation {
  plain,     ///< as it stands
  enhanced,  ///< the plotting program's own
  latex
};

/// A text of a figure or caption in a notation. In the latter two the symbols of quantities (h, x_p, sigma_xx, Δt) are
/// italic, `10^-3`, `h^2` and `4e-6` get raised powers, `8 x 8` a times sign and `1 us` its μ; units and words stay
/// upright.
std::string typeset(const std::string& text, Notation notation);

}  // namespace mpmvv::reports
