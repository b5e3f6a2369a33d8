// Temporary folders and programs (see the header).
#include "commands/work_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace alembert {
namespace {

// For the handler: the signal that came, and the program that runs.
volatile std::sig_atomic_t asked_by = 0;
volatile std::sig_atomic_t running = 0;

/// Programs run in a group of their own, with what they start.
void end_running(int signal) {
  if (running > 0) ::kill(-static_cast<pid_t>(running), signal);
}

extern "C" void note_signal(int signal) {
  const int error = errno;
  asked_by = signal;
  end_running(signal);
  errno = error;
}

std::string read_all(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Starts a program with its output in files; an error number if that fails.
int start(std::vector<char*> words, const std::string& out, const std::string& errors, pid_t& child) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t ignored;
  sigemptyset(&ignored);
  sigaddset(&ignored, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &ignored);
  words.push_back(nullptr);
  const int error = posix_spawnp(&child, words[0], &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

WorkFolder::WorkFolder(std::string_view purpose)
    : path_((std::filesystem::temp_directory_path() / fmt::format("alembert_{}_XXXXXX", purpose)).string()) {
  if (::mkdtemp(path_.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "no folder " + path_);
  struct sigaction noting = {};
  noting.sa_handler = note_signal;
  asked_by = 0;
  for (std::size_t i = 0; i < std::size(kSignals); ++i) {
    ::sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &noting, nullptr);
  }
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  for (std::size_t i = 0; i < std::size(kSignals); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
  if (asked_by != 0) ::raise(asked_by);
}

std::string WorkFolder::operator/(std::string_view name) const {
  return fmt::format("{}/{}", path_, name);
}

void WorkFolder::write(const EmittedFile& file) const {
  const std::filesystem::path path = *this / file.path;
  std::filesystem::create_directories(path.parent_path());
  if (!(std::ofstream(path, std::ios::binary) << file.text << std::flush))
    throw std::runtime_error("cannot write " + path.string());
}

ProgramRun WorkFolder::run(const std::vector<std::string>& words) const {
  const std::string out = *this / "stdout", errors = *this / "stderr";
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  pid_t child = 0;
  if (const int error = start(arguments, out, errors, child); error != 0)
    return {127, "", fmt::format("{}: {}", words.front(), std::strerror(error))};
  running = child;
  if (asked_by != 0) end_running(asked_by);  // it came just before
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  running = 0;
  if (asked_by != 0) throw std::runtime_error("interrupted");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_all(out), read_all(errors)};
}

}  // namespace alembert
