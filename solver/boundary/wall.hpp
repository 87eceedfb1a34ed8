#pragma once
#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/boundary/boundary.hpp"
#include "solver/boundary/wall_motion.hpp"

namespace mpmvv::solver {

/// Where the velocity gradient at a wall comes from.
enum class WallGradient {
  zero,
  given,     ///< given by the motion
  estimated  ///< from velocities of nodes at the wall, N (4)
};

/// A face from which a wall moves through the grid, N §2.5. The nodes that it holds change with time, so the face
/// itself holds none; `MovingWall` does. Where velocities are expanded, `Scene::wall_method` says which of them are
/// held (`Step::holds_before_expansion` and `Step::hold_after_expansion` in step_grid.hpp).
struct Wall {
  static constexpr std::string_view word = "wall";
  static constexpr bool holds = false;

  const WallMotion* motion = nullptr;  ///< must outlive the run
  double depth = 1;                    ///< d, in cells: how far inside the wall nodes are held
  WallGradient gradient = WallGradient::given;

  template <int D, class T>
  void sum_images(Grid<D>&, Face, Array<T>&) const {}
  template <int D>
  void constrain(Grid<D>&, Face, Array<Padded<D>>&) const {}
};

/// A wall in motion. A step calls `move` at its start, `meet` whenever momenta have been mapped, `pass_to_end` when
/// grid velocities are advanced, and `set_acceleration` after that. In between it calls `hold` and `clear`, as often as
/// it makes velocities and increments, and `hold_as_mapped` and `hold_as_advanced` around those that F follows. The
/// wall holds the planes of nodes that lie at most d cells inside it, and those outside it that have mass, as far as
/// these follow each other without a gap. It holds only the velocity along its normal, at
///   v_i = v_b + ∇v_b (x_i - x_wall),                                                N §2.5
/// and leaves tangential ones as they are. Within a step x_wall and ∇v_b are those of t^n, as the weights are, and v_b
/// is that of t^n + Δt, the time of v⁺. A motion at constant rate, v = rate X, is then kept exactly on the nodes held.
/// N does not give these times; with all three at t^n + Δt the nodes would get velocities that particles there have a
/// step later. Where F or ∇v_b follows momenta of t^n, v_b is that of t^n, too: between free nodes of t^n and held ones
/// of t^n + Δt a wall that accelerates would make a strain rate that no motion has.
template <int D>
class MovingWall {
 public:
  using Field = Array<Padded<D>>;

  /// `places` are the coordinates along the wall's axis of the planes of nodes across it, ghosts included, m.
  MovingWall(const Wall& wall, Face face, const Grid<D>& grid, std::vector<double> places)
      : wall_(wall),
        face_(face),
        ghost_(grid.ghost()),
        places_(std::move(places)),
        gradient_(grid.size() / static_cast<std::size_t>(grid.nodes(face.axis))),
        squares_(gradient_.size()) {}

  /// Sets where the wall is in the step from t on, and how far inside nodes are held. To be called at the step's start.
  void move(double t, double dt, double h) {
    position_ = wall_.motion->position(t);
    mapped_velocity_ = wall_.motion->velocity(t);
    end_velocity_ = wall_.motion->velocity(t + dt);
    velocity_ = end_velocity_;
    if (wall_.gradient == WallGradient::given) std::fill(gradient_.begin(), gradient_.end(), wall_.motion->gradient(t));
    const double depth = (wall_.depth + round_off) * h;
    inmost_ = face_.upper ? static_cast<int>(places_.size()) : -1;
    while (is_plane(inmost_ + inward()) && inside(inmost_ + inward()) <= depth) inmost_ += inward();
  }

  /// Finds the outermost plane of nodes held, and the gradients where they are to be estimated. To be called when
  /// masses and velocities v_i = p_i / m_i have been mapped.
  void meet(const Grid<D>& grid) {
    const auto is_held = [&](int k) { return is_plane(k) && (inside(k) >= 0 || has_mass(grid, k)); };
    outmost_ = inmost_;
    while (is_held(outmost_ - inward())) outmost_ -= inward();
    if (wall_.gradient == WallGradient::estimated) estimate_gradient(grid);
  }

  /// Says that momenta mapped from now on are those of t^n + Δt. Before, they are those of t^n.
  void pass_to_end() { mapped_velocity_ = end_velocity_; }

  /// Whether it makes a difference at which end of the step v_b is taken.
  bool accelerates() const { return mapped_velocity_ != end_velocity_; }

  /// Lets `hold` take v_b at the time of the mapped momenta, for the velocities that F follows.
  void hold_as_mapped() { velocity_ = mapped_velocity_; }

