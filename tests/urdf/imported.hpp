// A robot's file in another format in; its description and what is told about it out, as `import` has them.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "golden/golden_file.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/common/yaml.hpp"
#include "import/importers.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"

namespace alembert::test {

struct Imported {
  std::string text;
  std::vector<std::string> warnings;
};

inline Imported import(std::shared_ptr<const SourceText> source, const DescribeOptions& options = {}) {
  Warnings warnings;
  const DescribedRobot described = describe_source(source, options, warnings);
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(described.document, graph);
  warnings.insert(warnings.end(), described.warnings.begin(), described.warnings.end());
  warnings.insert(warnings.end(), mechanism.warnings.begin(), mechanism.warnings.end());
  Imported out{yaml_text(described.document.root()), {}};
  for (const Warning& w : one_of_each_kind(warnings))
    out.warnings.push_back(warning_text(w.where, w.message, w.note));
  return out;
}

inline std::string warnings_of(const Imported& imported, const std::filesystem::path& file) {
  std::string text;
  for (const std::string& warning : imported.warnings) text += without_folder(warning, file) + "\n";
  return text;
}

/// A folder with links that lead out of it: out.txt to a file, model to a folder with a model.sdf, and within to a folder
/// in it, from which `..` leads elsewhere.
class FolderWithLinks {
 public:
  FolderWithLinks(const std::string& name, const std::string& text)
      : root_(std::filesystem::temp_directory_path() /
              ("alembert_links_" + name + std::to_string(getpid()))) {
    namespace fs = std::filesystem;
    fs::create_directories(root_ / "inside/deep/deeper");
    fs::create_directories(root_ / "outside");
    for (const char* file : {"outside/secret.txt", "outside/model.sdf", "inside/deep/out.txt"})
      std::ofstream(root_ / file) << text;
    fs::create_symlink(root_ / "outside/secret.txt", root_ / "inside/out.txt");
    fs::create_directory_symlink(root_ / "inside/deep/deeper", root_ / "inside/within");
    fs::create_directories(root_ / "inside/model");
    fs::create_symlink(root_ / "outside/model.sdf", root_ / "inside/model/model.sdf");
  }
  ~FolderWithLinks() { std::filesystem::remove_all(root_); }
  FolderWithLinks(const FolderWithLinks&) = delete;
  FolderWithLinks& operator=(const FolderWithLinks&) = delete;
  /// Of the folder, whether it is there or not.
  std::string file(const char* name) const { return (root_ / "inside" / name).string(); }

 private:
  std::filesystem::path root_;
};

/// Whether both trees have the same kinds and texts.
inline bool same(const YamlNode& a, const YamlNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(*a.items[i], *b.items[i])) return false;
  return true;
}

/// A file becomes the description beside it, with the warnings beside it, and is read back from its text.
inline void expect_description_beside(const std::filesystem::path& file) {
  const auto source = read_source(file);
  const Imported imported = import(source);
  expect_golden(imported.text, std::filesystem::path(file).replace_extension(".yaml"));
  expect_golden(warnings_of(imported, file), std::filesystem::path(file).replace_extension(".err"));
  Warnings warnings;
  const DescribedRobot described = describe_source(source, {}, warnings);
  const Document again(std::make_shared<const SourceText>(SourceText{"again", imported.text}));
  EXPECT_TRUE(same(described.document.root(), again.root()));
}

/// A text with each number behind an @, a length, times a factor, and each behind @@, an inertia, times its square.
inline std::string with_lengths(const std::string& text, double factor) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    double by = 1;
    for (; text[at] == '@'; ++at) by *= factor;
    if (at == 0 || text[at - 1] != '@') {
      out += text[at];
      continue;
    }
    std::size_t digits = 0;
    out += number_text(std::stod(text.substr(at), &digits) * by);
    at += digits - 1;
  }
  return out;
}

inline std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    for (char& c : line)
      if (std::string_view("[],(){}").find(c) != std::string_view::npos) c = ' ';
    std::istringstream words(line);
    for (std::string word; words >> word;) out.push_back(word);
  }
  return out;
}

/// A robot a trillion times as small has the same description but for lengths, and inertias, which are as many times
/// smaller, to the last digit: nothing is judged by metres.
/// \param text  as with_lengths takes it
inline void expect_the_same_however_small(const std::string& name, const std::string& text) {
  const auto words = [&](double factor) {
    return words_of(
        import(std::make_shared<const SourceText>(SourceText{name, with_lengths(text, factor)})).text);
  };
  const double factor = std::ldexp(1, -40);
  const std::vector<std::string> large = words(1), small = words(factor);
  ASSERT_EQ(large.size(), small.size()) << testing::PrintToString(large) << testing::PrintToString(small);
  for (std::size_t i = 0; i < large.size(); ++i) {
    if (large[i] == small[i]) continue;
    double a = 0, b = 0;
    ASSERT_NO_THROW(a = std::stod(large[i])) << large[i] << " and " << small[i];
    ASSERT_NO_THROW(b = std::stod(small[i])) << large[i] << " and " << small[i];
    EXPECT_TRUE(b == a * factor || b == a * factor * factor) << large[i] << " and " << small[i];
  }
}

/// A file is read with the warnings beside it.
inline void expect_warnings_beside(const std::filesystem::path& file) {
  const std::string warnings = warnings_of(import(read_source(file)), file);
  EXPECT_NE(warnings, "");
  expect_golden(warnings, std::filesystem::path(file).replace_extension(".err"));
}

/// A file is refused with the message beside it, at a place in it or in a file of its kind that it includes.
inline void expect_refusal_beside(const std::filesystem::path& file) {
  try {
    import(read_source(file));
    FAIL() << "is read without an error";
  } catch (const InputError& error) {
    const std::string found = without_folder(error.what(), file) + "\n";
    EXPECT_NE(found.find(file.extension().string() + ":"), std::string::npos) << found;
    expect_golden(found, std::filesystem::path(file).replace_extension(".err"));
  }
}

}  // namespace alembert::test
