#include <fmt/format.h>

#include <map>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/cases.hpp"
#include "studies/checks/mapping/counterexamples.hpp"
#include "studies/checks/mapping/field_properties.hpp"
#include "studies/checks/mapping/motion_properties.hpp"
#include "studies/checks/mapping/shape_properties.hpp"
#include "studies/checks/mapping/sum_properties.hpp"

namespace mpmvv::checks::mapping {

namespace {

enum class Extreme { largest, least };

/// One measure of a property, and whether its largest or its least value over all bodies matters to the claim.
struct PropertyMeasure {
  int property;  ///< its number in the table, 0 for B-phi; `aside` if it is not in the table
  const char* name;
  Extreme extreme;
  const char* meaning;
  double (*in_1d)(const Subject<1>&);
  double (*in_2d)(const Subject<2>&);

  double operator()(const Subject<1>& s) const { return in_1d(s); }
  double operator()(const Subject<2>& s) const { return in_2d(s); }
};

constexpr int aside = -1;

const std::vector<PropertyMeasure>& property_measures() {
  using enum Extreme;
  static const std::vector<PropertyMeasure> all{
      {0, "phi", largest, "difference of grid field and particle field", &two_fields, &two_fields},
      {1, "i", least, "departure of phi_p(x_q) from delta_pq", &interpolation, &interpolation},
      {aside, "i_integral", largest,
       "RMS of the integrals' errors over that of point-to-point interpolation, 1D random",
       &integrals_over_interpolation, &integrals_over_interpolation},
      {2, "ii", largest, "|sum_p phi_p - 1| where every node takes part", &unity, &unity},
      {aside, "ii_gimp", largest, "|sum_p phi_p - 1|, GIMP weights", &unity_of_gimp, &unity_of_gimp},
      {aside, "ii_body", largest, "|sum_p phi_p - 1| in the whole body", &unity_in_body, &unity_in_body},
      {3, "iii", largest, "|sum_p x_p phi_p - x|/h where every node takes part", &linear_completeness,
       &linear_completeness},
      {aside, "iii_inside", largest, "|sum_p x_p phi_p - x|/h, boxes alike, three cells from the faces",
       &linear_completeness_inside, &linear_completeness_inside},
      {4, "iv", largest, "difference of gradient and difference quotient inside the pieces", &piecewise_gradient,
       &piecewise_gradient},
      {5, "v", least, "asymmetry of the least symmetric interior particle, over its peak", &asymmetry, &asymmetry},
      {aside, "v_least", least, "asymmetry of the most symmetric interior particle, over its peak", &least_asymmetry,
       &least_asymmetry},
      {6, "vi", least, "shape difference of equal boxes at other places in their cells, over the peak",
       &shape_difference, &shape_difference},
      {aside, "vi_in_phase", largest, "difference of shapes of equal boxes at the same place in their cells",
       &shape_difference_in_phase, &shape_difference_in_phase},
      {7, "vii", largest, "number of elements that two particles in one element do not share", &unshared_influence,
       &unshared_influence},
      {aside, "vii_support", largest,
       "number of elements in which influence domain and supports of the particle's nodes differ",
       &influence_beyond_support, &influence_beyond_support},
      {8, "viii", largest, "excess of phi_p over 1 or of 0 over phi_p", &positivity, &positivity},
      {9, "ix", largest, "valley on a ray from the maximum, over it", &valley, &valley},
      {10, "x", largest, "change of phi_p when grid and particles translate together", &change_with_grid,
       &change_with_grid},
      {11, "xi", least, "change of a shape, over its peak, when particles translate on the grid", &change_on_grid,
       &change_on_grid},
      {12, "xii", largest, "variation of the integral of phi_p over V_p while particles translate over a cell",
       &integral_variation, &integral_variation},
      {aside, "xii_inside", largest, "variation of the integral over V_p, boxes alike, three cells from the faces",
       &integral_variation_inside, &integral_variation_inside},
      {aside, "xii_weighted", largest, "variation of sum_ij m_ij psi_jp over M_p", &weighted_integral_variation,
       &weighted_integral_variation},
      {13, "xiii", largest, "change of phi_p on material points when grid and particles stretch together",
       &change_stretched_with_grid, &change_stretched_with_grid},
      {aside, "xiii_fixed", least, "change of phi_p, over its peak, when particles stretch on a grid that stays",
       &change_stretched_on_grid, &change_stretched_on_grid},
      {14, "xiv", largest, "difference of phi_p and the field of f_p = 1, all others 0", &field_of_one, &field_of_one},
  };
  return all;
}

/// Collects every number for the table, and for each mass matrix the extreme of each measure over the bodies of a
/// group.
class PropertyTable {
 public:
  /// Measures a body with one mass matrix. In groups with a name only the measures that are in the table are taken.
  template <int D>
  void measure(const Subject<D>& subject, const std::string& group, const std::string& body) {
    const std::string mass = to_string(subject.mass());
    for (const PropertyMeasure& m : property_measures()) {
      if (m.property == aside && !group.empty()) continue;
      const double value = m(subject);
      if (value == no_meaning) continue;
      keep(fmt::format("{}{}_{}", group, m.name, mass), m, value, body);
      if (m.property != aside) cells_[body][m.property][mass] = value;
    }
  }

