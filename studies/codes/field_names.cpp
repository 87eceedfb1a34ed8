#include "studies/codes/field_names.hpp"

#include <algorithm>
#include <vector>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

namespace {

using Names = std::set<std::string>;

void add_words(Names& names, const std::string& prefix, const auto& words) {
  for (const auto& word : words) names.insert(condition_name(prefix, std::string(word)));
}

void add_axes(Names& names) {
  for (const std::string axis : {"x", "y", "z"}) {
    for (const char* vector : {"lower_", "upper_", "cells_", "b_", "v0_", "u_", "v_"}) names.insert(vector + axis);
    names.insert({axis, axis + "_below", axis + "_above"});
    for (const std::string other : {"x", "y", "z"}) names.insert({"F0_" + axis + other, "F_" + axis + other});
  }
}

/// Those that one word or number of the case makes.
Names names_of_case() {
  return {"program",
          "adapter",
          "cells",
          "ppc",
          "particles_per_cell",
          "h",
          "particle_width",
          "dt",
          "steps",
          "end_time",
          "before_end",
          "cfl",
          "wave_speed",
          "dimension",
          "problem",
          "material",
          "boundary",
          "variant",
          "force_form",
          "youngs_modulus",
          "poissons_ratio",
          "lambda",
          "mu",
          "bulk_modulus",
          "density",
          "has_initial_velocity",
          "has_initial_deformation",
          "is_quarter",
          "is_line",
          "is_plane",
          "is_solid",
          "particles",
          "particle_count"};
}

void add_particle(Names& names) {
  names.insert({"id", "m", "V", "X", "Y", "Z", "is_first", "is_last"});
}

void add_faces(Names& names) {
  for (std::size_t face = 0; face < 6; ++face) {
    const std::string name = face_name(face);
    names.insert({"boundary_" + name, name + "_position", name + "_velocity"});
    add_words(names, name + "_is_", solver::words<solver::AnyBoundary>());
  }
}

Names all_names() {
  Names names = names_of_case();
  add_words(names, "is_", solver::words<solver::AnyBoundary>());
  add_words(names, "is_", cases::words_of(cases::ForceForm{}));
  add_particle(names);
  add_axes(names);
  add_faces(names);
  return names;
}

}  // namespace

std::string condition_name(const std::string& prefix, std::string word) {
  std::ranges::replace(word, '-', '_');
  return prefix + word;
}

std::string face_name(std::size_t face) {
  return std::string(1, "xyz"[face / 2]) + (face % 2 == 0 ? "min" : "max");
}

const std::set<std::string>& names_of_fields() {
  static const Names names = all_names();
  return names;
}

bool is_field_of_case(const std::string& name) {
  return name.starts_with("param_") || names_of_fields().contains(name);
}

}  // namespace mpmvv::codes
