#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// A table for people: texts in columns, rows in titled groups.
struct Table {
  using Rows = std::vector<std::vector<std::string>>;
  struct Group {
    std::string title;
    Rows rows;
  };
  std::string caption;
  std::vector<std::string> columns;
  std::vector<Group> groups;
  std::string note = {};  ///< what is to be said of all rows; may be empty

  bool empty() const { return groups.empty(); }
};

/// All points, with the order of each segment; series too long to be read are left out. What is the same at every point
/// stands in the note. The units of energies are those of bodies in this dimension (records::unit_of_energy).
Table points_table(const records::StudyResult& study, int dimension = 0);
Table fits_table(const records::StudyResult& study);
Table replicates_table(const records::StudyResult& study);
Table extrapolations_table(const records::StudyResult& study);
Table limits_table(const records::StudyResult& study);
Table values_table(const records::StudyResult& study);
Table cheapest_table(
    const records::StudyResult& study);  ///< of each power of ten of the error, where cost was measured

inline constexpr const char* points_caption = "Results at each point";

/// All tables of a study that have rows.
std::vector<Table> tables_of(const records::StudyResult& study, int dimension = 0);

}  // namespace mpmvv::reports
