#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "solver/grid.hpp"
#include "solver/scene.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// The material point method as users of the solver see it: made from a scene, advanced step by step, and read.
/// Integrators are written with the operations of `Step` (step.hpp).
template <int D>
class Mpm {
 public:
  /// Throws std::invalid_argument, which says why, for a scene that cannot be run (scene.cpp has the rules), and
  /// std::length_error if the grid has more nodes than an int counts.
  explicit Mpm(Scene<D> scene);
  ~Mpm();
  Mpm(Mpm&&) noexcept;

  /// Advances by dt > 0, s. Returns false when the run has blown up: `fault` then says why, the state is of no use, and
  /// further steps do nothing. Throws std::invalid_argument for another dt.
  bool step(double dt);
  /// Advances by this number of steps, or until the run blows up. Returns how many steps were taken, including the one
  /// that blew up. As a rule this is faster than single steps, with the same results: the last sweep of a step and the
  /// first of the next visit particles together.
  std::int64_t advance(double dt, std::int64_t steps);
  /// Finds out whether particles have left the domain, or outgrown their widths, in the last step: steps find this when
  /// they next map the particles. Returns false if so; `fault` then says what is wrong.
  bool check();
  std::string fault() const;

  const Particles<D>& particles() const;        ///< sorted by place; `id` is the order of creation; for `thermal`,
                                                ///< read `thermal_state`
  const Grid<D>& grid() const;                  ///< as `map_acceleration` has left it, or the last step, after which
                                                ///< the velocity update may keep other fields in f and a; nodes
                                                ///< that images alone give mass may have none
  const std::array<bool, D>& periodic() const;  ///< whether each axis is periodic
  double time() const;                          ///< s
  std::int64_t steps() const;                   ///< number of finished steps

  // Sums over the particles and the scene's images of them.
  double mass() const;            ///< Σ m_p, kg
  double kinetic_energy() const;  ///< Σ m_p v_p²/2, J
  double strain_energy() const;   ///< Σ V⁰_p W(F_p), J, or the internal energy of a material with a history

  Mat<D> stress(std::size_t p) const;  ///< Cauchy stress of a particle, Pa

  /// The state of a particle of a material with a history, at the same time as its x and F. What the particles keep is
  /// as of the last evaluation of the stress, which most integrators make before they move particles; this is a copy of
  /// that, advanced to det F_p. Throws std::invalid_argument for a material without a history.
  ThermalState thermal_state(std::size_t p) const;

  /// Maps the particles in their current state, at the current time. The grid then holds m_i and a_i = f_i/m_i, which
  /// faces constrain, without the factor of `half_start`. On held nodes a_i is of no use in three kinds of scenes: with
  /// `difference_acceleration` and with the wall method `velocity` it is not constrained, and with moving walls it is
  /// zero on the nodes that the last step held. Throws std::invalid_argument for a material with a history: to evaluate
  /// its stress is to advance its state.
  void map_acceleration();
  Vec<D> node_position(std::size_t n) const;  ///< position of the node at a storage index, m
  bool is_accelerated(std::size_t n) const;   ///< whether the mass of a node exceeds the scene's `mass_cutoff`

 private:
  double with_images(double sum) const;

  std::unique_ptr<Step<D>> step_;
};

extern template class Mpm<1>;
extern template class Mpm<2>;
extern template class Mpm<3>;

}  // namespace mpmvv::solver
