#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "goldens/gate.hpp"

namespace mpmvv::goldens::healthy_study {

using fits::StabilityLimit;
using records::Status;
using records::StudyResult;

inline const Golden order_two{"s", "s.toml:1", OrderGolden{"a", "l2", 2, 1.85, 2.15}};
inline const Golden error_at_64{"s", "s.toml:2", ErrorGolden{"a", "l2", 64, 1e-4, 0.1}};
inline const Golden limit_of_a{"s", "s.toml:3", LimitGolden{"a", 0.8, 0.05}};
inline const Golden small_value{"s", "s.toml:4", ValueGolden{.name = "gap", .upper = 1e-14}};
inline const Golden stable_at_64{"s", "s.toml:5", StatusGolden{"a", 64, Status::ok}};

inline StabilityLimit bracket(double stable, double unstable) {
  StabilityLimit limit;
  limit.stable = stable;
  limit.unstable = unstable;
  limit.found = true;
  return limit;
}

/// A study that passes all goldens above.
inline StudyResult healthy() {
  records::Series a;
  a.name = "a";
  a.points = {{16, Status::ok, "", {{"l2", 1.6e-3}}},
              {32, Status::ok, "", {{"l2", 4e-4}}},
              {64, Status::ok, "", {{"l2", 1e-4}}}};
  a.orders.resize(1);
  a.orders[0].norm = "l2";
  a.orders[0].from = 16;
  a.orders[0].to = 64;
  a.orders[0].points = 3;
  a.orders[0].order = 2;
  a.limit = bracket(0.798, 0.804);
  StudyResult study;
  study.name = "s";
  study.series = {a};
  study.values = {{"gap", 2e-16, ""}};
  return study;
}

inline GateResult judge(const Golden& golden, const std::function<void(StudyResult&)>& change) {
  StudyResult study = healthy();
  change(study);
  return run_gate({golden}, {study}).results.at(0);
}

inline GateResult judge_order(double order, int points = 5) {
  return judge(order_two, [&](StudyResult& s) {
    s.series[0].orders[0].order = order;
    s.series[0].orders[0].points = points;
  });
}

inline GateResult judge_error(double error) {
  return judge(error_at_64, [&](StudyResult& s) { s.series[0].points[2].y["l2"] = error; });
}

inline GateResult judge_limit(const StabilityLimit& limit) {
  return judge(limit_of_a, [&](StudyResult& s) { s.series[0].limit = limit; });
}

}  // namespace mpmvv::goldens::healthy_study
