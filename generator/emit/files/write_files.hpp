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

/// A file that belongs to a run, such as a depfile or a stamp: its time tells that the run was made.
struct RunFile {
  std::string path;
  std::string text;
};

/// Brings a folder up to date, making it if it does not exist, and writes the files of the run, whether or
/// not their texts were right already. Parts of the same mechanism from an earlier run with more of them are
/// removed, if they bear the banner.
///
/// All or none: other runs into the folder wait, and what a killed one left midway is completed or taken back
/// by the next (locked_folder.hpp).
///
/// With WriteMode::dry_run nothing is touched and the result says what would be: `check` in a build is a dry
/// run whose result must be all unchanged. The journal of a killed run counts as a file to be removed.
///
/// Throws InputError at DIRECTORY:1:1, or at the path of a file of the run, if something cannot be read or
/// written; what was there before is there again then.
std::vector<WrittenFile> write_files(std::span<const EmittedFile> files, const std::string& directory,
                                     WriteMode mode = WriteMode::write,
                                     std::span<const RunFile> run_files = {});

/// True if no file is or would be touched.
bool up_to_date(std::span<const WrittenFile> files);

/// A rule of make: `target: dependency ...`, with blanks, `#` and `$` escaped, and backslashes before blanks
/// and at the end of a path. A line break in a path is an InputError.
std::string depfile_text(const std::string& target, std::span<const std::string> dependencies);

/// Writes one file, the whole text or nothing (waiting_file.hpp). Throws InputError at PATH:1:1.
void write_file(const std::string& path, const std::string& text);

}  // namespace alembert
