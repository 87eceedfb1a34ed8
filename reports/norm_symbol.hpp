#pragma once
#include <string>

namespace mpmvv::reports {

/// A norm as a paper writes it, in LaTeX (docs/measuring.md, "Errors").
struct NormSymbol {
  std::string symbol;      ///< "$\ell_2$"
  std::string definition;  ///< "$\ell_2 = ...$, the root mean square of ..., in m"
};

/// The symbol of a norm; a quantity that is none keeps its name.
NormSymbol norm_symbol(const std::string& norm);

}  // namespace mpmvv::reports
