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

/// The Material Point Method for its users: made from a scene, advanced step by step, and read. Integrators are written
/// in `Step` (step.hpp).
template <int D>
class Mpm {
 public:
  /// Throws std::invalid_argument on what makes no scene: an unknown integrator, no particles or threads, particles
  /// without the widths that the basis takes, a wall without a motion.
  explicit Mpm(Scene<D> scene);
  ~Mpm();
  Mpm(Mpm&&) noexcept;

  /// Advances by dt. False when the run has blown up: `fault` then says why, the state is of no use, and further steps
  /// do nothing.
  bool step(double dt);
  /// Advances by so many steps, or until the run blows up; returns how many it took, that one included. As a rule
  /// faster than one by one, to the same results: the end of a step and the start of the next visit particles together.
  std::int64_t advance(double dt, std::int64_t steps);
  std::string fault() const;

  const Particles<D>& particles() const;        ///< in the order of their places; ids are in that of creation
  const Grid<D>& grid() const;                  ///< as the last step or `map_acceleration` has left it
  const std::array<bool, D>& periodic() const;  ///< by axis
  double time() const;
  std::int64_t steps() const;  ///< finished ones

  // Sums over the particles and the scene's images of them.
  double mass() const;            ///< Σ m_p
  double kinetic_energy() const;  ///< Σ m_p v_p²/2
  double strain_energy() const;   ///< Σ V⁰_p W(F_p), or the internal energy of a material with a history

  Mat<D> stress(std::size_t p) const;  ///< Cauchy stress of a particle

  /// Maps the particles as they are now: the grid then holds m_i and a_i = f_i/m_i, constrained, of this very time,
  /// where a step leaves those of its start.
  void map_acceleration();
  Vec<D> node_position(std::size_t n) const;  ///< of the node at a storage index
  bool is_accelerated(std::size_t n) const;   ///< whether its mass exceeds the scene's `mass_cutoff`

 private:
  double with_images(double sum) const;

  std::unique_ptr<Step<D>> step_;
};

extern template class Mpm<1>;
extern template class Mpm<2>;
extern template class Mpm<3>;

}  // namespace mpmvv::solver
