#include "studies/runs/particle_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mpmvv::runs {

using records::ParticleError;

std::vector<ParticleError> ParticleErrors::reduced() const {
  std::vector<ParticleError> errors;
  if (all_.size() <= most && dimension_ < 3) {
    for (const One& one : all_) errors.push_back(one.now);
    return errors;
  }
  for (double width = 1; (errors = in_squares(width * spacing_)).size() > most;)
    width = std::max(width + 1, std::ceil(width * std::sqrt(static_cast<double>(errors.size()) / most)));
  return errors;
}

std::vector<ParticleError> ParticleErrors::in_squares(double width) const {
  struct Square {
    One first;  ///< the particle with the least reference position
    double squares = 0;
    std::size_t count = 0;
  };
  std::map<std::pair<double, double>, Square> found;
  for (const One& one : all_) {
    Square& square =
        found.try_emplace({std::floor(one.X[0] / width), std::floor(one.X[1] / width)}, Square{one}).first->second;
    if (one.X < square.first.X) square.first = one;
    square.squares += one.now.error * one.now.error;
    ++square.count;
  }
  std::vector<ParticleError> errors;
  for (const auto& [place, square] : found)
    errors.push_back(
        {square.first.now.x, square.first.now.y, std::sqrt(square.squares / static_cast<double>(square.count))});
  return errors;
}

}  // namespace mpmvv::runs
