#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace mpmvv::reports {

/// What a name of a figure, a claim or a study means.
struct FigureChoice {
  std::vector<Chart> chosen;        ///< named as charts_of_all names them
  std::vector<std::string> others;  ///< of the same claim: names of figures that were not meant
};

/// A figure's name means the figure, where studies share it in each of them (STUDY~NAME: in that study); a claim's id
/// the figure of that name (S-fig10: s-fig10), or its panels (S-fig9: s-fig9a, s-fig9b), or else all figures of the
/// claim's studies; a study's name all of its figures. Throws UsageError when it means none, and where charts_of_all
/// does. `letter` is the height of a letter, as a fraction of the axes'.
FigureChoice choose_figures(const std::vector<records::StudyResult>& studies, const std::string& name,
                            double letter = paper_letter);

}  // namespace mpmvv::reports
