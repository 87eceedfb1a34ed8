#pragma once
#include <fmt/ranges.h>

#include <string>

#include "tests/numbers.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::study_text {

using fits::FloorFit;
using fits::ObservedOrder;
using records::Series;
using records::StudyResult;

/// Everything as text, to be compared. Structured bindings name every member: a new one does not compile until it is
/// compared too.
struct Text {
  static std::string of(const fits::SegmentOrder& s) {
    const auto& [from, to, order] = s;
    return fmt::format("{}..{}: {}", from, to, order);
  }

  static std::string of(const FloorFit& f) {
    const auto& [constant, order, floor, residual, accepted, reason] = f;
    return fmt::format("floor {} {} {} {} {} '{}'", constant, order, floor, residual, accepted, reason);
  }

  static std::string of(const fits::ReplicateFit& r) {
    const auto& [observations, scatter, half_width, lack_of_fit] = r;
    return fmt::format("replicates {} {} {} {}", observations, scatter, half_width, lack_of_fit);
  }

  static std::string of(const fits::Extrapolation& e) {
    const auto& [norm, from, to, points, model, order, limit, deviation, finest, uncertainty, index, remark] = e;
    return fmt::format("extrapolation {} {} {} {} '{}' {} {} {} {} {} {} '{}'", norm, from, to, points, model, order,
                       limit, deviation, finest, uncertainty, index, remark);
  }

  template <class T>
  static std::string of(const std::vector<T>& items) {
    std::string text;
    for (const T& item : items) text += of(item) + "\n";
    return text;
  }

  template <class T>
  static std::string of(const std::optional<T>& item) {
    return item ? of(*item) : "none";
  }

  static std::string of(double number) { return fmt::format("{}", number); }
  static std::string of(const std::string& text) { return "'" + text + "'"; }

  static std::string of(const ObservedOrder& o) {
    const auto& [norm, from, to, points, order, half_width, constant, r2, asymptotic, a_from, a_to, segments, floor,
                 replicates] = o;
    return fmt::format("order {} {} {} {} {} {} {} {} {} {} {}\n{}{}{}", norm, from, to, points, order, half_width,
                       constant, r2, asymptotic, a_from, a_to, of(segments), of(floor), of(replicates));
  }

  static std::string of(const records::Point& p) {
    const auto& [x, status, reason, y, replicates, particle_errors, rounds] = p;
    return fmt::format("point {} {} '{}' {} {} {} {}\n{}", x, to_string(status), reason, y, replicates, rounds.costs,
                       rounds.session, of(particle_errors));
  }

  static std::string of(const records::ParticleError& e) {
    const auto& [x, y, error] = e;
    return fmt::format("particle {} {} {}", x, y, error);
  }

  static std::string of(const records::OtherCode& c) {
    const auto& [name, version, variant, force_form, of_files] = c;
    return fmt::format("code {} {} '{}' {} '{}'", name, version, variant, force_form, of_files);
  }

  static std::string of(const fits::Probe& p) {
    const auto& [value, stable, reason, steps] = p;
    return fmt::format("probe {} {} '{}' {}", value, stable, reason, steps);
  }

  static std::string of(const fits::StabilityLimit& l) {
    const auto& [key, stable, unstable, monotone, found, probes] = l;
    return fmt::format("limit {} {} {} {} {}\n{}", key, stable, unstable, monotone, found, of(probes));
  }

  static std::string of(const Series& s) {
    const auto& [name, points, orders, limit, extrapolations, code] = s;
    return fmt::format("series {}\n{}{}{}{}{}", name, of(points), of(orders), of(limit), of(extrapolations), of(code));
  }

  static std::string of(const records::Value& v) {
    const auto& [name, value, meaning] = v;
    return fmt::format("value {} {} {}", name, value, meaning);
  }

  static std::string of(const records::Figure& f) {
    const auto& [name, caption, xlabel, ylabel, log_x, log_y, quantity, series, marks, slopes, x0, x1, y0, y1, kind] =
        f;
    return fmt::format("figure {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", name, caption, xlabel, ylabel, log_x,
                       log_y, quantity, of(series), of(marks), of(slopes), of(x0), of(x1), of(y0), of(y1),
                       to_string(kind));
  }

  static std::string of(const records::ClaimPart& p) {
    const auto& [claim, statement, verdict, evidence, reason, measure, at_least, at_most, found, withheld] = p;
    return fmt::format("part {} {} {} {} '{}' {} {} {}\n{}{}", claim, statement, to_string(verdict), evidence, reason,
                       measure, of(at_least), of(at_most), of(found), withheld);
  }

  static std::string of(const records::Found& f) {
    const auto& [what, value, lower, upper, remark] = f;
    return fmt::format("found {} {} {} {} '{}'", what, value, lower, upper, remark);
  }

  static std::string of(const records::ClaimText& c) {
    const auto& [id, statement, source, where, study] = c;
    return fmt::format("claim {} {} '{}' '{}' {}", id, statement, source, where, study);
  }

  static std::string of(const StudyResult& s) {
    const auto& [name, title, kind, sweep, text, claims, series, values, figures, parts, statements] = s;
    return fmt::format("{}|{}|{}|{}|{}\n{}{}{}{}{}{}", name, title, to_string(kind), sweep, text, of(claims),
                       of(series), of(values), of(figures), of(parts), of(statements));
  }
};

}  // namespace mpmvv::store::study_text
