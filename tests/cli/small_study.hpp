#pragma once

namespace mpmvv::cli {

/// A study file of two series that takes no time.
inline constexpr const char* small_study = R"(title = "Small"
claims = ["S-fig10"]
[fixed]
problem = "bar"
integrator = "cd"
boundary = "periodic"
ppc = 4
cfl = 0.3
[[series]]
name = "linear"
basis = "linear"
[[series]]
name = "bspline2"
basis = "bspline2"
[sweep]
cells = [8, 16, 32, 64]
[[fit]]
norm = "l2"
window = [8, 64]
[[figure]]
caption = "A small figure"
xlabel = "cells"
ylabel = "error"
[[criterion]]
claim = "S-fig10"
statement = "second order"
measure = "order"
series = ["bspline2"]
norm = "l2"
window = [8, 64]
at_least = 1.5
)";

}  // namespace mpmvv::cli
