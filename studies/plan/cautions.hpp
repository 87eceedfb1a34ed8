#pragma once
#include <string>
#include <vector>

#include "studies/plan/study.hpp"

namespace mpmvv::plan {

/// What is to be known before the errors of these series are believed (codes::caution).
struct Caution {
  std::string text;
  std::vector<std::string> series;
};

/// Those of the series that other codes run, each text once.
std::vector<Caution> cautions(const StudyPlan& plan);

/// "STUDY, 'a', 'b': TEXT".
std::string caution_text(const std::string& study, const Caution& caution);

}  // namespace mpmvv::plan
