#include "reports/norm_symbol.hpp"

#include <fmt/format.h>

#include <map>

#include "reports/text.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::reports {

namespace {

/// What a norm makes one number of: δ over n places.
struct Means {
  const char *symbol, *formula, *words;
};

const std::map<std::string, Means>& means() {
  static const std::map<std::string, Means> all{
      {"l1", {R"(\ell_1)", R"(\frac1N\sum_{0}\delta_{0})", "mean"}},
      {"l2", {R"(\ell_2)", R"(\bigl(\frac1N\sum_{0}\delta_{0}^2\bigr)^{{1/2}})", "root mean square"}},
      {"linf", {R"(\ell_\infty)", R"(\max_{0}\delta_{0})", "maximum"}}};
  return all;
}

NormSymbol displacement_norm(const Means& norm) {
  const std::string formula = fmt::format(fmt::runtime(norm.formula), "p");
  return {fmt::format("${}$", norm.symbol),
          fmt::format(R"(${} = {}$, the {} over the $N$ particles of the displacement error )"
                      R"($\delta_p = |x_p - X_p - u(X_p, t)|$ at the end, in m)",
                      norm.symbol, formula, norm.words)};
}

NormSymbol norm_of_all_steps(const Means& norm) {
  const std::string formula = fmt::format(fmt::runtime(norm.formula), "p");
  return {fmt::format(R"($\max_t {}$)", norm.symbol),
          fmt::format(R"($\max_t {0}$, the largest of all steps of ${0} = {1}$, the {2} over the $N$ particles of )"
                      R"(the displacement error $\delta_p = |x_p - X_p - u(X_p, t)|$, in m)",
                      norm.symbol, formula, norm.words)};
}

NormSymbol nodal_norm(const Means& norm) {
  const std::string formula = fmt::format(fmt::runtime(norm.formula), "i");
  return {fmt::format("${}^a$", norm.symbol),
          fmt::format(R"(${}^a = {}$, the {} over the $N$ nodes of the body of the acceleration error )"
                      R"($\delta_i = |a_i - a(X_i, t)|$ at the end, in m/s$^2$)",
                      norm.symbol, formula, norm.words)};
}

const std::map<std::string, NormSymbol>& other_norms() {
  static const std::map<std::string, NormSymbol> all{
      {"velocity_error",
       {"$e_v$",
        R"($e_v = \frac{100}{v_0} \bigl(\frac1N\sum_p |v_p - v(X_p, t)|^2\bigr)^{1/2}$, the root mean square over the )"
        R"($N$ particles of the velocity error, as the mean of all steps, in per cent of the problem's speed $v_0$)"}},
      {"stress_error",
       {R"($e_\sigma$)",
        R"($e_\sigma = \bigl(\frac1N\sum_p \|\sigma_p - \sigma(X_p, t)\|_F^2\bigr)^{1/2}$, the root mean square over )"
        R"(the $N$ particles of the error of the Cauchy stress in the Frobenius norm at the end, in Pa)"}},
      {"energy_loss",
       {R"($\Delta E$)", R"($\Delta E = 1 - E(T)/E(0)$, the share of the kinetic and strain energy that is lost)"}},
      {"mass_change", {R"($\Delta m$)", R"($\Delta m = \sum_p m_p/m - 1$, the change of mass)"}},
      {"momentum_change",
       {R"($\Delta P$)",
        R"($\Delta P$, the change of $\sum_p m_p v_p$ over the larger of $\sum_p m_p |v_p|$ at the start and at the end)"}},
      {"angular_momentum_change",
       {R"($\Delta L$)",
        R"($\Delta L$, the change of $\sum_p m_p (x_p v_p^T - v_p x_p^T)$ over the larger of $\sum_p m_p |x_p| |v_p|$ )"
        R"(at the start and at the end)"}}};
  return all;
}

}  // namespace

NormSymbol norm_symbol(const std::string& norm) {
  if (const auto known = other_norms().find(norm); known != other_norms().end()) return known->second;
  for (const auto& [name, mean] : means()) {
    if (norm == name) return displacement_norm(mean);
    if (norm == name + "_all_steps") return norm_of_all_steps(mean);
    if (norm == "nodal_" + name) return nodal_norm(mean);
  }
  return {latex_text(norm), latex_text(records::with_unit(norm))};
}

}  // namespace mpmvv::reports
