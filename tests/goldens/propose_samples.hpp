#pragma once
#include <string>
#include <vector>

#include "goldens/golden.hpp"
#include "goldens/propose.hpp"

/// Studies of which goldens are proposed.
namespace mpmvv::goldens::propose_samples {

using records::Series;
using records::Status;
using records::StudyResult;
using support::not_measured;

inline const store::Provenance clean{"d1", "abc", false, "GNU 12.2.0", "-O3", "Release", "cpu", "2026-11-21T00:00:00Z"};

inline fits::ObservedOrder fitted(const std::string& norm, int points, double order) {
  fits::ObservedOrder fit;
  fit.norm = norm;
  fit.from = 16;
  fit.to = 64;
  fit.points = points;
  fit.order = order;
  return fit;
}

inline fits::StabilityLimit cfl_limit(double stable, double unstable) {
  fits::StabilityLimit limit;
  limit.key = "cfl";
  limit.stable = stable;
  limit.unstable = unstable;
  limit.found = true;
  return limit;
}

inline StudyResult study_with(const Series& series, const std::string& sweep = "cells") {
  StudyResult study;
  study.name = "s-fig10";
  study.sweep = sweep;
  study.series = {series};
  return study;
}

inline Series convergent() {
  Series series;
  series.name = "quadratic \"open\", \\ tab\t";
  series.points = {{16, Status::ok, "", {{"l2", 1.6e-3}}},
                   {32, Status::ok, "", {{"l2", 4.0001e-4}}},
                   {64, Status::ok, "", {{"l2", 1.00049e-4}}},
                   {128, Status::unstable, "energy", {{"l2", 7}}},
                   {256, Status::ok, "", {{"l2", not_measured}}}};
  series.orders = {fitted("l2", 3, 1.99951)};
  return series;
}

/// The text of a proposal, which the reader of goldens has read.
inline std::string draft(const StudyResult& study, const store::Provenance& provenance = clean) {
  std::string text = propose_goldens(study, provenance);
  parse_goldens(text, "new.toml");
  return text;
}

inline std::vector<Golden> proposed(const StudyResult& study) {
  return parse_goldens(draft(study), "new.toml");
}

/// The same with a reviewer's mark.
inline std::vector<Golden> reviewed(const StudyResult& study) {
  return parse_goldens("reviewed = \"now\"\n" + draft(study), "new.toml");
}

}  // namespace mpmvv::goldens::propose_samples
