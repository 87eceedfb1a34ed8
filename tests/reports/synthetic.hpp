#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "studies/claims/claim.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::reports::synthetic {

inline fits::SegmentOrder segment(const records::Point& a, const records::Point& b, const std::string& norm) {
  return {a.x, b.x, std::log(a.y.at(norm) / b.y.at(norm)) / std::log(b.x / a.x)};
}

/// e = C h^p + floor at cells 8 ... 512; `unstable` cells have no error.
inline records::Series power_law(const std::string& name, double constant, double order, double floor,
                                 const std::vector<double>& unstable = {}) {
  records::Series s{name, {}, {}, std::nullopt};
  for (double n = 8; n <= 512; n *= 2) {
    records::Point p{n, records::Status::ok, "", {}};
    const double e = constant * std::pow(n, -order) + floor;
    p.y = {{"l1", 0.8 * e}, {"l2", e}, {"linf", 2.2 * e}, {"wall_seconds", 1e-4 * n * n}};
    for (const double u : unstable)
      if (u == n) p.status = records::Status::unstable, p.reason = "det F <= 0 in step 12", p.y.clear();
    s.points.push_back(p);
  }
  fits::ObservedOrder o;
  o.norm = "l2";
  o.from = 16;
  o.to = 128;
  o.points = 4;
  o.order = order;
  o.half_width = 0.034;
  o.constant = constant;
  o.r_squared = 0.9998;
  o.asymptotic = true;
  o.asymptotic_from = 8;
  o.asymptotic_to = 128;
  for (std::size_t i = 1; i < s.points.size(); ++i)
    if (!s.points[i].y.empty() && !s.points[i - 1].y.empty())
      o.segments.push_back(segment(s.points[i - 1], s.points[i], "l2"));
  if (floor > 0) o.floor = fits::FloorFit{constant, order, floor, 0.003, true, "residual 0.3 % against 21 %"};
  s.orders.push_back(o);
  return s;
}

inline records::StudyResult convergence() {
  records::StudyResult study;
  study.name = "bar-bases";
  study.title = "Bar: order of the bases <S & W>";
  study.kind = records::StudyKind::convergence;
  study.sweep = "cells";
  study.text = "problem = \"bar\"\ncells = [8, 512] # a < b\n";
  study.claims = {"S-fig10", "S-fig11"};
  study.series = {power_law("linear_periodic, 4 PPC", 0.02, 1.0, 4e-4), power_law("bspline2, 4 PPC", 0.3, 2.01, 0),
                  power_law("bspline2, 6 PPC", 0.15, 2.02, 1.1e-6),
                  power_law("bspline3-open {a^2}, 4 PPC", 0.6, 1.98, 0, {8, 512}),
                  power_law("gimp, 4 PPC", 0.5, 1.1, 0, {8})};
  study.figures = {{"s-fig10",
                    "RMS displacement error of the bar <b>at</b> t = 1/C.",
                    "cells N",
                    "RMS error δ / m",
                    true,
                    true,
                    "l2",
                    {},
                    {},
                    {1, 2},
                    {},
                    {},
                    {},
                    {}}};
  study.parts = {{"S-fig10", "order of bspline2 in [1.85, 2.15]", records::PartVerdict::holds, "2.01 ± 0.03", ""},
                 {"S-fig11", "ghost-node order is 1 & no more", records::PartVerdict::fails, "1.98",
                  "the paper's <mirror> differs"}};
  return study;
}

/// One that the first part of the study above bears out.
inline claims::Claim claim(const std::string& statement) {
  const records::StudyResult study = convergence();
  return {"S-fig10",
          statement,
          "A paper",
          "Fig. 10",
          claims::Claim::Verdict::confirmed,
          "",
          {{study.name, study.parts[0]}},
          {study.name}};
}

inline records::StudyResult limits() {
  records::StudyResult study;
  study.name = "bar-cfl";
  study.title = "Bar: stability limit in CFL";
  study.kind = records::StudyKind::limit;
  study.sweep = "cfl";
  study.claims = {"S-fig9"};
  for (int k = 1; k <= 8; ++k) {
    records::Series s{"l = " + std::to_string(k) + "h/8, 4 PPC", {}, {}, fits::StabilityLimit{}};
    s.limit->key = "cfl";
    const double limit = 0.7 + 0.06 * k;
    for (double v = 0.3; v < 1.7; v *= 1.1)
      s.limit->probes.push_back({v, v < limit, v < limit ? "" : "energy", static_cast<int>(100 / v)});
    s.limit->stable = limit - 0.004;
    s.limit->unstable = limit + 0.004;
    s.limit->found = k != 8;
    s.limit->monotone = k != 3;
    study.series.push_back(s);
  }
  return study;
}

inline records::StudyResult check() {
  records::StudyResult study;
  study.name = "weights";
  study.title = "Weights and their gradients";
  study.kind = records::StudyKind::check;
  study.sweep = "ξ";
  study.claims = {"S-fig4"};
  for (const char* name : {"N", "dN/dx"}) {
    records::Series s{name, {}, {}, std::nullopt};
    for (int i = 0; i <= 200; ++i) {
      const double x = -2 + 4.0 * i / 200;
      const double n = std::abs(x) < 1 ? 1 - std::abs(x) : 0;
      const double dn = std::abs(x) < 1 ? (x < 0 ? 1 : -1) : 0;
      s.points.push_back({x, records::Status::ok, "", {{"y", name[0] == 'N' ? n : dn}}});
    }
    study.series.push_back(s);
  }
  study.series[1].points[100].y["y"] = support::not_measured;
  study.values = {{"partition_of_unity", 2.2e-16, "largest |ΣN - 1|"}, {"nothing", support::not_measured, "a NaN"}};
  study.figures = {
      {"s-fig4", "Weight and gradient.", "ξ", "N, dN/dx · h", false, false, "y", {}, {}, {}, {}, {}, {}, {}}};
  return study;
}

}  // namespace mpmvv::reports::synthetic
