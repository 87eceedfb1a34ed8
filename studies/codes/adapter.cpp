#include "studies/codes/adapter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "solver/boundary/boundaries.hpp"
#include "solver/material/materials.hpp"
#include "solver/words.hpp"
#include "studies/cases/case.hpp"
#include "studies/codes/adapter_digest.hpp"
#include "studies/codes/expressions.hpp"
#include "studies/codes/field_names.hpp"
#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::codes {

using support::TomlTable;
using support::UsageError;

namespace {

TomlTable required_table(const TomlTable& root, const std::string& name, const std::vector<std::string>& keys) {
  const auto table = root.table(name);
  if (!table) throw UsageError(fmt::format("no [{}] in {} (an adapter has one)", name, root.where()));
  table->allow_only(keys);
  return *table;
}

/// Returns the texts of a key; UsageError if there are none.
std::vector<std::string> some_texts(const TomlTable& table, const std::string& key, const char* wanted) {
  std::vector<std::string> texts = table.texts(key);
  if (texts.empty()) throw UsageError(fmt::format("no '{}' in {} ({})", key, table.where(key), wanted));
  return texts;
}

void require_words(const std::vector<std::string>& words, const std::vector<std::string>& known, const char* what,
                   const std::string& where) {
  for (const std::string& word : words)
    if (std::ranges::find(known, word) == known.end())
      throw UsageError(fmt::format("unknown {} '{}' in {} (known: {})", what, word, where, fmt::join(known, ", ")));
}

FieldValues values_of(const TomlTable& table) {
  FieldValues values;
  for (const std::string& key : table.keys()) values[key] = table.scalar_text(key);
  return values;
}

/// Returns the values that a table of this name gives to templates.
FieldValues field_values(const TomlTable& table, const std::string& name) {
  for (const std::string& key : table.keys())
    if (is_field_of_case(key))
      throw UsageError(
          fmt::format("'{}' of [{}] in {} (another name: the case gives that one)", key, name, table.where(key)));
  return values_of(table);
}

ProgramNames read_program(const TomlTable& root) {
  const TomlTable table = required_table(root, "program", {"variable", "command", "version", "page"});
  return {table.text("variable"), table.text("command", ""), table.texts("version"), table.text("page", "")};
}

std::vector<InputFile> read_input_files(const TomlTable& root, const std::filesystem::path& folder) {
  std::vector<InputFile> inputs;
  const auto output = root.table("output");
  for (const TomlTable& table : root.tables("input")) {
    table.allow_only({"template", "file", "in_units"});
    const std::filesystem::path file = table.text("file");
    if (file.is_absolute() || file.has_parent_path() || !file.has_filename())
      throw UsageError(
          fmt::format("input file '{}' in {} (a name in the run's folder)", file.string(), table.where("file")));
    const std::filesystem::path source = folder / table.text("template");
    const bool in_units = table.flag("in_units", false);
    if (in_units && !(output && output->has("units")))
      throw UsageError(fmt::format("in_units in {}, but no units in [output] (in m, s, kg)", table.where("in_units")));
    inputs.push_back({file, support::require_file(source, "a template of an adapter"), source, in_units});
  }
  return inputs;
}

void read_command(const TomlTable& root, Adapter& adapter) {
  const TomlTable table = required_table(root, "command", {"argv", "environment", "time_limit", "unstable"});
  adapter.command = some_texts(table, "argv", "the words of the command, the first of them \"{{program}}\"");
  adapter.unstable = table.texts("unstable");
  if (std::ranges::find(adapter.unstable, "") != adapter.unstable.end())
    throw UsageError(
        fmt::format("an empty text of 'unstable' in {} (a text that the code prints when the motion blew up)",
                    table.where("unstable")));
  if (const auto environment = table.table("environment")) adapter.environment = values_of(*environment);
  const double seconds = table.number("time_limit");
  if (!(seconds > 0 && seconds <= 1e6))
    throw UsageError(
        fmt::format("time_limit = {} in {} (in s, > 0 and at most 1e6)", seconds, table.where("time_limit")));
  adapter.time_limit = std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000 * seconds)));
}

/// Reads the names of the columns, how many m, s and kg the file's units of length, time and mass are, and the
/// thickness of plane bodies in m.
Columns read_columns(const TomlTable& output) {
  Columns columns;
  if (const auto names = output.table("columns")) {
    std::vector<std::string> pairs;
    for (const auto& [quantity, name] : values_of(*names)) pairs.push_back(quantity + "=" + name);
    columns.where = output.where("columns");
    columns.names = parse_columns(fmt::format("{}", fmt::join(pairs, ",")), columns.where);
  }
  if (const auto units = output.table("units")) {
    units->allow_only({"length", "time", "mass", "thickness"});
    for (const auto& [key, unit] : {std::pair{"length", &columns.length},
                                    {"time", &columns.time},
                                    {"mass", &columns.mass},
                                    {"thickness", &columns.thickness}}) {
      *unit = units->number(key, 1);
      if (!(*unit > 0)) throw UsageError(fmt::format("{} = {} in {} (> 0)", key, *unit, units->where(key)));
    }
  }
  return columns;
}

