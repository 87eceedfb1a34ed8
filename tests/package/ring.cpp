#include <iomanip>
#include <iostream>

#include "mms/catalogue.hpp"

/// What mms/c/examples/ring.c prints.
int main() {
  using namespace mpmvv::mms;
  const auto ring = make<2>("ring", complete(entry_named("ring"), {{"amplitude", 0.05}, {"poissons_ratio", 0.3}}));
  std::cout << std::setprecision(17);
  for (const Vec<2>& X : {Vec<2>(0.6, 0.0), Vec<2>(0.3, 0.7), Vec<2>(-0.5, -0.5)}) {
    const Vec<2> u = ring->u(X, 0.004), b = ring->b(X, 0.004);
    std::cout << X[0] << ' ' << X[1] << "  " << u[0] << ' ' << u[1] << "  " << b[0] << ' ' << b[1] << '\n';
  }
}
