#pragma once
#include <optional>
#include <string>
#include <vector>

#include "studies/fits/window.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// What a claim asks of the results, as a number with bounds. Committed before the claim's first full run.
struct Criterion {
  enum class Kind {
    order,             ///< fitted order of `series` in `norm` over [from, to]
    order_difference,  ///< the order in `norm` less that in `over_norm`
    error,             ///< `norm` of `series` at every swept value in [from, to]
    error_ratio,       ///< `norm` of `series` over that of `over`; two unstable runs count as equal
    slope_ratio,       ///< slope of `norm` of `series` against the swept value over [from, to], divided by `over`'s
    slope_share,       ///< that slope divided by the first value of `over` in [from, to]
    spread,            ///< largest over smallest `norm` of `series` at the swept values in [from, to]
    status,            ///< fraction of `series`' points in [from, to] with status ok
    limit,             ///< stability limit of `series`
    limit_ratio,       ///< stability limit of `series` divided by that of `over`
    cost_ratio,        ///< cost at which `series` reaches each power of ten in [from, to] of `norm`, divided by that
                       ///< of `over`
    value,             ///< value `name` of a check
    shown,             ///< nothing is asked: the figure is the evidence
    awaited            ///< a part of the claim that no study can judge yet: it keeps the claim from being confirmed
  };
  std::string claim;
  std::string statement;
  Kind kind = Kind::shown;
  std::vector<std::string> series;
  std::string over;  ///< series to divide by
  std::string name;  ///< of a check's value
  std::string norm;
  std::string over_norm;  ///< norm to compare the order with
  fits::Window window;
  std::optional<double> at_least, at_most;
  std::string reason;  ///< why it fails, written after the evidence was checked
};

/// Judges one criterion by the results.
records::ClaimPart judge(const Criterion& criterion, const records::StudyResult& result);

}  // namespace mpmvv::claims