  /// Lets `hold` take v_b at t^n + Δt again, as after `move`: for v⁺, and for a v that v⁺ = v + Δt a starts from, as a
  /// is zero on the nodes held.
  void hold_as_advanced() { velocity_ = end_velocity_; }

  /// Sets the normal component of v_i on the nodes held.
  void hold(const Grid<D>& grid, Field& velocity) const {
    for_held(grid, [&](int n, double distance, double gradient) {
      velocity[static_cast<std::size_t>(n)][face_.axis] = velocity_ + gradient * distance;
    });
  }

  /// Sets the normal component of a field to zero on the nodes held: for increments of velocities, which these do not
  /// take, and for forces, which they do not follow.
  void clear(const Grid<D>& grid, Field& field) const {
    for_held(grid, [&](int n, double, double) { field[static_cast<std::size_t>(n)][face_.axis] = 0; });
  }

  /// Sets a_i = (v_i^{n+1} - p_i / m_i) / Δt along the normal on the nodes held, N §2.4; the grid's v is v^{n+1}.
  void set_acceleration(Grid<D>& grid, double dt) const {
    for_held(grid, [&](int node, double, double) {
      const auto n = static_cast<std::size_t>(node);
      const double v = grid.v[n][face_.axis];
      if (grid.m(n) > 0) grid.a[n][face_.axis] = (v - grid.p[n][face_.axis] / grid.m(n)) / dt;
    });
  }

 private:
  static constexpr double round_off = 1e-9;  ///< in cells: a node at depth d counts as held

  int inward() const { return face_.upper ? -1 : 1; }
  bool is_plane(int k) const { return k >= 0 && k < static_cast<int>(places_.size()); }
  double distance(int k) const { return places_[static_cast<std::size_t>(k)] - position_; }
  double inside(int k) const { return inward() * distance(k); }

  /// Calls visit(n, line) for every node of a plane. Nodes of different planes have the same `line` if they differ only
  /// along the wall's axis.
  template <class Visit>
  void for_plane(const Grid<D>& grid, int plane, const Visit& visit) const {
    std::size_t line = 0;
    grid.for_plane(face_.axis, plane - ghost_, [&](int n) { visit(n, line++); });
  }

  /// Calls visit(n, x_i - x_wall, ∇v_b) for every node held.
  template <class Visit>
  void for_held(const Grid<D>& grid, const Visit& visit) const {
    for (int plane = inmost_; is_plane(plane) && plane != outmost_ - inward(); plane -= inward())
      for_plane(grid, plane, [&](int n, std::size_t line) { visit(n, distance(plane), gradient_[line]); });
  }

  bool has_mass(const Grid<D>& grid, int plane) const {
    bool found = false;
    for_plane(grid, plane, [&](int n, std::size_t) { found = found || grid.m(static_cast<std::size_t>(n)) > 0; });
    return found;
  }

  /// Estimates ∇v_b = Σ Δv Δx / Σ Δx² on each line of nodes, over the innermost node held and the free one next to it
  /// as far as they lie inside the wall and have mass, Δv = v_i - v_b at the time of v_i, Δx = x_i - x_wall     N (4)
  void estimate_gradient(const Grid<D>& grid) {
    std::fill(gradient_.begin(), gradient_.end(), 0.0);
    std::fill(squares_.begin(), squares_.end(), 0.0);
    for (const int plane : {inmost_ + inward(), inmost_})
      if (is_plane(plane) && inside(plane) > 0)
        for_plane(grid, plane, [&](int node, std::size_t line) {
          const auto n = static_cast<std::size_t>(node);
          if (!(grid.m(n) > 0)) return;
          gradient_[line] += (grid.v[n][face_.axis] - mapped_velocity_) * distance(plane);
          squares_[line] += distance(plane) * distance(plane);
        });
    for (std::size_t line = 0; line < gradient_.size(); ++line)
      if (squares_[line] > 0) gradient_[line] /= squares_[line];
  }

  Wall wall_;
  Face face_;
  int ghost_;
  std::vector<double> places_;
  std::vector<double> gradient_, squares_;  ///< on each line of nodes along the wall's axis: ∇v_b, Σ Δx²
  double position_ = 0;
  double mapped_velocity_ = 0, end_velocity_ = 0;  ///< v_b at the time of the mapped momenta, and at t^n + Δt
  double velocity_ = 0;                            ///< the one of these that `hold` takes
  int inmost_ = -1, outmost_ = -1;                 ///< the innermost and outermost plane held, as indices of `places_`
};

}  // namespace mpmvv::solver
