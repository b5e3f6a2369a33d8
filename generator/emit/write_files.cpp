// Writes files so that a failure changes nothing.
#include "emit/write_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>

#include "support/error.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& place, const std::string& message) {
  SourceLocation where;
  where.source = std::make_shared<const SourceText>(SourceText{place, ""});
  throw InputError(where, message);
}

std::string reason(int error) {
  return std::generic_category().message(error);
}

/// Writes a new file and makes sure that the disk took it; errno of what failed, or 0.
int create_file(const fs::path& path, const std::string& text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  std::size_t done = 0;
  int error = 0;
  while (done < text.size() && error == 0) {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
  }
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// Text of a file; nothing if there is no file.
std::optional<std::string> current_text(const fs::path& path, const std::string& directory) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (status.type() != fs::file_type::regular)
    fail(directory, fmt::format("cannot write {}: it is no regular file", path.string()));
  std::ifstream stream(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad())
    fail(directory, fmt::format("cannot read {}: {}", path.string(), reason(errno)));
  return text;
}

/// What has been done, to be undone unless it is kept.
class Transaction {
 public:
  explicit Transaction(std::string directory) : directory_(std::move(directory)) {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!kept_) undo();
  }

  void make_folder(const fs::path& path) {
    std::error_code error;
    if (path.empty() || fs::is_directory(path, error)) return;
    make_folder(path.parent_path());
    if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST)
      fail(directory_, "cannot make the folder: " + reason(errno));
    if (!fs::is_directory(path, error)) fail(directory_, fmt::format("{} is no folder", path.string()));
    folders_.push_back(path);
  }

  void prepare(const fs::path& path, const std::string& text) {
    const fs::path waiting = path.string() + fmt::format(".{}.new", ::getpid());
    moves_.push_back({waiting, path, std::nullopt, false});
    if (const int error = create_file(waiting, text); error != 0)
      fail(directory_, fmt::format("cannot write {}: {}", path.string(), reason(error)));
  }

  /// Moves what was prepared into place.
  void move_all() {
    for (Move& move : moves_) {
      set_aside(move);
      if (std::rename(move.from.c_str(), move.to.c_str()) != 0)
        fail(directory_, fmt::format("cannot write {}: {}", move.to.string(), reason(errno)));
      move.done = true;
    }
  }

  void remove(const fs::path& path) {
    moves_.push_back({{}, path, std::nullopt, false});
    set_aside(moves_.back());
    moves_.back().done = true;
  }

  void keep() {
    kept_ = true;
    for (const Move& move : moves_)
      if (move.aside) ::unlink(move.aside->c_str());
  }

 private:
  struct Move {
    fs::path from, to;              ///< no `from`: the file is removed
    std::optional<fs::path> aside;  ///< where the old file waits
    bool done;
  };

  void set_aside(Move& move) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(move.to, error))) return;
    const fs::path aside = move.to.string() + fmt::format(".{}.old", ::getpid());
    if (std::rename(move.to.c_str(), aside.c_str()) != 0)
      fail(directory_, fmt::format("cannot replace {}: {}", move.to.string(), reason(errno)));
    move.aside = aside;
  }

  void undo() noexcept {
    std::ranges::reverse(moves_);
    for (const Move& move : moves_) {
      if (!move.from.empty()) ::unlink(move.done ? move.to.c_str() : move.from.c_str());
      if (move.aside) std::rename(move.aside->c_str(), move.to.c_str());
    }
    std::ranges::reverse(folders_);
    for (const fs::path& folder : folders_) ::rmdir(folder.c_str());
  }

  std::string directory_;
  std::vector<Move> moves_;
  std::vector<fs::path> folders_;
  bool kept_ = false;
};

/// `include/arm/arm_part7.hpp` of `include/arm/arm_part1.hpp`: the same path with another number; empty if it
/// has none.
std::string sibling_part(const std::string& path, int part) {
  const std::size_t at = path.rfind("_part1.");
  if (at == std::string::npos) return {};
  return path.substr(0, at) + fmt::format("_part{}", part) + path.substr(at + 6);
}

/// Parts that this set does not have but a run with more parts would have left.
std::vector<std::string> left_over_parts(std::span<const EmittedFile> files, const fs::path& root) {
  std::vector<std::string> out;
  for (const EmittedFile& first : files)
    for (int part = 2; part <= kMaxParts && !sibling_part(first.path, 1).empty(); ++part) {
      const std::string path = sibling_part(first.path, part);
      if (std::ranges::find(files, path, &EmittedFile::path) != files.end()) continue;
      std::ifstream stream(root / path, std::ios::binary);
      std::string banner, own = first.text.substr(0, first.text.find('\n'));
      if (stream && std::getline(stream, banner) && banner == own) out.push_back(path);
    }
  return out;
}

}  // namespace

std::vector<WrittenFile> write_files(std::span<const EmittedFile> files, const std::string& directory,
                                     WriteMode mode) {
  const fs::path root = directory.empty() ? "." : directory;
  std::vector<WrittenFile> result;
  for (const EmittedFile& file : files) {
    const std::optional<std::string> old = current_text(root / file.path, directory);
    result.push_back({file.path, !old                ? FileState::created
                                 : *old == file.text ? FileState::unchanged
                                                     : FileState::changed});
  }
  const std::vector<std::string> left_over = left_over_parts(files, root);
  if (mode == WriteMode::write) {
    Transaction transaction(directory);
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (result[i].state == FileState::unchanged) continue;
      const fs::path path = root / files[i].path;
      transaction.make_folder(path.parent_path());
      transaction.prepare(path, files[i].text);
    }
    transaction.move_all();
    for (const std::string& path : left_over) transaction.remove(root / path);
    transaction.keep();
  }
  for (const std::string& path : left_over) result.push_back({path, FileState::removed});
  return result;
}

bool up_to_date(std::span<const WrittenFile> files) {
  return std::ranges::all_of(files,
                             [](const WrittenFile& file) { return file.state == FileState::unchanged; });
}

std::string depfile_text(const std::string& target, std::span<const std::string> dependencies) {
  const auto escaped = [](const std::string& path) {
    std::string out;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const char c = path[i];
      if (c == '\n' || c == '\r')
        fail(printable(path), "a path with a line break cannot be written to a depfile");
      if (c == ' ' || c == '#') out += '\\';
      if (c == '$') out += '$';
      out += c;
    }
    return out;
  };
  std::string out = escaped(target) + ":";
  for (const std::string& dependency : dependencies) out += " \\\n  " + escaped(dependency);
  return out + "\n";
}

void write_file(const std::string& path, const std::string& text) {
  if (const int error = create_file(path, text); error != 0) fail(path, "cannot write it: " + reason(error));
}

}  // namespace alembert
