// The journal and its states (see the header).
#include "emit/files/locked_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "emit/files/waiting_file.hpp"
#include "support/error.hpp"

namespace alembert {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPending = ".alembert-pending";
constexpr const char* kCommit = ".alembert-commit";
constexpr const char* kUndo = ".alembert-undo";

fs::path kept(const fs::path& path) {
  return path.string() + ".alembert-old";
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/// Keeps a file under a second name: a link, or where the file system has none, a copy. errno, or 0.
int keep(const fs::path& path) {
  const fs::path second = kept(path);
  ::unlink(second.c_str());
  if (::link(path.c_str(), second.c_str()) == 0) return 0;
  std::error_code error;
  fs::copy_file(path, second, fs::copy_options::overwrite_existing, error);
  return error.value();
}

}  // namespace

/// A line of the journal.
struct LockedFolder::Step {
  enum class Kind { folder, create, change, remove };
  Kind kind;
  std::string name;  ///< as in the journal: relative to the folder, or absolute
  fs::path path;
  static constexpr const char* kWords[] = {"folder", "create", "change", "remove"};
};

LockedFolder::LockedFolder(std::string directory, Access access)
    : directory_(std::move(directory)), root_(directory_.empty() ? "." : directory_) {
  try {
    lock(access);
    if (access == Access::write) clear_up();
  } catch (...) {
    release();
    throw;
  }
}

LockedFolder::~LockedFolder() {
  release();
}

void LockedFolder::release() {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void LockedFolder::lock(Access access) {
  // Another run that fails may at any moment take away the folders that it made; then this one begins again.
  // The count ends it where a folder can never be made (/proc).
  constexpr int kAttempts = 1000;
  for (int attempt = 1;; ++attempt) {
    const bool made = access == Access::read || make_root(root_);
    descriptor_ = made ? ::open(root_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (descriptor_ < 0 && access == Access::read) return;
    if (descriptor_ < 0 && (errno != ENOENT || attempt == kAttempts))
      fail_at_path(directory_,
                   fmt::format("cannot {} the folder: {}", made ? "open" : "make", reason_of(errno)));
    if (descriptor_ < 0) continue;
    while (::flock(descriptor_, access == Access::write ? LOCK_EX : LOCK_SH) != 0 && errno == EINTR) {
    }
    struct stat mine {
    }, now{};
    if (::fstat(descriptor_, &mine) == 0 && ::stat(root_.c_str(), &now) == 0 && mine.st_ino == now.st_ino &&
        mine.st_dev == now.st_dev)
      return;
    ::close(descriptor_);
    descriptor_ = -1;
  }
}

/// Makes the folder and those above it. \return false, with errno ENOENT, where one of them is gone again.
bool LockedFolder::make_root(const fs::path& path) {
  std::error_code error;
  if (path.empty() || fs::is_directory(path, error)) return true;
  if (!make_root(path.parent_path())) return false;
  if (::mkdir(path.c_str(), 0777) == 0) {
    made_.push_back(path);
    return true;
  }
  if (errno == EEXIST) {
    if (fs::is_directory(path, error)) return true;
    const fs::file_type type = fs::symlink_status(path, error).type();
    if (type != fs::file_type::not_found && type != fs::file_type::directory)
      fail_at_path(directory_, fmt::format("{} is no folder", path.string()));
  } else if (errno != ENOENT) {
    fail_at_path(directory_, "cannot make the folder: " + reason_of(errno));
  }
  errno = ENOENT;
  return false;
}

std::optional<std::string> LockedFolder::unfinished() const {
  for (const char* name : {kCommit, kUndo, kPending})
    if (is_there(journal(name))) return name;
  return std::nullopt;
}

void LockedFolder::clear_up() {
  const std::optional<std::string> name = unfinished();
  if (!name) return;
  const std::vector<Step> steps = read_journal(*name);
  if (*name == kCommit) {
    finish(steps);
  } else {
    undo(steps, *name);
  }
}

std::vector<LockedFolder::Step> LockedFolder::plan(std::span<const FileEdit> edits) const {
  std::vector<Step> steps;
  const auto folder = [&](const auto& self, const fs::path& name) -> void {
    std::error_code error;
    if (name.empty() || fs::is_directory(root_ / name, error) ||
        std::ranges::find(steps, name.string(), &Step::name) != steps.end())
      return;
    self(self, name.parent_path());
    steps.push_back({Step::Kind::folder, name.string(), root_ / name});
  };
  for (const FileEdit& edit : edits) {
    if (edit.in_place) continue;
    const std::string name = edit.path.string();
    if (name.find('\n') != std::string::npos)
      fail_at_path(printable(name), "a path with a line break cannot be written");
    if (edit.text && edit.path.is_relative()) folder(folder, edit.path.parent_path());
    const fs::path path = root_ / edit.path;
    steps.push_back({!edit.text       ? Step::Kind::remove
                     : is_there(path) ? Step::Kind::change
                                      : Step::Kind::create,
                     name, path});
  }
  return steps;
}

std::vector<LockedFolder::Step> LockedFolder::read_journal(const std::string& name) const {
  std::vector<Step> steps;
  std::ifstream stream(journal(name), std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t blank = std::min(line.find(' '), line.size() - 1);
    const auto word = std::ranges::find(Step::kWords, line.substr(0, blank));
    if (word == std::end(Step::kWords)) continue;  // cut short: nothing has happened yet
    const std::string path = line.substr(blank + 1);
    steps.push_back({static_cast<Step::Kind>(word - std::begin(Step::kWords)), path, root_ / path});
  }
  return steps;
}

void LockedFolder::write_journal(std::span<const Step> steps) const {
  std::string text;
  for (const Step& step : steps)
    text += fmt::format("{} {}\n", Step::kWords[static_cast<int>(step.kind)], step.name);
  if (const int error = create_file(journal(kPending), text); error != 0)
    fail_at_path(directory_,
                 fmt::format("cannot write {}: {}", journal(kPending).string(), reason_of(error)));
}

void LockedFolder::prepare(std::span<const FileEdit> edits, std::span<const Step> steps) const {
  const auto fail = [&](const Step& step, int error) {
    if (step.kind != Step::Kind::folder && fs::path(step.name).is_absolute())
      fail_to_write_file(step.name, error);
    fail_at_path(directory_,
                 fmt::format("cannot {} {}: {}", step.kind == Step::Kind::remove ? "remove" : "write",
                             step.path.string(), reason_of(error)));
  };
  for (const Step& step : steps) {
    switch (step.kind) {
      case Step::Kind::folder:
        if (::mkdir(step.path.c_str(), 0777) != 0 && errno != EEXIST) fail(step, errno);
        break;
      case Step::Kind::create:
        break;
      case Step::Kind::change:
      case Step::Kind::remove:
        if (const int error = keep(step.path); error != 0) fail(step, error);
        break;
    }
  }
  for (const FileEdit& edit : edits) {
    if (!edit.text || edit.in_place) continue;
    if (const int error = create_file(waiting_path(root_ / edit.path), *edit.text); error != 0)
      fail(*std::ranges::find(steps, edit.path.string(), &Step::name), error);
  }
  for (const FileEdit& edit : edits) {
    if (!edit.in_place) continue;
    if (const int error = create_file(edit.path, *edit.text); error != 0)
      fail_to_write_file(edit.path.string(), error);
  }
}

/// Moves files into place. May have been begun before.
void LockedFolder::finish(std::span<const Step> steps) const {
  for (const Step& step : steps) {
    const bool moves = step.kind == Step::Kind::create || step.kind == Step::Kind::change;
    const bool failed =
        moves ? is_there(waiting_path(step.path)) &&
                    std::rename(waiting_path(step.path).c_str(), step.path.c_str()) != 0
              : step.kind == Step::Kind::remove && ::unlink(step.path.c_str()) != 0 && errno != ENOENT;
    if (failed)
      fail_at_path(directory_, fmt::format("cannot replace {}: {}", step.path.string(), reason_of(errno)));
  }
  for (const Step& step : steps)
    if (step.kind != Step::Kind::folder) ::unlink(kept(step.path).c_str());
  ::unlink(journal(kCommit).c_str());
}

/// Takes back what was done. May have been begun before.
void LockedFolder::undo(std::span<const Step> steps, const std::string& name) const noexcept {
  const bool moved = name == kUndo;  // else no file has left its place
  for (auto at = steps.rbegin(); at != steps.rend(); ++at) {
    const Step& step = *at;
    switch (step.kind) {
      case Step::Kind::folder:
        ::rmdir(step.path.c_str());
        break;
      case Step::Kind::create:
        if (::unlink(waiting_path(step.path).c_str()) != 0 && moved) ::unlink(step.path.c_str());
        break;
      case Step::Kind::change:
      case Step::Kind::remove:
        if (moved) static_cast<void>(std::rename(kept(step.path).c_str(), step.path.c_str()));
        ::unlink(kept(step.path).c_str());  // which two links to one file both survive
        ::unlink(waiting_path(step.path).c_str());
        break;
    }
  }
  ::unlink(journal(name).c_str());
}

void LockedFolder::apply(std::span<const FileEdit> edits) {
  const std::vector<Step> steps = plan(edits);
  try {
    write_journal(steps);
    prepare(edits, steps);
    if (std::rename(journal(kPending).c_str(), journal(kCommit).c_str()) != 0)
      fail_at_path(directory_, "cannot write into the folder: " + reason_of(errno));
  } catch (...) {
    undo(steps, kPending);
    throw;
  }
  try {
    finish(steps);
  } catch (...) {
    std::rename(journal(kCommit).c_str(), journal(kUndo).c_str());
    undo(steps, kUndo);
    throw;
  }
  made_.clear();
}

}  // namespace alembert
