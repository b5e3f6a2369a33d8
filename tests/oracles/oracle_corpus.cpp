// oracle_corpus EXECUTABLE FOLDER...: every robot below the folders: .urdf, imported with a fixed and a floating
// root, MJCF (.xml with the element mujoco), .sdf and .world, .osim. Forces, M, c and their derivatives of a URDF
// are compared with a Newton-Euler that reads the file itself, poses, Jacobians and energies with the Taylor oracle on
// the imported description, which must give the same forces; of the other formats, all functions with the Taylor
// oracle on the imported description. Where M is singular, forward dynamics is left out and the line says so. Prints
// the line of each robot when it is done (with several jobs, in no order) and totals by format; exit 1 if any number
// is wrong or missing, 77 if none of the folders exists.
//
// --functions f,g     those only (default: all that are compared)
// --seconds N         processor time that each command may take (default 120)
// --jobs N            processes (default 1)
// --limit N           robots of at most so many speeds (default: all)
// --root R            fixed, floating or both (default), of URDF
// --format F          urdf, mjcf, sdf or osim (default: all)
// --require-import    what is not imported counts as wrong
// --only SUBSTRING    files whose path has it
// --in-turn           functions besides the dynamics of about every seventh robot only
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "oracles/comparison.hpp"
#include "oracles/reference.hpp"
#include "oracles/urdf/newton_euler.hpp"

namespace {

using namespace alembert::oracles;
namespace fs = std::filesystem;

constexpr int kStates = 3;
/// Of more speeds, second derivatives take the Taylor oracle long: they are compared only where asked for.
constexpr int kFew = 8;
constexpr int kSkipped = 77;  // as CTest is told
/// Of M scaled to a unit diagonal; below it, M is not singular.
constexpr long double kRegular = 1e13L;

struct Options {
  std::string executable;
  std::vector<std::string> folders;
  std::set<std::string> functions;
  int seconds = 120, jobs = 1, limit = 1000000;
  bool require_import = false, in_turn = false;
  std::string only, root = "both", format;
};

/// What alembert reads a file as, or nothing.
std::string format_of(const fs::path& file) {
  const std::string end = file.extension().string();
  if (end == ".urdf" || end == ".osim" || end == ".sdf") return end.substr(1);
  if (end == ".world") return "sdf";
  if (end != ".xml") return "";
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str().find("<mujoco") == std::string::npos ? "" : "mjcf";
}

/// Begins the note of a robot of which forward dynamics has no value.
constexpr const char* kWithoutForward = "without forward dynamics: ";

enum class Outcome { right, wrong, refused, timeout, failed, skipped };
constexpr const char* kOutcomes[] = {"right", "wrong", "refused", "timeout", "failed", "skipped"};

/// One robot with one kind of root.
struct Row {
  std::string file, format;
  bool floating = false;
  Outcome outcome = Outcome::failed;
  std::string note;  ///< why it is not right
  double error = 0;  ///< the worst, of `function`
  std::string function;
  int speeds = 0, operations = -1;  ///< of inverse dynamics
  double seconds = 0;
};

/// Of processor time, in all commands so far.
double children_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

/// Of what was said: the error, not the warnings before it; paths before the message are of no interest.
std::string first_line(const std::string& text) {
  constexpr std::string_view kError = "error: ";
  const std::size_t error = text.find(kError);
  std::string line = error == std::string::npos ? text : text.substr(error + kError.size());
  line = line.substr(0, line.find('\n'));
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

/// Forces and their derivatives by Newton-Euler, the rest by the Taylor oracle. Throws if both oracles do not
/// agree.
std::vector<Reference> references(const UrdfTree& tree, const Description& description,
                                  const std::vector<State>& states, const std::set<std::string>& functions) {
  std::set<std::string> by_taylor = functions;
  by_taylor.erase("inverse_dynamics_derivatives");
  std::vector<Reference> all = taylor_references(description, states, by_taylor);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const DynamicsOf<long double> exact = newton_euler_dynamics<long double>(tree, states[i]);
    const Dynamics plain = newton_euler_dynamics<double>(tree, states[i]);
    const auto agree = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return (a - b).cwiseAbs().maxCoeff() <= kAgreement * b.cwiseAbs().maxCoeff();
    };
    if (!agree(all[i].dynamics.tau.cast<double>(), exact.tau.cast<double>()) ||
        !agree(all[i].dynamics.mass_matrix.cast<double>(), exact.mass_matrix.cast<double>()))
      throw std::runtime_error("the imported description is another robot");
    const auto put = [&](std::map<std::string, Arrays>& into, const Dynamics& from) {
      into["inverse_dynamics"] = {{"tau", from.tau}};
      into["mass_matrix"] = {{"M", from.mass_matrix}};
      into["bias"] = {{"c", from.bias}};
      into["mass_matrix_and_bias"] = {{"M", from.mass_matrix}, {"c", from.bias}};
    };
    put(all[i].exact,
        {exact.tau.cast<double>(), exact.mass_matrix.cast<double>(), exact.bias.cast<double>()});
    put(all[i].plain, plain);
    // Accelerations stay with the imported description, whose angles are rounded to 1e-10: they may follow
    // from small differences of large forces.
    if (functions.count("inverse_dynamics_derivatives") == 0) continue;
    const auto wide = newton_euler_derivatives<long double>(tree, description, states[i]);
    const auto narrow = newton_euler_derivatives<double>(tree, description, states[i]);
    all[i].exact["inverse_dynamics_derivatives"] = {{"tau_q", wide.first}, {"tau_qd", wide.second}};
    all[i].plain["inverse_dynamics_derivatives"] = {{"tau_q", narrow.first}, {"tau_qd", narrow.second}};
  }
  return all;
}

