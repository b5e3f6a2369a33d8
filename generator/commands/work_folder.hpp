// A temporary folder and the programs that run in it. In: words of a command. Out: what it printed and how it
// ended. No shell reads the words.
#pragma once

#include <csignal>
#include <string>
#include <string_view>
#include <vector>

#include "emit/emit.hpp"

namespace alembert {

/// How a program ended.
struct ProgramRun {
  int exit_code = 0;  ///< 128 and the signal's number if one ended it; 127 if it could not be started
  std::string out, errors;
};

/// A folder of its own, removed at the end: also after an error, and if the process is asked to end (INT, TERM, HUP).
/// Then the program that runs is asked too, and the process ends by the signal. One at a time.
class WorkFolder {
 public:
  explicit WorkFolder(std::string_view purpose);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  std::string operator/(std::string_view name) const;

  /// Makes the file, and the folders that lead to it.
  void write(const EmittedFile& file) const;

  /// Runs a program, found along PATH, with its arguments; standard input is empty.
  ProgramRun run(const std::vector<std::string>& words) const;

 private:
  static constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
  std::string path_;
  struct sigaction before_[3];
};

}  // namespace alembert