OutputFiles read_output(const TomlTable& root) {
  const TomlTable table =
      required_table(root, "output", {"format", "file", "start", "parts", "convert", "columns", "units"});
  OutputFiles output{table.text("format", ""), table.text("file"), table.text("start", ""), {}, read_columns(table)};
  output.are_parts = table.flag("parts", false);
  std::vector<std::string> known;
  for (const Format& format : formats()) known.push_back(format.word);
  if (!output.format.empty()) require_words({output.format}, known, "format", table.where("format"));
  for (const TomlTable& step : table.tables("convert")) {
    step.allow_only({"argv"});
    output.convert.push_back(some_texts(step, "argv", "the words of a command"));
  }
  return output;
}

Stepping read_stepping(const TomlTable& root) {
  Stepping stepping;
  const auto table = root.table("step");
  if (!table) return stepping;
  table->allow_only({"rule", "time_tolerance"});
  const std::string rule = table->text("rule", "given");
  require_words({rule}, {"given", "own"}, "rule", table->where("rule"));
  stepping.is_given = rule == "given";
  stepping.time_tolerance = table->number("time_tolerance", stepping.time_tolerance);
  if (!(stepping.time_tolerance >= 0 && stepping.time_tolerance <= 0.1))
    throw UsageError(fmt::format("time_tolerance = {} in {} (of the end time: from 0 to 0.1)", stepping.time_tolerance,
                                 table->where("time_tolerance")));
  return stepping;
}

Capabilities read_capabilities(const TomlTable& root) {
  const TomlTable table = required_table(
      root, "capabilities",
      {"dimensions", "force_forms", "boundaries", "materials", "initial_velocity", "initial_deformation"});
  Capabilities able;
  for (const double dimension : table.numbers("dimensions")) {
    if (dimension != 1 && dimension != 2 && dimension != 3)
      throw UsageError(fmt::format("dimension {} in {} (1, 2 or 3)", dimension, table.where("dimensions")));
    able.dimensions.push_back(static_cast<int>(dimension));
  }
  const auto words = [&](const char* key, const std::vector<std::string>& known) {
    const auto found = some_texts(table, key, "a list of words");
    require_words(found, known, key, table.where(key));
    return found;
  };
  const auto forms = cases::words_of(cases::ForceForm{});
  able.force_forms = words("force_forms", {forms.begin(), forms.end()});
  const auto boundaries = solver::words<solver::AnyBoundary>();
  able.boundaries = words("boundaries", {boundaries.begin(), boundaries.end()});
  const auto materials = solver::words<solver::AnyMaterial>();
  able.materials = words("materials", {materials.begin(), materials.end()});
  able.initial_velocity = table.flag("initial_velocity", false);
  able.initial_deformation = table.flag("initial_deformation", false);
  return able;
}

}  // namespace

Adapter read_adapter(const std::filesystem::path& file) {
  const std::string text = support::require_file(file, "an adapter, TOML");
  const TomlTable root = TomlTable::parse(text, file.string());
  root.allow_only(
      {"code", "program", "input", "command", "output", "step", "expressions", "fields", "variants", "capabilities"});
  Adapter adapter;
  adapter.name = root.text("code");
  adapter.folder = file.parent_path();
  if (adapter.name != std::filesystem::absolute(file).parent_path().filename())
    throw UsageError(fmt::format("code '{}' in {} (the name of the adapter's folder, {})", adapter.name,
                                 root.where("code"),
                                 std::filesystem::absolute(file).parent_path().filename().string()));
  adapter.program = read_program(root);
  adapter.inputs = read_input_files(root, adapter.folder);
  read_command(root, adapter);
  adapter.output = read_output(root);
  adapter.stepping = read_stepping(root);
  if (const auto table = root.table("expressions")) {
    table->allow_only({"dialect"});
    adapter.dialect = table->text("dialect");
    dialect_named(adapter.dialect, table->where("dialect"));
  }
  if (const auto table = root.table("fields")) adapter.fields = field_values(*table, "fields");
  if (const auto table = root.table("variants"))
    for (const std::string& word : table->keys())
      adapter.variants[word] = field_values(*table->table(word), "variants." + word);
  adapter.capabilities = read_capabilities(root);
  if (adapter.output.columns.thickness != 1 && std::ranges::count(adapter.capabilities.dimensions, 2) == 0)
    throw UsageError(fmt::format("a thickness in {} of a code that runs no plane cases (2 among its dimensions)",
                                 root.where("output")));
  adapter.digest = adapter_digest(text, adapter);
  return adapter;
}

}  // namespace mpmvv::codes