int operations_of(const Options& options, const std::string& file) {
  const Run run = run_alembert(
      options.executable, {"report", file, "--json", "--functions", "inverse_dynamics"}, "", options.seconds);
  if (run.status != 0) return -1;
  const auto counts = nlohmann::json::parse(run.out).at("functions").at("inverse_dynamics");
  int sum = 0;
  for (const char* kind : {"mul", "add", "div", "trig", "other"}) sum += counts.at(kind).get<int>();
  return sum;
}

/// Whether an answer failed because M is singular, as it is: joints that move no mass.
bool singular(const std::vector<Comparison>& lines, const std::vector<Reference>& expected) {
  return lines[0].function == "all" && lines[0].note.find(": exit 1") != std::string::npos &&
         std::any_of(expected.begin(), expected.end(), [](const Reference& state) {
           return scaled_condition(state.dynamics.mass_matrix) >= kRegular;
         });
}

void compare_robot(const Options& options, const fs::path& description_file, Row& row) {
  std::vector<std::string> words = {"import", row.file, "--out", description_file.string()};
  // Collections keep meshes and parts of robots anywhere.
  for (const std::string& folder : options.folders) words.insert(words.end(), {"--include", folder});
  if (row.format == "urdf") words.insert(words.end(), {"--root", row.floating ? "floating" : "fixed"});
  const Run import = run_alembert(options.executable, words, "", options.seconds);
  row.seconds = import.seconds;
  if (import.status != 0) {
    row.outcome = import.timed_out     ? Outcome::timeout
                  : import.status == 1 ? Outcome::refused
                                       : Outcome::failed;
    row.note = first_line(import.err);
    return;
  }
  const Description description = read_description(description_file.string());
  row.speeds = description.nv;
  if (description.nv > options.limit) {
    row.outcome = Outcome::skipped;
    return;
  }
  std::optional<UrdfTree> tree;
  if (row.format == "urdf") {
    tree = read_urdf_tree(row.file, row.floating);
    if (speeds_of(*tree) != description.nv)
      throw std::runtime_error("the imported description has other coordinates");
  }
  std::mt19937_64 random(7);
  std::vector<State> states;
  for (int i = 0; i < kStates; ++i) states.push_back(random_state(description, random));
  std::set<std::string> functions =
      options.functions.empty() ? comparable_functions(description) : options.functions;
  if (options.functions.empty() && description.nv > kFew)
    functions.erase("inverse_dynamics_second_derivatives");
  if (options.in_turn) {
    const std::string file = fs::path(row.file).filename().string();
    functions =
        functions_in_turn(functions, std::accumulate(file.begin(), file.end(), row.floating ? 1u : 0u));
  }
  const std::vector<Reference> expected = tree ? references(*tree, description, states, functions)
                                               : taylor_references(description, states, functions);
  const auto before = children_seconds();
  const auto compare = [&] {
    return compare_functions(options.executable, description_file.string(), description.name, states,
                             expected, functions, options.seconds);
  };
  std::vector<Comparison> lines = compare();
  const auto without_solved = [&] {
    std::size_t gone = 0;
    for (const char* name : {"forward_dynamics", "mass_matrix_inverse", "forward_dynamics_derivatives"})
      gone += functions.erase(name);
    return gone != 0 && !functions.empty();
  };
  if (singular(lines, expected) && without_solved()) {
    row.note = kWithoutForward + first_line(lines[0].note);
    lines = compare();
  }
  row.seconds += children_seconds() - before;
  row.outcome = Outcome::right;
  double worst = -1;
  std::string wrong;
  for (const Comparison& line : lines) {
    if (line.function == "all") {
      const bool bad = line.note.find(": exit 1") != std::string::npos;
      row.outcome = line.note.find(": more than") != std::string::npos ? Outcome::timeout
                    : !bad                                             ? Outcome::failed
                    : singular(lines, expected)                        ? Outcome::refused
                                                                       : Outcome::wrong;
      row.note = first_line(line.note);
      return;
    }
    if (line.verdict == Comparison::Verdict::fail) {
      row.outcome = Outcome::wrong;
      wrong += " " + line.function;
    }
    if (line.error / line.tolerance <= worst) continue;
    worst = line.error / line.tolerance;
    row.error = line.error;
    row.function = line.function;
  }
  if (!wrong.empty()) row.note = "wrong:" + wrong + (row.note.empty() ? "" : "; " + row.note);
  row.operations = operations_of(options, description_file.string());
}

