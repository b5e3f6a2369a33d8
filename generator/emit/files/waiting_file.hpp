// One file, whole or not at all. In: a path and a text, or pieces of one. Out: the file with all of it; until
// then, and after a failure, the file from before.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace alembert {

/// True if there is nothing or a regular file. Devices, pipes and links are not replaced but written as they
/// stand.
bool is_replaceable(const std::filesystem::path& path);
/// Throws InputError if two files that a run is to write, or one and a file that it reads, are the same.
/// Names are those of the options.
struct NamedFile {
  std::string name;
  std::string path;
};
void check_distinct(std::span<const NamedFile> written, std::span<const NamedFile> read);
/// Where a file's new text waits to be moved into place: PATH.alembert-new.
std::filesystem::path waiting_path(const std::filesystem::path& path);
/// Writes a new file and makes sure that the system took it; errno of what failed, or 0.
int create_file(const std::filesystem::path& path, std::string_view text);
/// What an errno means.
std::string reason_of(int error);
/// An InputError at PATH:1:1.
[[noreturn]] void fail_at_path(const std::string& path, const std::string& message);
/// The same: `cannot write it: No space left on device`.
[[noreturn]] void fail_to_write_file(const std::string& path, int error);

/// A file that is being written. Its text waits beside it, where the next run to write the same file clears
/// up if this one is killed; two runs wait for each other. All members throw InputError at PATH:1:1.
class WaitingFile {
 public:
  explicit WaitingFile(std::string path);
  /// Leaves the file from before, unless the text was published.
  ~WaitingFile();
  WaitingFile(const WaitingFile&) = delete;
  WaitingFile& operator=(const WaitingFile&) = delete;

  void put(std::string_view text);
  /// Moves the text into place. To be called at the end.
  void publish();

 private:
  struct CloseStream {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };

  void open();

  std::string path_;
  std::string waiting_;  ///< empty if the file is written as it stands
  std::unique_ptr<std::FILE, CloseStream> stream_;
};

}  // namespace alembert
