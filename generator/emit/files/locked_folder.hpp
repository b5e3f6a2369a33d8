// Changes many files as one. In: a folder and the texts that files in it and elsewhere are to have. Out: all
// of them, or those from before, whenever the process dies: what a killed run has begun, the next one
// completes or takes back.
//
// A journal in the folder tells what is under way. Its name is the state: `.alembert-pending` while new texts
// are written beside their places (FILE.alembert-new) and old ones kept (FILE.alembert-old),
// `.alembert-commit` once all of that is there and the files are moved into place, `.alembert-undo` if that
// fails and the old ones are moved back. Renaming the journal is the moment at which the change happens.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alembert {

/// What becomes of one file.
struct FileEdit {
  std::filesystem::path path;       ///< relative to the folder, or absolute
  std::optional<std::string> text;  ///< none: the file is removed
  bool in_place = false;  ///< written as it stands, before anything is moved: a device, a pipe, a link
};

/// A folder that no other run of alembert reads or changes as long as this lives. Where the file system locks
/// no folders (NFS) nothing is locked.
class LockedFolder {
 public:
  enum class Access {
    read,   ///< together with other readers; a folder that does not exist is not made
    write,  ///< alone; made if it does not exist, and what a killed run left is cleared up
  };
  /// Throws InputError at DIRECTORY:1:1.
  LockedFolder(std::string directory, Access access);
  ~LockedFolder();
  LockedFolder(const LockedFolder&) = delete;
  LockedFolder& operator=(const LockedFolder&) = delete;

  /// Makes all edits, with the folders that they need below this one, or throws InputError and has made none.
  void apply(std::span<const FileEdit> edits);
  /// The journal of a run that was killed midway, if there is one: files may be of two runs then.
  std::optional<std::string> unfinished() const;

 private:
  struct Step;

  void lock(Access access);
  bool make_root(const std::filesystem::path& path);
  void clear_up();
  std::vector<Step> plan(std::span<const FileEdit> edits) const;
  std::vector<Step> read_journal(const std::string& name) const;
  void write_journal(std::span<const Step> steps) const;
  void prepare(std::span<const FileEdit> edits, std::span<const Step> steps) const;
  void finish(std::span<const Step> steps) const;
  void undo(std::span<const Step> steps, const std::string& name) const noexcept;
  void release();
  std::filesystem::path journal(const std::string& name) const { return root_ / name; }

  std::string directory_;
  std::filesystem::path root_;
  int descriptor_ = -1;
  std::vector<std::filesystem::path> made_;  // folders down to this one
};

}  // namespace alembert
