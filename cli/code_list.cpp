#include "cli/code_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/console.hpp"
#include "cli/shipped.hpp"
#include "cli/table.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

/// The entry of one code. A fault of its adapter or program stands in its entry, so that the other codes are still
/// listed.
nlohmann::json code_json(const std::filesystem::path& file) {
  nlohmann::json one{{"code", file.parent_path().filename().string()},
                     {"adapter", file.string()},
                     {"variants", nlohmann::json::array()}};
  try {
    const codes::Adapter adapter = codes::read_adapter(file);
    for (const auto& [word, values] : adapter.variants) one["variants"].push_back(word);
    if (const auto code = codes::find_code(adapter))
      one["program"] = code->program.string(), one["version"] = code->version;
    else
      one["missing"] = codes::how_to_get(adapter);
  } catch (const support::UsageError& fault) {
    one["fault"] = fault.what();
  }
  return one;
}

}  // namespace

nlohmann::json codes_json() {
  nlohmann::json codes = nlohmann::json::array();
  for (const std::filesystem::path& file : plan::CodeFinder(shipped("adapters")).adapter_files())
    codes.push_back(code_json(file));
  return codes;
}

void print_codes(const nlohmann::json& codes) {
  Table programs({{"code"}, {"version"}, {"program", Table::Kind::prose}}, 0);
  Table variants({{"code"}, {"variants", Table::Kind::prose}}, 0);
  for (const nlohmann::json& code : codes) {
    const std::string name = code["code"];
    const std::string trouble = code.value("fault", code.value("missing", ""));
    programs.add({name, code.value("version", "-"), code.value("program", trouble)});
    variants.add({name, fmt::format("{}", fmt::join(code["variants"].get<std::vector<std::string>>(), ", "))});
  }
  programs.print();
  print_text("\n");
  variants.print();
}

}  // namespace mpmvv::cli
