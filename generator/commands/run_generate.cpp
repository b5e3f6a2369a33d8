// `generate`: the files of one mechanism, with depfile and stamp, written all or none.
#include "commands/run_generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "commands/common_options.hpp"
#include "commands/run_import.hpp"
#include "emit/emit.hpp"
#include "emit/files/waiting_file.hpp"
#include "emit/files/write_files.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/load.hpp"
#include "simulation/interpreted_mechanism.hpp"
#include "simulation/start_state.hpp"

namespace alembert {

namespace {

std::string_view to_string(FileState state) {
  switch (state) {
    case FileState::created:
      return "created";
    case FileState::changed:
      return "changed";
    case FileState::unchanged:
      return "unchanged";
    case FileState::removed:
      return "removed";
  }
  return "";
}

/// Tells of constraints that no state keeps, as far as Newton's method from the initial one can tell: code
/// for them has no motion. Needs the functions of an InterpretedMechanism among those that are written.
void warn_of_contradictions(const CompiledMechanism& compiled) {
  const auto written = [&](FunctionKind kind) {
    return !has_results(kind.row(), *compiled.mechanism) ||
           std::ranges::find(compiled.functions, kind, &CompiledFunction::kind) != compiled.functions.end();
  };
  if (compiled.mechanism->constraints.empty() || !std::ranges::all_of(interpreted_functions(), written))
    return;
  try {
    start_state(compiled, {}, [](const std::string&) {});
  } catch (const InputError& error) {
    tell(warning_text(error.where(), error.message()) + "\n");
  }
}

/// Depfile and stamp. Without a stamp the rule is for `output`; standard input is no file to depend on.
/// \param dependencies  what was read besides the description
std::vector<RunFile> run_files(const std::string& description, std::vector<std::string> dependencies,
                               const GenerateOptions& options, const std::string& output) {
  std::vector<RunFile> out;
  if (description != "-") dependencies.insert(dependencies.begin(), description);
  if (!options.depfile.empty()) {
    out.push_back(
        {options.depfile, depfile_text(options.stamp.empty() ? output : options.stamp, dependencies)});
  }
  if (!options.stamp.empty()) out.push_back({options.stamp, ""});
  std::vector<NamedFile> written;
  if (!options.depfile.empty()) written.push_back({"--depfile", options.depfile});
  if (!options.stamp.empty()) written.push_back({"--stamp", options.stamp});
  check_distinct(written, std::vector<NamedFile>{{"the description", description}});
  return out;
}

}  // namespace

int run_generate(const CommonOptions& common, const GenerateOptions& options) {
  const FunctionChoice choice = function_choice(options.functions);
  EmitOptions emit;
  if (!options.name_space.empty()) emit.outer_namespace = options.name_space;
  const auto named = [&](const auto& language) { return language.first == options.language; };
  emit.language = std::ranges::find_if(kLanguages, named)->second;
  std::vector<std::string> read_files;
  const CompiledMechanism compiled = compile(common, description_of(common, &read_files), choice.kinds,
                                             choice.inapplicable, emit.language == Language::cpp);

  if (emit.language != Language::cpp) emit.scalars = {"double"};
  if (!options.scalars.empty()) emit.scalars = options.scalars;
  set_batch(emit, common, options.batch);
  if (!options.batch_instructions.empty()) emit.batch_instructions = options.batch_instructions;
  emit.parts = options.parts;
  emit.expected_name = options.expected_name;
  emit.axes = compiled.axes;
  const std::vector<EmittedFile> files = emit_mechanism(*compiled.mechanism, programs_of(compiled), emit);

  if (options.print_outputs) {
    for (const EmittedFile& file : files) fmt::print("{}/{}\n", options.out_dir, file.path);
    return 0;
  }
  warn_of_contradictions(compiled);
  const bool only_look = options.dry_run || options.check;
  const std::vector<WrittenFile> written =
      write_files(files, options.out_dir, only_look ? WriteMode::dry_run : WriteMode::write,
                  run_files(common.file, read_files, options, options.out_dir + "/" + files.front().path));
  if (options.check) {
    for (const WrittenFile& file : written) {
      if (file.state != FileState::unchanged) {
        tell(fmt::format("{}/{}:1:1: error: this file is not what {} gives: it would be {}\n",
                         options.out_dir, file.path, common.file, to_string(file.state)));
      }
    }
    return up_to_date(written) ? 0 : 1;
  }
  if (options.dry_run || common.verbose) {
    for (const WrittenFile& file : written)
      tell(fmt::format("{:<10} {}/{}\n", to_string(file.state), options.out_dir, file.path));
  }
  return 0;
}

}  // namespace alembert
