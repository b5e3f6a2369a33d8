// Runs the executable with its streams in temporary files (see the header).
#include "oracles/alembert_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "oracles/taylor/force_derivatives.hpp"

namespace alembert::oracles {

namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "alembert_oracle_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  fs::path path;
};

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void redirect(const fs::path& path, int flags, int to) {
  const int from = open(path.c_str(), flags, 0600);
  if (from < 0 || dup2(from, to) < 0) _exit(127);
}

Eigen::VectorXd vector_of(const nlohmann::json& values) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)  // null is what has no value
    v[static_cast<Eigen::Index>(i)] =
        values[i].is_null() ? std::numeric_limits<double>::infinity() : values[i].get<double>();
  return v;
}

Eigen::MatrixXd matrix_of(const nlohmann::json& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != columns) throw std::runtime_error("a matrix has rows of different lengths");
    m.row(static_cast<Eigen::Index>(i)) = vector_of(rows[i]).transpose();
  }
  return m;
}

nlohmann::json json_state(const State& state) {
  nlohmann::json line = {{"q", state.q}, {"qd", state.speeds}, {"qdd", state.rates}, {"t", state.time}};
  line["mu"] = force_weights(static_cast<int>(state.rates.size()));
  if (!state.wrenches.empty()) line["wrenches"] = state.wrenches;
  if (!state.parameters.empty()) line["parameters"] = state.parameters;
  if (!state.inputs.empty()) line["inputs"] = state.inputs;
  if (!state.states.empty()) line["states"] = state.states;
  return line;
}

/// What the executable answers to lines, one to each; `arguments` follow `evaluate FILE --json`.
std::vector<nlohmann::json> answers_to(const std::vector<nlohmann::json>& lines,
                                       const std::string& executable, const std::string& file,
                                       const std::string& option, const std::string& value, int seconds = 0) {
  std::string input;
  for (const nlohmann::json& line : lines) input += line.dump() + '\n';
  const Run run = run_alembert(executable, {"evaluate", file, "--json", option, value}, input, seconds);
  const std::string what = "alembert evaluate " + file;
  const auto fail = [&](const std::string& how) { throw NoAnswer(what + how, run); };
  if (run.timed_out) fail(": more than " + std::to_string(seconds) + " s");
  if (run.status < 0) fail(": killed by signal " + std::to_string(-run.status) + ": " + run.err);
  if (run.status > 0) fail(": exit " + std::to_string(run.status) + ": " + run.err);
  std::vector<nlohmann::json> answers;
  std::istringstream output(run.out);
  for (std::string text; std::getline(output, text);) answers.push_back(nlohmann::json::parse(text));
  if (answers.size() != lines.size())
    fail(" answered " + std::to_string(answers.size()) + " of " + std::to_string(lines.size()) +
         " states: " + run.err);
  return answers;
}

}  // namespace

Run run_alembert(const std::string& executable, const std::vector<std::string>& arguments,
                 const std::string& input, int seconds) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "in") << input;
  std::vector<char*> words{const_cast<char*>(executable.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    redirect(folder.path / "in", O_RDONLY, STDIN_FILENO);
    redirect(folder.path / "out", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(folder.path / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
    const auto limit = static_cast<rlim_t>(seconds);
    const rlimit time{limit, limit + 1};
    if (seconds > 0) setrlimit(RLIMIT_CPU, &time);
    execv(executable.c_str(), words.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  Run run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  run.timed_out = seconds > 0 && (run.status == -SIGXCPU || run.status == -SIGKILL);
  run.out = contents(folder.path / "out");
  run.err = contents(folder.path / "err");
  run.seconds = static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
  return run;
}

std::string json_of(const State& state) {
  return json_state(state).dump();
}

std::vector<Answer> ask_alembert(const std::string& executable, const std::string& file,
                                 const std::vector<State>& states, const std::string& formulation) {
  std::vector<nlohmann::json> lines;
  for (const State& state : states) lines.push_back(json_state(state));
  std::vector<Answer> answers;
  for (const nlohmann::json& line : answers_to(lines, executable, file, "--formulation", formulation)) {
    Answer answer;
    answer.dynamics.tau = vector_of(line.at("tau"));
    answer.dynamics.mass_matrix = matrix_of(line.at("M"));
    answer.dynamics.bias = vector_of(line.at("c"));
    if (line.at("qdd").is_null())
      throw std::runtime_error("alembert evaluate " + file +
                               ": no accelerations: " + line.value("status", line.dump()));
    answer.rates = vector_of(line.at("qdd"));
    if (line.contains("P")) {
      answer.rows = {matrix_of(line.at("P")), vector_of(line.at("gamma")), vector_of(line.at("velocity")),
                     vector_of(line.at("position"))};
      answer.multipliers = vector_of(line.at("lambda"));
    }
    answers.push_back(std::move(answer));
  }
  return answers;
}

std::vector<std::map<std::string, Arrays>> ask_functions(
    const std::string& executable, const std::string& file, const std::vector<State>& states,
    const std::vector<Eigen::VectorXd>& tau, const std::vector<std::string>& functions, int seconds) {
  std::vector<nlohmann::json> lines;
  for (std::size_t i = 0; i < states.size(); ++i) {
    lines.push_back(json_state(states[i]));
    lines.back()["tau"] = std::vector<double>(tau[i].begin(), tau[i].end());
  }
  std::string names;
  for (const std::string& function : functions) names += (names.empty() ? "" : ",") + function;
  std::vector<std::map<std::string, Arrays>> answers;
  for (const nlohmann::json& line : answers_to(lines, executable, file, "--functions", names, seconds)) {
    auto& answer = answers.emplace_back();
    for (const auto& [function, arrays] : line.items()) {
      for (const auto& [name, values] : arrays.items()) {
        const bool is_matrix = !values.empty() && values[0].is_array();
        answer[function][name] = is_matrix ? matrix_of(values) : Eigen::MatrixXd(vector_of(values));
      }
    }
  }
  return answers;
}

}  // namespace alembert::oracles
