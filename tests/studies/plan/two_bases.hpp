#pragma once
#include <fmt/format.h>

#include <string>

namespace mpmvv::plan {

/// The text of a study of the bar by two bases, with a line `more` among the settings that both share.
inline std::string two_bases(const std::string& cells, const std::string& more = "") {
  return fmt::format(R"(title = "Bar"
claims = []
[fixed]
problem = "bar"
boundary = "periodic"
integrator = "cd"
ppc = 2
cfl = 0.4
steps = 20
{}
[[series]]
name = "quadratic"
basis = "bspline2"
[[series]]
name = "cubic"
basis = "bspline3"
[sweep]
cells = [{}]
)",
                     more, cells);
}

}  // namespace mpmvv::plan
