#include "studies/codes/output_files.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include "studies/codes/fields.hpp"
#include "studies/codes/file_order.hpp"
#include "studies/codes/readers.hpp"
#include "studies/problems/problem.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;
using support::UsageError;

namespace {

/// Returns the files in the folder with this name, which may be a pattern. Throws UsageError if there is none.
std::vector<fs::path> files_named(const fs::path& folder, const std::string& name) {
  const fs::path pattern = fs::path(name);
  std::vector<fs::path> found;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder / pattern.parent_path(), unreadable))
    if (entry.path().filename() == pattern.filename() ||
        fnmatch(pattern.filename().c_str(), entry.path().filename().c_str(), 0) == 0)
      found.push_back(entry.path());
  if (found.empty()) throw UsageError(fmt::format("the code wrote no file '{}'", name));
  return found;
}

Snapshot read(const cases::Case& c, const Code& code, const TemplateFields& fields, const fs::path& folder,
              const std::string& name) {
  const std::string file = filled_word(name, fields, code);
  Columns columns = code.adapter.output.columns;
  columns.dimensions = problems::domain_cells(c).size();
  std::vector<fs::path> files = files_named(folder, file);
  if (code.adapter.output.are_parts)
    sort_by_name(files);
  else
    files = {last_by_name(files, file)};
  return read_snapshot(files, columns, code.adapter.output.format);
}

}  // namespace

Output read_output(const cases::Case& c, const Code& code, const TemplateFields& fields, const fs::path& folder) {
  const Adapter& adapter = code.adapter;
  Output output{{}, read(c, code, fields, folder, adapter.output.end)};
  if (!adapter.output.start.empty()) output.start = read(c, code, fields, folder, adapter.output.start);
  return output;
}

}  // namespace mpmvv::codes
