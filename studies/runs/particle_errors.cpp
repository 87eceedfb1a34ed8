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
    const One* nearest = nullptr;  ///< to its middle; of several, to round-off, the one with the least position at rest
    double distance = 0;           ///< of that one, squared
    double squares = 0;
    std::size_t count = 0;
  };
  std::map<std::pair<double, double>, Square> found;
  for (const One& one : all_) {
    const double i = std::floor(one.X[0] / width), j = std::floor(one.X[1] / width);
    Square& square = found[{i, j}];
    const double distance = std::pow(one.X[0] - (i + 0.5) * width, 2) + std::pow(one.X[1] - (j + 0.5) * width, 2);
    const double nearer = square.distance - distance, round_off = 1e-9 * width * width;
    const bool is_first = !square.nearest || one.X < square.nearest->X;
    if (!square.nearest || nearer > round_off || (nearer >= -round_off && is_first))
      square.nearest = &one, square.distance = distance;
    square.squares += one.now.error * one.now.error;
    ++square.count;
  }
  std::vector<ParticleError> errors;
  for (const auto& [place, square] : found)
    errors.push_back(
        {square.nearest->now.x, square.nearest->now.y, std::sqrt(square.squares / static_cast<double>(square.count))});
  return errors;
}

}  // namespace mpmvv::runs
