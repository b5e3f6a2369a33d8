// Runs the executable with its streams in temporary files (see the header).
#include "oracles/alembert_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

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
  for (std::size_t i = 0; i < values.size(); ++i) v[static_cast<Eigen::Index>(i)] = values[i].get<double>();
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
  if (!state.wrenches.empty()) line["wrenches"] = state.wrenches;
  if (!state.parameters.empty()) line["parameters"] = state.parameters;
  return line;
}

/// What the executable answers to lines, one to each; `arguments` follow `evaluate FILE --json`.
std::vector<nlohmann::json> answers_to(const std::vector<nlohmann::json>& lines,
                                       const std::string& executable, const std::string& file,
                                       const std::string& option, const std::string& value) {
  const TemporaryFolder folder;
  {
    std::ofstream input(folder.path / "in");
    for (const nlohmann::json& line : lines) input << line.dump() << '\n';
  }
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    redirect(folder.path / "in", O_RDONLY, STDIN_FILENO);
    redirect(folder.path / "out", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(folder.path / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
    execl(executable.c_str(), executable.c_str(), "evaluate", file.c_str(), "--json", option.c_str(),
          value.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string how = WIFSIGNALED(status) ? "killed by signal " + std::to_string(WTERMSIG(status))
                                                : "exit " + std::to_string(WEXITSTATUS(status));
    throw std::runtime_error("alembert evaluate " + file + ": " + how + ": " + contents(folder.path / "err"));
  }
  std::vector<nlohmann::json> answers;
  std::ifstream output(folder.path / "out");
  for (std::string text; std::getline(output, text);) answers.push_back(nlohmann::json::parse(text));
  if (answers.size() != lines.size()) {
    throw std::runtime_error("alembert evaluate " + file + " answered " + std::to_string(answers.size()) +
                             " of " + std::to_string(lines.size()) +
                             " states: " + contents(folder.path / "err"));
  }
  return answers;
}

}  // namespace

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

std::vector<std::map<std::string, Arrays>> ask_functions(const std::string& executable,
                                                         const std::string& file,
                                                         const std::vector<State>& states,
                                                         const std::vector<Eigen::VectorXd>& tau,
                                                         const std::vector<std::string>& functions) {
  std::vector<nlohmann::json> lines;
  for (std::size_t i = 0; i < states.size(); ++i) {
    lines.push_back(json_state(states[i]));
    lines.back()["tau"] = std::vector<double>(tau[i].begin(), tau[i].end());
  }
  std::string names;
  for (const std::string& function : functions) names += (names.empty() ? "" : ",") + function;
  std::vector<std::map<std::string, Arrays>> answers;
  for (const nlohmann::json& line : answers_to(lines, executable, file, "--functions", names)) {
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
