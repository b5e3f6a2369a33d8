// YAML by yaml-cpp, which knows what needs quotes.
#include "import/common/yaml.hpp"

#include <yaml-cpp/emitter.h>

#include <cstddef>

namespace alembert {
namespace {

/// Longer lists and mappings are written line by line.
constexpr std::size_t kLine = 140;

bool is_scalar(const YamlNode& node) {
  return node.kind == YamlNode::Kind::scalar || node.kind == YamlNode::Kind::null;
}

/// Lists of scalars, and mappings of two keys or more to scalars and such lists, stand on one line.
bool on_one_line(const YamlNode& node) {
  std::size_t length = 0;
  for (const YamlNode* item : node.items) {
    length += item->text.size() + 2;
    if (is_scalar(*item)) continue;
    if (node.kind == YamlNode::Kind::sequence || item->kind == YamlNode::Kind::mapping) return false;
    for (const YamlNode* inner : item->items) {
      if (!is_scalar(*inner)) return false;
      length += inner->text.size() + 2;
    }
  }
  return length <= kLine && (node.kind == YamlNode::Kind::sequence || node.items.size() > 2);
}

void write(YAML::Emitter& out, const YamlNode& node) {
  const bool flow = on_one_line(node);
  switch (node.kind) {
    case YamlNode::Kind::null:
      out << YAML::Null;
      break;
    case YamlNode::Kind::scalar:
      out << node.text;
      break;
    case YamlNode::Kind::sequence:
      out << (flow ? YAML::Flow : YAML::Block) << YAML::BeginSeq;
      for (const YamlNode* item : node.items) write(out, *item);
      out << YAML::EndSeq;
      break;
    case YamlNode::Kind::mapping:
      out << (flow ? YAML::Flow : YAML::Block) << YAML::BeginMap;
      for (std::size_t i = 0; i + 1 < node.items.size(); i += 2) {
        out << YAML::Key << node.items[i]->text << YAML::Value;
        write(out, *node.items[i + 1]);
      }
      out << YAML::EndMap;
      break;
  }
}

}  // namespace

std::string yaml_text(const YamlNode& root) {
  YAML::Emitter out;
  write(out, root);
  return std::string(out.c_str()) + "\n";
}

}  // namespace alembert