  void add_to(CheckResult& result) const {
    for (const std::string& name : order_) {
      const auto& [value, meaning] = extremes_.at(name);
      result.add(name, value, meaning);
    }
    for (const auto& [body, properties] : cells_) {
      records::Series series{body, {}, {}, {}};
      for (const auto& [property, values] : properties)
        series.points.push_back({static_cast<double>(property), records::Status::ok, "", values});
      result.series.push_back(series);
    }
  }

 private:
  void keep(const std::string& name, const PropertyMeasure& m, double value, const std::string& body) {
    const auto known = extremes_.find(name);
    const bool least = m.extreme == Extreme::least;
    if (known == extremes_.end()) order_.push_back(name);
    if (known != extremes_.end()) {
      double extreme = known->second.first;
      (least ? keep_smaller : keep_larger)(extreme, value);
      if (extreme == known->second.first || std::isnan(known->second.first)) return;
    }
    extremes_[name] = {value, fmt::format("{} {} ({})", least ? "least" : "largest", m.meaning, body)};
  }

  std::vector<std::string> order_;
  std::map<std::string, std::pair<double, std::string>> extremes_;
  std::map<std::string, std::map<int, std::map<std::string, double>>> cells_;
};

/// Measures all blocks. Those with splines are a group of their own, as B speaks of a linear basis. Weighting by volume
/// is measured with the linear basis where the density is not constant; with constant density it is the same as by
/// mass.
template <int D>
void measure_blocks(PropertyTable& table) {
  using Block = BlockOfParticles<D>;
  for (const Weighting& weighting : weightings)
    for (const Placement placement : placements) {
      const bool linear = std::holds_alternative<solver::Linear>(weighting.field);
      const std::string name = Block::name(placement, weighting);
      const MappedBody<D> body(Block::grid(), Block::tiling(placement), weighting);
      for (const MassKind mass : mass_kinds) table.measure(Subject<D>(body, mass), linear ? "" : "spline_", name);
      if (placement != Placement::random || !linear) continue;
      const MappedBody<D> by_volume(body.grid(), body.tiling(), weighting, WeightedBy::volume);
      for (const MassKind mass : {MassKind::lumped, MassKind::exact, MassKind::quadrature})
        table.measure(Subject<D>(by_volume, mass), "volume_", "by volume: " + name);
    }
}

void add_counterexamples(CheckResult& result) {
  result.add("i_on_nodes", interpolation_of_particles_on_nodes(),
             "largest |phi_p(x_q) - delta_pq|, a particle on each node, lumped");
  result.add("i_two_particles", interpolation_of_two_particles(),
             "largest |phi_p(x_q) - delta_pq|, two particles in one cell, quadrature mass");
  result.add("vi_neighbours_dirac", shape_difference_by_neighbours(dirac),
             "difference of shapes of equal boxes at the same place in their cells, other neighbours, lumped, Dirac");
  result.add("vi_neighbours_gimp", shape_difference_by_neighbours(gimp),
             "difference of shapes of equal boxes at the same place in their cells, other neighbours, lumped, GIMP");
  result.add("ix_corners", valley_between_corners(),
             "valley between opposite corners of a particle's cell, heavy particles on the others, lumped");
  result.add("xiii_carried", change_carried_by_grid(),
             "change of phi_p on material points carried by a grid that deforms inhomogeneously, lumped, Dirac");
}

/// Returns a block moved so that no face of a box is on a node, because a difference quotient would be wrong across a
/// kink.
template <int D>
ParticleTiling<D> off_nodes(Placement placement) {
  return BlockOfParticles<D>::tiling(placement).translated(solver::Vec<D>::Constant(0.037));
}

/// (xi) Adds the error of the rate at which weights change, for every weighting. It does not depend on the mass matrix.
void add_rates(CheckResult& result) {
  for (const Weighting& weighting : weightings) {
    double worst = 0;
    for (const Placement placement : {Placement::translated, Placement::random}) {
      const MappedBody<1> line(BlockOfParticles<1>::grid(), off_nodes<1>(placement), weighting);
      const MappedBody<2> plane(BlockOfParticles<2>::grid(), off_nodes<2>(placement), weighting);
      keep_larger(worst, rate_misfit(line));
      keep_larger(worst, rate_misfit(plane));
    }
    result.add(fmt::format("xi_rate_{}", weighting.name), worst,
               fmt::format("largest h |dv_ip/dt - G_i . dx_p/dt|, {} weights, unit velocity", weighting.name));
  }
}

}  // namespace

}  // namespace mpmvv::checks::mapping

namespace mpmvv::checks {

/// Measures claims B-i to B-xiv, B-phi and B-vol.
CheckResult check_mapping_properties() {
  CheckResult result;
  mapping::PropertyTable table;
  mapping::measure_blocks<1>(table);
  mapping::measure_blocks<2>(table);
  table.add_to(result);
  mapping::add_counterexamples(result);
  mapping::add_rates(result);
  return result;
}

}  // namespace mpmvv::checks
