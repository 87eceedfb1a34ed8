#pragma once
#include <string>

#include "reports/report.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

/// A report to write in tests, and its pages.
namespace mpmvv::reports::report_pages {

inline void silent(const std::string&) {}

inline ReportInput input() {
  ReportInput in;
  in.studies = {synthetic::convergence(), synthetic::limits(), synthetic::check()};
  in.gate = {{"bar-bases", "order", records::Verdict::pass, "1.85 to 2.15", "2.01", ""},
             {"bar-cfl", "limit", records::Verdict::inconclusive, "1.1 to 1.3", "–", "not <found>"}};
  in.claims = {synthetic::claim("order 2.01 & <script>alert(1)</script>"),
               {"S-fig9", "a limit", "A paper", "", claims::Claim::Verdict::open, "", {}, {}}};
  in.digest = "00ff", in.written = "2026-01-02T00:00:00Z";
  for (const auto& study : in.studies)
    in.provenances[study.name] = {in.digest,        "8be1f2c", true,  "GNU 12.2.0",
                                  "-O3 \"-march\"", "Release", "CPU", "2026-01-01T00:00:00Z"};
  return in;
}

inline std::string page_of(const ReportInput& in, const TempFolder& folder) {
  write_report(in, folder / "out", silent);
  return content(folder / "out" / "index.html");
}

/// A page of a report, by its file.
inline std::string page_of(const ReportInput& in, const TempFolder& folder, const std::string& file) {
  write_report(in, folder / "out", silent);
  return content(folder / "out" / file);
}

}  // namespace mpmvv::reports::report_pages
