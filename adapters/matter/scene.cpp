// The scene of matter (https://github.com/larsblatny/matter) that the adapter runs: it stands in for matter's
// src/mpm.cpp, includes its headers and takes what a case says from the file that it is given. See
// docs/other-codes/matter.md.
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "objects/object_plate.hpp"
#include "simulation/simulation.hpp"
#include "tools.hpp"

namespace {

struct Scene {
  std::map<std::string, T> number;
  std::vector<TV> x, v;
};

template <class... Values>
void read(std::istream& file, Values&... values) {
  if (!(file >> ... >> values)) throw std::runtime_error("the scene ends early, or has another word for a number");
}

/// Lines `name value`, then `particles count` and a line with x, y, vx and vy for each.
Scene read_scene(std::istream& file) {
  Scene scene;
  for (std::string name; file >> name;) {
    if (name != "particles") {
      read(file, scene.number[name]);
      continue;
    }
    std::size_t count = 0;
    read(file, count);
    for (std::size_t p = 0; p < count; ++p) {
      TV x, v;
      read(file, x(0), x(1), v(0), v(1));
      scene.x.push_back(x);
      scene.v.push_back(v);
    }
  }
  return scene;
}

/// A plate holds the nodes that would be behind it at the end of a step: one that leaves a plate where it stands is let
/// go. Hence a quarter of a cell before the wall.
void put_walls(Simulation& sim) {
  const T lower = sim.dx / 4, upper = 1 - sim.dx / 4;
  for (const PlateType side : {PlateType::left, PlateType::bottom})
    sim.plates.push_back(std::make_unique<ObjectPlate>(lower, side, BC::SlipStick));
  for (const PlateType side : {PlateType::right, PlateType::top})
    sim.plates.push_back(std::make_unique<ObjectPlate>(upper, side, BC::SlipStick));
}

void set_up(Simulation& sim, const Scene& scene) {
  const auto number = [&](const char* name) { return scene.number.at(name); };
  sim.Lx = sim.Ly = 1;
  sim.dx = number("h");
  sim.E = number("youngs_modulus");
  sim.nu = number("poissons_ratio");
  sim.rho = number("density");
  sim.elastic_model = ElasticModel::NeoHookean;
  sim.plastic_model = PlasticModel::NoPlasticity;
  sim.flip_ratio = number("flip_ratio");
  sim.use_musl = number("musl") != 0;
  sim.n_threads = 1;
  sim.reduce_verbose = true;
  sim.grid_reference_point = TV::Zero();
  sim.end_frame = 1;
  sim.fps = 1 / number("end_time");
  sim.cfl = 1e10;
  sim.cfl_elastic = number("dt") * std::sqrt(sim.E / sim.rho) / sim.dx;
  sim.Np = scene.x.size();
  sim.particle_volume = number("particle_width") * number("particle_width");
  sim.particle_mass = sim.rho * sim.particle_volume;
  sim.particles = Particles(sim.Np);
  sim.particles.x = scene.x;
  sim.particles.v = scene.v;
  if (number("walls") != 0) put_walls(sim);
}

}  // namespace

int main(int argc, char** argv) {
  std::ifstream file(argc == 2 ? argv[1] : "");
  if (!file) {
    std::cerr << "mpmvv scene of matter: takes one file, the scene\n";
    return 2;
  }
  const Scene scene = read_scene(file);
  Simulation sim;
  sim.initialize(true, "./", "out");
  set_up(sim, scene);
  sim.simulate();
  return sim.exit;
}
