// One file of a model, with those that it includes: how it is to be read. Settings, default classes and assets
// count in their own file only; a model may attach parts of others.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "import/mjcf/assets.hpp"

namespace alembert {

struct MjcfFile {
  /// Throws InputError where what it says of itself cannot be read.
  MjcfFile(std::shared_ptr<const SourceText> source, std::vector<std::string> folders, Warnings& warnings);
  MjcfFile(const MjcfFile&) = delete;  // its parts know each other's places
  MjcfFile& operator=(const MjcfFile&) = delete;

  MjcfText text;
  MjcfCompiler compiler;
  MjcfDefaults defaults;
  MjcfAssets assets;
};

/// The model's own file, or a part of a file that is attached, and what its names have around them.
struct MjcfPart {
  const MjcfFile* file = nullptr;
  std::string prefix, suffix;
  bool attached = false, whole = false;  ///< whole: not only a body or frame of it

  std::string name(const std::string& own) const { return own.empty() ? own : prefix + own + suffix; }
};

/// The files of a model, each of which is read once, when it is first asked for.
class MjcfFiles {
 public:
  MjcfFiles(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
            Warnings& warnings);

  const MjcfFile& own() const { return own_; }
  /// The file that an asset <model> of another one names. Throws InputError at `of`, an element with the
  /// attribute `model`, if there is none of the name, and where the file cannot be read.
  const MjcfFile& attached(const MjcfFile& to, const MjcfElement& of);
  /// Where in the model's own file the texts stand that it includes or attaches.
  std::map<const SourceText*, SourceLocation> places() const;
  /// All that were read besides the model's own.
  std::vector<std::string> names() const;

 private:
  const MjcfFile& read(const MjcfFile& from, const MjcfElement& asset);

  std::vector<std::string> folders_;
  Warnings& warnings_;
  MjcfFile own_;
  std::map<std::filesystem::path, std::unique_ptr<MjcfFile>> attached_;
  std::map<const SourceText*, SourceLocation> places_;  ///< of attached texts
};

}  // namespace alembert
