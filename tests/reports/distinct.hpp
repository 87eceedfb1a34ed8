#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "studies/records/result.hpp"

/// Results in which no two numbers are equal, nor look equal when they are rounded for a table.
namespace mpmvv::reports::distinct {

/// Every number 2 % above the last one.
class Numbers {
 public:
  double next() { return last_ *= 1.021; }
  int count() { return ++count_; }

 private:
  double last_ = 1.1;
  int count_ = 1000;
};

inline fits::ObservedOrder order(const std::string& norm, const std::vector<records::Point>& points, bool alternate,
                                 Numbers& n) {
  fits::ObservedOrder o{norm,     n.next(),  n.next(), n.count(), n.next(), n.next(), n.next(),
                        n.next(), alternate, n.next(), n.next(),  {},       {}};
  for (std::size_t i = 1; i < points.size(); ++i) o.segments.push_back({points[i - 1].x, points[i].x, n.next()});
  o.floor = fits::FloorFit{n.next(), n.next(), n.next(), n.next(), !alternate, "why of " + norm};
  o.replicates = fits::ReplicateFit{n.count(), n.next(), n.next(), n.next()};
  return o;
}

inline fits::Extrapolation extrapolation(const std::string& quantity, Numbers& n) {
  return {quantity, n.next(), n.next(), n.count(), "model of " + quantity, n.next(), n.next(),
          n.next(), n.next(), n.next(), n.next(),  "remark on " + quantity};
}

inline fits::StabilityLimit limit(bool found, bool monotone, Numbers& n) {
  fits::StabilityLimit l{"cfl", n.next(), n.next(), monotone, found, {}};
  l.probes.push_back({l.stable, true, "", n.count()});
  for (const bool stable : {false, true}) l.probes.push_back({n.next(), stable, stable ? "" : "det F <= 0", n.count()});
  return l;
}

/// Everything that a table or a file of values can hold.
inline records::StudyResult everything() {
  Numbers n;
  records::StudyResult study;
  study.name = "all-numbers";
  study.title = "All numbers";
  study.kind = records::StudyKind::convergence;
  study.sweep = "cells";
  study.claims = {"X-one", "X-two"};
  for (const char* name : {"first", "second", "third, last"}) {
    const bool alternate = study.series.size() % 2 == 1;
    records::Series s{name, {}, {}, std::nullopt};
    for (int i = 0; i < 3; ++i) {
      records::Point p{n.next(), i == 2 && alternate ? records::Status::unstable : records::Status::ok, "", {}};
      for (const char* quantity : {"l1", "l2", "linf"}) p.y[quantity] = n.next();
      if (p.status == records::Status::unstable) p.reason = "energy";
      for (const char* quantity : {"l1", "l2"}) p.replicates[quantity] = {n.next(), n.next(), n.next()};
      s.points.push_back(p);
    }
    s.orders = {order("l1", s.points, alternate, n), order("linf", s.points, !alternate, n)};
    s.extrapolations = {extrapolation("energy", n), extrapolation("work", n)};
    s.limit = limit(!alternate, alternate, n);
    study.series.push_back(s);
  }
  study.values = {{"gap", n.next(), "of the gap"}, {"slope", n.next(), "of the slope"}};
  study.parts = {{"X-one", "asked one", records::PartVerdict::holds, "found one", "why one"},
                 {"X-two", "asked two", records::PartVerdict::fails, "found two", "why two"}};
  return study;
}

inline records::Figure figure(const std::string& name, records::Figure::Kind kind) {
  records::Figure f;
  f.name = name, f.caption = "Caption of " + name, f.kind = kind;
  f.xlabel = "abscissa of " + name, f.ylabel = "ordinate of " + name;
  return f;
}

/// Power laws with windows of their own: the first is fitted in two norms, the last not at all, and one run blows up.
inline records::StudyResult laws() {
  records::StudyResult study;
  study.name = "laws";
  study.sweep = "cells";
  const std::vector<double> cells{7, 12, 21, 36, 62};
  const std::vector<double> p{1.07, 2.13, 1.61}, constant{0.31, 4.7, 1.1};
  for (std::size_t k = 0; k < 3; ++k) {
    records::Series s{"law " + std::to_string(k), {}, {}, std::nullopt};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double y = constant[k] * std::pow(cells[i], -p[k]) * (1 + 0.01 * static_cast<double>((7 * i + 3 * k) % 5));
      s.points.push_back({cells[i], records::Status::ok, "", {{"l2", y}, {"linf", 3 * y}}});
    }
    fits::ObservedOrder o;
    o.norm = "l2", o.from = k == 0 ? 12 : 7, o.to = k == 0 ? 62 : 21;
    o.order = p[k], o.half_width = k == 0 ? 0.031 : 0.051, o.constant = constant[k];
    if (k < 2) s.orders.push_back(o);
    study.series.push_back(s);
  }
  auto other = study.series[0].orders[0];
  other.norm = "linf", other.from = 7, other.to = 21, other.constant = 0.93;
  study.series[0].orders.push_back(other);
  study.series[1].orders[0].floor = fits::FloorFit{4.4, 2.2, 0.0017, 0.002, true, ""};
  study.series[2].points[1] = {cells[1], records::Status::unstable, "energy", {}};
  study.figures = {figure("laws", records::Figure::Kind::curves)};
  study.figures[0].slopes = {2};
  return study;
}

