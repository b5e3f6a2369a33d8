// A robot's file in another format in; its description and what is told about it out, as `import` has them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "golden/golden_file.hpp"
#include "import/common/yaml.hpp"
#include "import/importers.hpp"
#include "mechanism/load.hpp"

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

/// Whether both trees have the same kinds and texts.
inline bool same(const YamlNode& a, const YamlNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(*a.items[i], *b.items[i])) return false;
  return true;
}

}  // namespace alembert::test
