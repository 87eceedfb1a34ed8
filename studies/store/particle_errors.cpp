#include "studies/store/particle_errors.hpp"

#include <fmt/format.h>

#include <sstream>

namespace mpmvv::store {

using records::ParticleError;

Value value_of(const std::vector<ParticleError>& errors) {
  std::string text;
  for (const ParticleError& one : errors) text += fmt::format("{:.5g} {:.5g} {:.5g}\n", one.x, one.y, one.error);
  return text.empty() ? Value() : Value(text);
}

std::vector<ParticleError> particle_errors_of(const Value& value) {
  std::vector<ParticleError> errors;
  if (value.null()) return errors;
  std::istringstream text(value.text());
  for (ParticleError one; text >> one.x >> one.y >> one.error;) errors.push_back(one);
  return errors;
}

}  // namespace mpmvv::store