/// In one write, which others do not come between.
void print_row(int to, const Row& row) {
  char numbers[96];
  std::snprintf(numbers, sizeof numbers, "\t%d\t%d\t%.1e\t", row.speeds, row.operations, row.error);
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "\t%.1f\t", row.seconds);
  const std::string root = row.format != "urdf" ? "" : row.floating ? ", floating" : ", fixed";
  const std::string head = row.file + "\t" + row.format + root + "\t" +
                           kOutcomes[static_cast<std::size_t>(row.outcome)] + numbers + row.function +
                           seconds;
  const std::string line = (head + row.note).substr(0, PIPE_BUF - 1) + "\n";
  if (write(to, line.data(), line.size()) < 0) _exit(1);
}

/// Every jobs-th file from `first`.
void work(const Options& options, const std::vector<std::string>& files, int first, int to) {
  const fs::path description =
      fs::temp_directory_path() / ("alembert_corpus_" + std::to_string(getpid()) + ".yaml");
  for (std::size_t i = static_cast<std::size_t>(first); i < files.size();
       i += static_cast<std::size_t>(options.jobs)) {
    const std::string format = format_of(files[i]);
    for (const bool floating : {false, true}) {
      if (format == "urdf" ? options.root == (floating ? "fixed" : "floating") : floating) continue;
      Row row;
      row.file = files[i];
      row.format = format;
      row.floating = floating;
      try {
        compare_robot(options, description, row);
      } catch (const std::exception& failure) {
        row.outcome = Outcome::failed;
        row.note = first_line(failure.what());
      }
      print_row(to, row);
    }
  }
  fs::remove(description);
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&]() -> std::string { return ++i < argc ? argv[i] : ""; };
    if (word == "--functions") {
      options.functions = names_in(value());
    } else if (word == "--seconds") {
      options.seconds = std::atoi(value().c_str());
    } else if (word == "--jobs") {
      options.jobs = std::max(1, std::atoi(value().c_str()));
    } else if (word == "--limit") {
      options.limit = std::atoi(value().c_str());
    } else if (word == "--only") {
      options.only = value();
    } else if (word == "--root") {
      options.root = value();
    } else if (word == "--format") {
      options.format = value();
    } else if (word == "--require-import") {
      options.require_import = true;
    } else if (word == "--in-turn") {
      options.in_turn = true;
    } else if (options.executable.empty()) {
      options.executable = word;
    } else {
      options.folders.push_back(word);
    }
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  if (options.folders.empty()) {
    std::fprintf(
        stderr,
        "usage: oracle_corpus EXECUTABLE FOLDER... [--functions f,g] [--seconds N] [--jobs N] [--limit N] "
        "[--only SUBSTRING] [--root R] [--format F] [--require-import] [--in-turn]\n");
    return 2;
  }
  std::vector<std::string> files;
  bool any = false;
  for (const std::string& folder : options.folders) {
    if (!fs::is_directory(folder)) continue;
    any = true;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string path = entry.path().string();
      if (!entry.is_regular_file() || path.find(options.only) == std::string::npos) continue;
      const std::string format = format_of(entry.path());
      if (!format.empty() && (options.format.empty() || options.format == format)) files.push_back(path);
    }
  }
  if (!any) return kSkipped;
  std::sort(files.begin(), files.end());
  std::printf("file\tformat\toutcome\tspeeds\toperations\tworst error\tof\tseconds\tnote\n");
  std::fflush(stdout);
  int rows[2];
  if (pipe(rows) != 0) return 2;
  std::vector<pid_t> children;
  for (int job = 0; job < options.jobs; ++job) {
    const pid_t child = fork();
    if (child == 0) {
      close(rows[0]);
      work(options, files, job, rows[1]);
      _exit(0);
    }
    children.push_back(child);
  }
  close(rows[1]);
  bool failed = files.empty();
  std::map<std::string, std::map<std::string, int>> totals;  ///< by format
  int without_forward = 0;
  std::FILE* const lines = fdopen(rows[0], "r");
  for (char line[PIPE_BUF + 1]; std::fgets(line, sizeof line, lines) != nullptr;) {
    std::fputs(line, stdout);
    std::fflush(stdout);
    std::istringstream columns(line);
    std::string file, format, outcome;
    std::getline(std::getline(std::getline(columns, file, '\t'), format, '\t'), outcome, '\t');
    ++totals[format][outcome];
    if (outcome == "right" && std::strstr(line, kWithoutForward) != nullptr) ++without_forward;
    failed = failed ||
             (outcome != "right" && outcome != "skipped" && (outcome != "refused" || options.require_import));
  }
  std::fclose(lines);
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    failed = failed || status != 0;
  }
  for (const auto& [format, outcomes] : totals) {
    std::printf("%s:", format.c_str());
    for (const auto& [outcome, count] : outcomes) std::printf(" %d %s", count, outcome.c_str());
    std::printf("\n");
  }
  std::printf("%zu robots", files.size());
  if (without_forward > 0) std::printf(" (%d right without forward dynamics)", without_forward);
  std::printf(": %s\n", failed ? "FAIL" : "PASS");
  return failed ? 1 : 0;
}
