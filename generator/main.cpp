// The command line. The one place that catches: InputError exits 1, anything else that is thrown is a defect
// and exits 2.
#include <fcntl.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <utility>

#include "commands/common_options.hpp"
#include "commands/run_bench.hpp"
#include "commands/run_check.hpp"
#include "commands/run_evaluate.hpp"
#include "commands/run_generate.hpp"
#include "commands/run_identify.hpp"
#include "commands/run_import.hpp"
#include "commands/run_report.hpp"
#include "commands/run_simulate.hpp"
#include "commands/warnings.hpp"
#include "emit/argument_lists.hpp"
#include "emit/emit.hpp"
#include "import/importers.hpp"

namespace alembert {

namespace {

/// --functions: names, `all`, or `help`, which shows the table.
void add_functions(CLI::App* command, std::vector<std::string>& functions, const std::string& meaning) {
  command
      ->add_option_function<std::vector<std::string>>(
          "--functions",
          [&functions](const std::vector<std::string>& names) {
            if (std::ranges::find(names, "help") != names.end()) {
              fmt::print("{}", function_list());
              throw CLI::Success();
            }
            functions = names;
          },
          meaning + "; all: every function that the mechanism has; help: list them")
      ->delimiter(',');
}

/// A check of one value of an option: a finite number that `accepts` takes, such as `a number above 0`.
CLI::Validator finite_number(const std::string& expected, const std::function<bool(double)>& accepts) {
  const auto check = [=](const std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && accepts(value);
    return good ? std::string() : "expected " + expected + ", not '" + printable(text) + "'";
  };
  return {check, "", ""};
}
CLI::Validator any_number() {
  return finite_number("a finite number", [](double) { return true; });
}
CLI::Validator from_zero() {
  return finite_number("a finite number that is not negative", [](double x) { return x >= 0; });
}
CLI::Validator above_zero() {
  return finite_number("a finite number above 0", [](double x) { return x > 0; });
}

/// Groups of options in `--help`, in the order in which commands add them: what most users want comes first.
constexpr const char* kRobotGroup = "For a robot in another format";
constexpr const char* kBuildGroup = "For build systems and scripts";
constexpr const char* kOptimiserGroup = "For those who look into the optimiser";

/// The value of --massless.
void read_massless(const std::string& value, DescribeOptions& options) {
  constexpr std::string_view kArmature = "armature=";
  double armature = 0;
  if (value == "keep") {
    options.massless = Massless::keep;
  } else if (value == "freeze") {
    options.massless = Massless::freeze;
  } else if (value == "drop") {
    options.massless = Massless::drop;
  } else if (value.starts_with(kArmature) &&
             CLI::detail::lexical_cast(value.substr(kArmature.size()), armature) && armature > 0 &&
             std::isfinite(armature)) {
    options.massless = Massless::armature;
    options.armature = armature;
  } else {
    throw CLI::ValidationError(
        "--massless", "expected armature=VALUE with a positive value, freeze, drop or keep, found '" +
                          printable(value) + "'");
  }
}

/// How a file of another format becomes a description.
void add_importing(CLI::App* command, DescribeOptions& describe, const std::string& group) {
  command
      ->add_option("--include", describe.include_folders,
                   "folder in which models and packages are that an SDF or URDF names (model://NAME, "
                   "package://NAME), or files that an MJCF names beyond its own; may be repeated")
      ->allow_extra_args(false)
      ->group(group);
  command->add_option("--name", describe.name, "what to call the mechanism (default: as the file does)")
      ->group(group);
  command
      ->add_option_function<std::string>(
          "--root", [&describe](const std::string& value) { describe.floating = value == "floating"; },
          "does the root link stand still or move freely?")
      ->check(CLI::IsMember({"fixed", "floating"}))
      ->default_str("fixed")
      ->group(group);
  command
      ->add_option("--snap-angles", describe.snap_angles,
                   "take angles of origins this near to a multiple of pi/12 for that multiple, rad")
      ->check(from_zero())
      ->capture_default_str()
      ->group(group);
  command
      ->add_option_function<std::string>(
          "--massless", [&describe](const std::string& value) { read_massless(value, describe); },
          "what to do with joints that move no mass: armature=VALUE gives each a rotor's inertia (kg m^2, or "
          "kg), "
          "freeze fixes them at zero, drop leaves them and what they move out, keep warns")
      ->default_str("keep")
      ->group(group);
  command
      ->add_flag_callback(
          "--no-friction", [&describe] { describe.resistance = false; },
          "leave damping and friction of joints out of the description")
      ->group(group);
}

/// A command that reads a description.
CLI::App* add_reader(CLI::App& app, const std::string& name, const std::string& description,
                     CommonOptions& common) {
  CLI::App* command = app.add_subcommand(name, description);
  command
      ->add_option("file", common.file,
                   "mechanism description (YAML), " + importable_formats() + "; - is standard input")
      ->required();
  add_importing(command, common.describe, kRobotGroup);
  return command;
}

/// The passes that look for fewer operations.
void add_passes(CLI::App* command, CommonOptions& common) {
  command
      ->add_option_function<std::vector<std::string>>(
          "--without",
          [&common](const std::vector<std::string>& passes) {
            for (const std::string& pass : passes) {
              if (pass == "peeling") common.passes.peeling = false;
              if (pass == "placement") common.passes.placement = common.passes.regrouping = false;
              if (pass == "regrouping") common.passes.regrouping = false;
              if (pass == "scaling") common.passes.scaling = false;
              if (pass == "articulation") common.passes.articulation = false;
            }
          },
          "passes to leave out, separated by commas; without placement no regrouping either")
      ->delimiter(',')
      ->check(CLI::IsMember({"peeling", "placement", "regrouping", "scaling", "articulation"}))
      ->group(kOptimiserGroup);
  command
      ->add_option("--effort", common.passes.effort,
                   "how long to search for fewer operations: 2 is twice as long as usual, 0 not at all")
      ->check(from_zero())
      ->capture_default_str()
      ->group(kOptimiserGroup);
}

/// All options of the commands that compile a mechanism; to be added after the command's own.
void add_compiler_options(CLI::App* command, CommonOptions& common) {
  command
      ->add_option_function<std::string>(
          "--formulation",
          [&common](const std::string& value) {
            if (value == "factored") common.formulation = Formulation::factored;
            if (value == "reduced") common.formulation = Formulation::reduced;
          },
          "factored (eq. 13 of the paper), reduced (twists and wrenches), or auto: fewest operations")
      ->check(CLI::IsMember({"factored", "reduced", "auto"}))
      ->default_str("auto")
      ->group(kOptimiserGroup);
  add_passes(command, common);
  command
      ->add_option("--loop-operations", common.loop_operations,
                   "write repeated steps as loops in functions of more operations than this")
      ->check(from_zero())
      ->capture_default_str()
      ->group(kOptimiserGroup);
  command
      ->add_option("--loop-results", common.loop_results,
                   "write so many dot products of the same rows, or more, as loops; 0: none")
      ->check(from_zero())
      ->capture_default_str()
      ->group(kOptimiserGroup);
  command->add_flag("--verbose", common.verbose, "print time, nodes and operations of each stage")
      ->group(kOptimiserGroup);
  command->add_option("--dump", common.dump_stage, "print what a stage makes")
      ->check(CLI::IsMember(dump_stages()))
      ->group(kOptimiserGroup);
}

/// What `--help` ends with.
void add_examples(CLI::App& app) {
  app.footer(
      "alembert COMMAND --help tells the options of a command. Examples:\n"
      "  alembert import robot.urdf --out robot.yaml\n"
      "  alembert simulate robot.yaml --html robot.html\n"
      "  alembert generate robot.yaml --out-dir robot");
  const std::pair<const char*, const char*> examples[] = {
      {"generate", "alembert generate arm.yaml --out-dir arm --functions inverse_dynamics,forward_dynamics"},
      {"report", "alembert report arm.yaml"},
      {"bench", "alembert bench robot.urdf --functions inverse_dynamics --compiler 'g++ -O3 -march=native'"},
      {"evaluate",
       "echo '{\"q\": [0, 1, 0], \"qd\": [0, 0, 0], \"qdd\": [0, 0, 0]}' | alembert evaluate arm.yaml"},
      {"simulate", "alembert simulate arm.yaml --q 0.5,1,0 --duration 5 --html arm.html"},
      {"check", "alembert check arm.yaml --states 1000"},
      {"identify", "alembert identify arm.yaml --example ."},
      {"import", "alembert import robot.urdf --root floating --out robot.yaml"}};
  for (const auto& [name, example] : examples)
    app.get_subcommand(name)->footer(std::string("Example:\n  ") + example);
}

std::vector<std::string> language_names() {
  std::vector<std::string> names;
  for (const auto& [name, language] : kLanguages) names.emplace_back(name);
  return names;
}

/// What is said of the first word of the command line that no command and no option is; empty if there is none.
std::string about_unknown_word(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const std::vector<std::string> unknown = command.remaining();
  if (unknown.empty()) return {};
  const std::string word = unknown.front().substr(0, unknown.front().find('='));
  const std::string listed = commands.empty() ? "alembert" : "alembert " + command.get_name();
  std::vector<std::string> known;
  if (word.starts_with('-')) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  } else if (commands.empty()) {
    for (const CLI::App* each : app.get_subcommands({})) known.push_back(each->get_name());
  } else {
    return {};
  }
  return fmt::format("there is no {} '{}'{}\n`{} --help` lists them.\n",
                     word.starts_with('-') ? "option" : "command", printable(word), did_you_mean(word, known),
                     listed);
}

int run(int argc, char** argv) {
  CLI::App app{"alembert writes the equations of motion of a mechanism as code.", "alembert"};
  app.set_version_flag("--version", "alembert " ALEMBERT_VERSION);
  app.require_subcommand(1);
  CommonOptions common;
  int result = 0;

  GenerateOptions generate;
  CLI::App* command = add_reader(
      app, "generate", "write the functions of a mechanism as C++, C99, Python, JavaScript or CUDA", common);
  command->add_option("--out-dir", generate.out_dir, "folder to write into")->required();
  add_functions(command, generate.functions, "functions to write (default: those marked in the list)");
  command
      ->add_option("--scalars", generate.scalars,
                   "scalar types to compile for: double, float (default: both)")
      ->delimiter(',');
  command
      ->add_option("--language", generate.language,
                   "c++; or c: the C interface with C99 behind it, for one scalar type (default: double); or "
                   "python: the same and a module over it; or javascript: an ES module; or cuda: functions "
                   "of host and device, and kernels")
      ->check(CLI::IsMember(language_names()))
      ->capture_default_str();
  command->add_option("--namespace", generate.name_space, "outer namespace (default: alembert::mechanisms)");
  command
      ->add_option("--batch", generate.batch,
                   "functions to write over many states too; `default` stands for inverse_dynamics, "
                   "mass_matrix_and_bias, forward_dynamics")
      ->delimiter(',');
  command
      ->add_option("--batch-instructions", generate.batch_instructions,
                   "instructions to compile batches for beside the baseline (default: avx2,avx512)")
      ->delimiter(',')
      ->group(kBuildGroup);
  command->add_option("--parts", generate.parts, "files over which definitions are spread (default: by size)")
      ->check(CLI::Range(0, kMaxParts))
      ->group(kBuildGroup);
  command->add_option("--expected-name", generate.expected_name, "fail unless the mechanism has this name")
      ->group(kBuildGroup);
  command->add_option("--depfile", generate.depfile, "write a make dependency file for the stamp")
      ->group(kBuildGroup);
  command->add_option("--stamp", generate.stamp, "touch this file when done")->group(kBuildGroup);
  CLI::Option* print_outputs =
      command->add_flag("--print-outputs", generate.print_outputs, "list the files instead of writing them")
          ->group(kBuildGroup);
  command->add_flag("--dry-run", generate.dry_run, "do everything but write")->group(kBuildGroup);
  command
      ->add_flag("--check", generate.check,
                 "write nothing; exit 1 if a file differs from what would be written")
      ->excludes(print_outputs)
      ->group(kBuildGroup);
  add_compiler_options(command, common);
  command->callback([&] {
    if (generate.language != "c++" && !(generate.name_space.empty() && generate.batch.empty() &&
                                        generate.batch_instructions.empty() && generate.parts == 0))
      throw CLI::ValidationError("--language " + generate.language,
                                 "has no --namespace, --batch, --batch-instructions and --parts");
    if (generate.language == "cuda" && !generate.scalars.empty())
      throw CLI::ValidationError("--language cuda",
                                 "has no --scalars: its functions are for any scalar type");
    result = run_generate(common, generate);
  });

  ReportOptions report;
  command = add_reader(app, "report", "count the operations of each function", common);
  add_functions(command, report.functions, "functions to count (default: those of dynamics)");
  command->add_flag("--json", report.json, "as JSON");
  add_compiler_options(command, common);
  CLI::Option* memory =
      command
          ->add_option("--memory", report.memory,
                       "double or float: also bytes of code and stack, of C99 compiled by --compiler")
          ->check(CLI::IsMember({"double", "float"}));
  command->add_option("--compiler", report.compiler, "C compiler for --memory, with its flags")
      ->needs(memory)
      ->capture_default_str();
  command->callback([&] { result = run_report(common, report); });

  BenchOptions bench;
  command = add_reader(app, "bench",
                       "compile the functions of a mechanism, or of a robot as " + importable_formats() +
                           ", and time them on this machine",
                       common);
  add_functions(command, bench.functions, "functions to time (default: those marked in the list)");
  command
      ->add_option("--batch", bench.batch,
                   "functions to time over many states in one call too; `default` stands for "
                   "inverse_dynamics, mass_matrix_and_bias, forward_dynamics")
      ->delimiter(',');
  command
      ->add_option("--states", bench.states,
                   "numbers of states that batches are timed over, one after the other (default: 256)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--compiler", bench.compiler,
                      "C++ compiler, with its flags (default: the environment variable CXX, or c++)");
  command->add_flag("--json", bench.json, "as JSON");
  add_compiler_options(command, common);
  command->callback([&] { result = run_bench(common, bench); });

  EvaluateOptions evaluate;
  command =
      add_reader(app, "evaluate",
                 "read states (JSON, one a line, from standard input), print tau, M, c and qdd", common);
  add_functions(command, evaluate.functions,
                "functions whose results are wanted instead, as `generate` writes them");
  command->add_flag("--json", evaluate.json, "as JSON, one object a line");
  add_compiler_options(command, common);
  command->callback([&] { result = run_evaluate(common, evaluate); });

  SimulateOptions simulate;
  command = add_reader(app, "simulate",
                       "let it move: a table of t, q, qd and energy, a page or a scene to watch it", common);
  command->add_option("--duration", simulate.duration, "how long, s")
      ->check(from_zero())
      ->capture_default_str();
  command->add_option("--step", simulate.step, "time step, s")->check(above_zero())->capture_default_str();
  command->add_option("--every", simulate.every, "steps from one row of the table to the next")
      ->check(above_zero())
      ->capture_default_str();
  command
      ->add_option(
          "--integrator", simulate.integrator,
          "rk4, euler (semi-implicit); for forces that are stiff for the step linearly-implicit or implicit "
          "(Euler both), which damp; default: rk4, or implicit where that fails at once")
      ->check(CLI::IsMember(integrator_names()));
  command->add_option("--csv", simulate.csv,
                      "table to write; - is standard output (default without --html and --glb)");
  command->add_option("--html", simulate.html, "page to write: the motion in three dimensions, with plots");
  command->add_option("--glb", simulate.glb, "glTF scene to write (binary), with the motion as an animation");
  command->add_option("--fps", simulate.fps, "frames a second in page and scene")
      ->check(above_zero())
      ->capture_default_str();
  command->add_option("--scene", simulate.scene, "more descriptions to show beside the first")
      ->delimiter(',');
  command->add_option("--q", simulate.start.q, "initial coordinates")->check(any_number())->delimiter(',');
  command->add_option("--qd", simulate.start.qd, "initial speeds")->check(any_number())->delimiter(',');
  command->add_option("--states", simulate.start.states, "initial states, those under `states`")
      ->check(any_number())
      ->delimiter(',');
  command
      ->add_option("--parameter", simulate.start.parameters,
                   "NAME=VALUE: a runtime parameter instead of its default")
      ->delimiter(',');
  command
      ->add_option("--hold", simulate.start.hold, "coordinates to keep while the constraints are satisfied")
      ->delimiter(',');
  command->add_option("--input", common.inputs,
                      "NAME=EXPRESSION: what an input is, of t, coordinates, speeds, frames, outputs, ...");
  command->add_option("--inputs", simulate.inputs,
                      "table of inputs over time to read: t and names, then rows of ascending time (CSV)");
  command->add_flag_callback(
      "--no-assemble", [&simulate] { simulate.start.assemble = false; },
      "fail if the initial state violates the constraints, instead of changing it");
  add_compiler_options(command, common);
  command->callback([&] { result = run_simulate(common, simulate); });

  command = add_reader(app, "check",
                       "test whether the description is right and its equations obey the laws of mechanics",
                       common);
  CheckOptions check;
  command->add_option("--states", check.states, "also measure the error of every function at so many states")
      ->check(CLI::Range(1, 1'000'000));
  add_passes(command, common);
  command->callback([&] { result = run_check(common, check); });

  IdentifyOptions identify;
  command = add_reader(
      app, "identify",
      "tell which masses and inertias of the bodies can be known from forces: the base parameters", common);
  command->add_flag("--json", identify.json, "as JSON");
  command->add_option("--example", identify.example,
                      "folder for a program in Python that identifies a simulated mechanism");
  command->callback([&] { result = run_identify(common, identify); });

  std::string out = "-";
  command =
      app.add_subcommand("import", "make a description of a robot that is given as " + importable_formats());
  command->add_option("file", common.file, importable_formats() + "; - is standard input")->required();
  command->add_option("--out", out, "description to write; - is standard output")->capture_default_str();
  add_importing(command, common.describe, "Options");
  command->callback([&] { result = run_import(common, out); });
  for (CLI::App* each : app.get_subcommands({}))
    each->add_flag("--strict", common.strict, "make warnings errors");
  add_examples(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::string unknown = error.get_exit_code() == 0 ? "" : about_unknown_word(app);
    if (unknown.empty()) return app.exit(error) == 0 ? 0 : 1;
    tell("alembert: error: " + unknown);
    return 1;
  }
  return result;
}

}  // namespace
}  // namespace alembert

namespace {

int fail_to_write() {
  alembert::tell("alembert: error: cannot write to standard output\n");
  return 1;
}

/// Standard streams that are closed become streams that fail: a file opened later would get their numbers,
/// and what is said its text. A reader that has gone must not end the run midway either.
void secure_streams() {
  for (const auto& [stream, access] :
       {std::pair{0, O_WRONLY}, std::pair{1, O_RDONLY}, std::pair{2, O_RDONLY}}) {
    if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", access));
  }
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  secure_streams();
  try {
    const int result = alembert::run(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return result;
    return std::max(result, fail_to_write());
  } catch (const alembert::InputError& error) {
    alembert::tell(std::string(error.what()) + "\n");
    return 1;
  } catch (const std::bad_alloc&) {
    alembert::tell("alembert: error: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return fail_to_write();  // what fmt::print throws then
    alembert::tell(
        fmt::format("alembert: internal error: {}\nPlease report this with the description that led to it.\n",
                    error.what()));
    return 2;
  }
}
