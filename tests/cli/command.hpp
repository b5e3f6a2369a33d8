// Runs the alembert command as a user would: arguments and standard input in, exit code and both outputs out.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace alembert::test {

/// A folder of its own for the running test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("alembert-") + info->test_suite_name() + "-" + info->name() + "-" +
                       std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '-');
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct CommandResult {
  int exit_code;
  std::string out, err;
};

/// How many times as long commands may take: with sanitizers they are slow.
#ifndef ALEMBERT_PATIENCE
#define ALEMBERT_PATIENCE 1
#endif

/// Runs shell words; a command that runs over `seconds` times the patience counts as hung (exit code 124).
inline CommandResult run_command(const TemporaryFolder& folder, const std::string& words,
                                 const std::string& input, int seconds) {
  const std::string in = folder.write("stdin", input), out = folder / "stdout", err = folder / "stderr";
  const std::string command = "timeout " + std::to_string(ALEMBERT_PATIENCE * seconds) + " " + words +
                              " < '" + in + "' > '" + out + "' 2> '" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(out), read_text(err)};
}

/// The command with `arguments`, as shell words.
inline CommandResult alembert(const TemporaryFolder& folder, const std::string& arguments,
                              const std::string& input = "", int seconds = 10) {
  return run_command(folder, ALEMBERT_EXECUTABLE " " + arguments, input, seconds);
}

inline std::string mechanism_file(const std::string& name) {
  return ALEMBERT_SOURCE_DIR "/mechanisms/" + name + ".yaml";
}

}  // namespace alembert::test