/// Errors over the key whose limits are known: one series stable below its limit, one above.
inline records::StudyResult brackets() {
  records::StudyResult study;
  study.name = "brackets";
  study.sweep = "cfl";
  for (const char* name : {"below", "above"}) {
    records::Series s{name, {}, {}, fits::StabilityLimit{"cfl", 0.61, 0.67, true, true, {}}};
    const double base = study.series.empty() ? 2.3 : 3.1;
    for (const double x : {0.12, 0.31, 0.53, 0.94})
      s.points.push_back({x, records::Status::ok, "", {{"l2", base + x}}});
    study.series.push_back(s);
  }
  study.series[1].limit = fits::StabilityLimit{"cfl", 0.43, 0.37, true, true, {}};
  study.figures = {figure("brackets", records::Figure::Kind::curves)};
  study.figures[0].log_x = study.figures[0].log_y = false;
  return study;
}

/// Two curves of too many points for marks, in a quantity that is not the first one.
inline records::StudyResult curves() {
  records::StudyResult study;
  study.name = "curves";
  study.kind = records::StudyKind::check;
  study.sweep = "x";
  for (const char* name : {"rising", "falling"}) {
    records::Series s{name, {}, {}, std::nullopt};
    const double sign = study.series.empty() ? 1 : -1;
    for (int i = 0; i < 50; ++i) {
      const double x = 0.1 * i - 2;
      s.points.push_back({x, records::Status::ok, "", {{"l2", x + 7}, {"slope", sign * (x + 0.1 * x * x) + 0.3}}});
    }
    study.series.push_back(s);
  }
  study.figures = {figure("curves", records::Figure::Kind::curves)};
  study.figures[0].log_x = study.figures[0].log_y = false;
  study.figures[0].quantity = "slope";
  return study;
}

/// Three limits, the second not found, the third not monotone.
inline records::StudyResult limits() {
  records::StudyResult study;
  study.name = "limits";
  study.kind = records::StudyKind::limit;
  study.sweep = "cfl";
  double v = 0.2;
  for (const char* name : {"upper", "middle", "lower"}) {
    records::Series s{name, {}, {}, fits::StabilityLimit{}};
    s.limit->key = "cfl";
    for (const bool stable : {true, true, false, false})
      s.limit->probes.push_back({v *= 1.13, stable, "", static_cast<int>(1e3 * v)});
    s.limit->stable = s.limit->probes[1].value, s.limit->unstable = s.limit->probes[2].value;
    s.limit->found = study.series.size() != 1;
    s.limit->monotone = study.series.size() != 2;
    study.series.push_back(s);
  }
  study.figures = {figure("limits", records::Figure::Kind::curves)};
  return study;
}

/// Costs and errors of two series, which cross; the cost on a logarithmic axis, the error not.
inline records::StudyResult costs() {
  records::StudyResult study;
  study.name = "costs";
  study.sweep = "cells";
  study.series = {{"slow", {}, {}, {}}, {"fast", {}, {}, {}}};
  const auto add = [&](std::size_t k, double x, double cost, double error) {
    study.series[k].points.push_back({x, records::Status::ok, "", {{"l2", error}, {"step_seconds", cost}}});
  };
  add(0, 8, 1.3, 0.37), add(0, 16, 14, 0.23), add(0, 32, 170, 0.087);
  add(1, 9, 2.1, 0.53), add(1, 18, 11, 0.29), add(1, 36, 97, 0.071);
  study.figures = {figure("costs", records::Figure::Kind::work_precision)};
  study.figures[0].log_y = false;
  return study;
}

/// Panels of particles, two of which have voxels of other widths than heights.
inline records::StudyResult particles() {
  records::StudyResult study;
  study.name = "particles";
  study.kind = records::StudyKind::check;
  const auto particle = [](double x, double y, double width, double height) {
    return records::Point{x, records::Status::ok, "", {{"y", y}, {"width_x", width}, {"width_y", height}}};
  };
  study.series = {{"at first", {particle(0.31, 1.7, 0.25, 0.6), particle(1.13, 0.45, 0.4, 0.7)}, {}, {}},
                  {"at last", {particle(0.62, 1.2, 0.3, 0.5), particle(1.46, 2.1, 0.35, 0.8)}, {}, {}}};
  study.figures = {figure("particles", records::Figure::Kind::particles)};
  return study;
}

}  // namespace mpmvv::reports::distinct
