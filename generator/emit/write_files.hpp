// The one writer of files. In: texts in memory and a folder. Out: the folder holds exactly these texts, and a
// file whose text was already right has not been touched; or an error, and nothing has changed.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emit/emit.hpp"

namespace alembert {

enum class WriteMode {
  write,
  dry_run,  ///< say what would be done
};

enum class FileState {
  created,
  changed,
  unchanged,
  removed,  ///< left from an earlier run with more parts
};

struct WrittenFile {
  std::string path;  ///< relative to the folder
  FileState state;
};

/// Brings a folder up to date, making it if it does not exist. Every file is written beside its place first
/// and then moved there. Parts of the same mechanism from an earlier run with more of them are removed, if
/// they bear the banner.
///
/// With WriteMode::dry_run nothing is touched and the result says what would be: `check` in a build is a dry
/// run whose result must be all unchanged.
///
/// Throws InputError at DIRECTORY:1:1 if something cannot be read or written; what was there before is there
/// again then.
std::vector<WrittenFile> write_files(std::span<const EmittedFile> files, const std::string& directory,
                                     WriteMode mode = WriteMode::write);

/// True if no file is or would be touched.
bool up_to_date(std::span<const WrittenFile> files);

/// A rule of make: `target: dependency ...`, with blanks, `#`, `$` and backslashes escaped. A line break in a
/// path is an InputError.
std::string depfile_text(const std::string& target, std::span<const std::string> dependencies);

/// Writes one file that belongs to no mechanism, such as a depfile or a stamp, whatever was in it. Throws
/// InputError at PATH:1:1.
void write_file(const std::string& path, const std::string& text);

}  // namespace alembert
