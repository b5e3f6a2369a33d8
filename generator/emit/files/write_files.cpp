// What is to be written where (see the header).
#include "emit/files/write_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>

#include "emit/files/locked_folder.hpp"
#include "emit/files/waiting_file.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

/// Text of a file; nothing if there is no file.
std::optional<std::string> current_text(const fs::path& path, const std::string& directory) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (status.type() != fs::file_type::regular)
    fail_at_path(directory, fmt::format("cannot write {}: it is no regular file", path.string()));
  std::ifstream stream(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad())
    fail_at_path(directory, fmt::format("cannot read {}: {}", path.string(), reason_of(errno)));
  return text;
}

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
                                     WriteMode mode, std::span<const RunFile> run_files) {
  const fs::path root = directory.empty() ? "." : directory;
  const bool writes = mode == WriteMode::write;
  LockedFolder folder(directory, writes ? LockedFolder::Access::write : LockedFolder::Access::read);
  std::vector<WrittenFile> result;
  std::vector<FileEdit> edits;
  for (const EmittedFile& file : files) {
    const std::optional<std::string> old = current_text(root / file.path, directory);
    result.push_back({file.path, !old                ? FileState::created
                                 : *old == file.text ? FileState::unchanged
                                                     : FileState::changed});
    if (result.back().state != FileState::unchanged) edits.push_back({file.path, file.text});
  }
  for (const std::string& path : left_over_parts(files, root)) {
    result.push_back({path, FileState::removed});
    edits.push_back({path, std::nullopt});
  }
  if (const std::optional<std::string> journal = folder.unfinished())
    result.push_back({*journal, FileState::removed});
  if (!writes) return result;
  if (edits.empty()) {
    for (const RunFile& file : run_files) write_file(file.path, file.text);
    return result;
  }
  for (const RunFile& file : run_files)
    edits.push_back({fs::absolute(file.path), file.text, !is_replaceable(file.path)});
  folder.apply(edits);
  return result;
}

bool up_to_date(std::span<const WrittenFile> files) {
  return std::ranges::all_of(files,
                             [](const WrittenFile& file) { return file.state == FileState::unchanged; });
}

std::string depfile_text(const std::string& target, std::span<const std::string> dependencies) {
  const auto escaped = [](const std::string& path) {
    std::string out;
    std::size_t backslashes = 0;  // just before; make halves their number before a blank
    for (const char c : path + ' ') {
      if (c == '\n' || c == '\r')
        fail_at_path(printable(path), "a path with a line break cannot be written to a depfile");
      if (c == ' ' || c == '\t') out.append(backslashes + 1, '\\');
      if (c == '#') out += '\\';
      if (c == '$') out += '$';
      backslashes = c == '\\' ? backslashes + 1 : 0;
      out += c;
    }
    out.resize(out.size() - 2);  // the blank that ends the path, and its backslash
    return out;
  };
  std::string out = escaped(target) + ":";
  for (const std::string& dependency : dependencies) out += " \\\n  " + escaped(dependency);
  return out + "\n";
}

void write_file(const std::string& path, const std::string& text) {
  WaitingFile file(path);
  file.put(text);
  file.publish();
}

}  // namespace alembert
