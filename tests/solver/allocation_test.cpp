#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/solver/scenes.hpp"

namespace {
std::atomic<std::size_t> allocations{0};
}

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
/// Where the alignment exceeds that of malloc: arrays of matrices in the plane, of momenta with their mass.
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto a = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(a, (size + a - 1) / a * a)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace mpmvv::solver {

namespace {

template <int D>
class Gravity final : public BodyForce<D> {
 public:
  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    for (std::size_t k = 0; k < ids.size(); ++k) b[k] = Vec<D>::Constant(-9.81);
  }
  Vec<D> at_position(const Vec<D>&, double) const override { return Vec<D>::Constant(-9.81); }
};

template <int D>
void expect_no_allocation(Scene<D> scene) {
  Gravity<D> gravity;
  set_wave(scene, 0.1);
  scene.body_force = &gravity;
  for (scene.threads = 1; scene.threads <= 2; ++scene.threads) {
    Mpm<D> mpm(scene);
    const std::size_t before = allocations;
    mpm.advance(0.01 * scene.h / 120, 4);
    EXPECT_EQ(allocations - before, 0U) << scene.integrator;
  }
}

template <int D>
void expect_no_allocation(const AnyBoundary& boundary) {
  for (const auto basis : words<AnyBasis>()) {
    Scene<D> scene = full_scene<D>(basis_named(basis), 17, 2, boundary);
    for (const auto integrator : integrator_words()) {
      scene.integrator = integrator;
      expect_no_allocation(scene);
    }
    expect_no_allocation(with_consistent_mass(scene));
  }
}

TEST(Allocation, AStepWithoutSortingMakesNone) {
  expect_no_allocation<1>(Dirichlet{});
  expect_no_allocation<2>(Dirichlet{});
}

TEST(Allocation, NeitherDoMovingWalls) {
  struct Standing final : WallMotion {
    double position(double) const override { return 0.5; }
    double velocity(double) const override { return 1; }
    double gradient(double) const override { return 2; }
  } motion;
  Scene<2> scene = full_scene<2>(Cpdi{}, 17, 2, Free{});
  scene.boundary[0] = Wall{&motion, 1.5, WallGradient::estimated};
  scene.boundary[3] = Wall{&motion, 1, WallGradient::given};
  for (const AnyVelocityUpdate& update : {AnyVelocityUpdate{Flip{}}, AnyVelocityUpdate{Fmpm{3}}})
    for (const auto method : {WallMethod::combined, WallMethod::elimination}) {
      scene.velocity_update = update;
      scene.wall_method = method;
      expect_no_allocation(scene);
    }
}

}  // namespace

}  // namespace mpmvv::solver
