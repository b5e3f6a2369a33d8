#include "mechanism/section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace alembert {

std::string description_of(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::scalar:
      return fmt::format("'{}'", printable(node.text));
    case YamlNode::Kind::sequence:
      return "a list";
    case YamlNode::Kind::mapping:
      return "a mapping";
  }
  return {};
}

void fail_expected(const Document& document, const YamlNode& node, std::string_view expected) {
  throw InputError(document.where(node),
                   fmt::format("expected {}, found {}", expected, description_of(node)));
}

bool is_cut_at_comma(const YamlNode& node) {
  return node.plain && std::count(node.text.begin(), node.text.end(), '(') >
                           std::count(node.text.begin(), node.text.end(), ')');
}

const std::vector<const YamlNode*>& expect_list(const Document& document, const YamlNode& node,
                                                std::string_view what, int count) {
  if (node.kind != YamlNode::Kind::sequence) fail_expected(document, node, fmt::format("a list as {}", what));
  if (count >= 0 && node.items.size() != static_cast<std::size_t>(count)) {
    const bool cut = std::any_of(node.items.begin(), node.items.end(),
                                 [](const YamlNode* item) { return is_cut_at_comma(*item); });
    throw InputError(document.where(node),
                     fmt::format("expected {} values as {}, found {}", count, what, node.items.size()),
                     cut ? std::string(kCutNote) : std::string());
  }
  return node.items;
}

const std::string& expect_text(const Document& document, const YamlNode& node, std::string_view what) {
  if (node.kind != YamlNode::Kind::scalar) fail_expected(document, node, what);
  return node.text;
}

bool expect_boolean(const Document& document, const YamlNode& node, std::string_view what) {
  if (node.kind == YamlNode::Kind::scalar && node.plain) {
    for (const char* text : {"true", "True", "TRUE"})
      if (node.text == text) return true;
    for (const char* text : {"false", "False", "FALSE"})
      if (node.text == text) return false;
  }
  fail_expected(document, node, fmt::format("true or false as {}", what));
}

Section::Section(const Document& document, const YamlNode& node, std::string what,
                 std::initializer_list<std::string_view> keys)
    : document_(&document), node_(&node), what_(std::move(what)) {
  if (node.kind != YamlNode::Kind::mapping)
    fail_expected(document, node, fmt::format("a mapping as {}", what_));
  for (std::size_t i = 0; i < node.items.size(); i += 2) {
    const std::string& key = node.items[i]->text;
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::vector<std::string> known(keys.begin(), keys.end());
    const bool cut = i >= 2 && is_cut_at_comma(*node.items[i - 1]);
    throw InputError(document.where(*node.items[i]),
                     fmt::format("unknown key '{}' in {}{}", printable(key), what_, did_you_mean(key, known)),
                     cut ? std::string(kCutNote) : fmt::format("its keys are {}", fmt::join(known, ", ")));
  }
}

const YamlNode* Section::find(std::string_view key) const {
  for (std::size_t i = 0; i + 1 < node_->items.size(); i += 2)
    if (node_->items[i]->text == key) return node_->items[i + 1];
  return nullptr;
}

const YamlNode& Section::require(std::string_view key) const {
  const YamlNode* value = find(key);
  if (value == nullptr)
    throw InputError(document_->where(*node_), fmt::format("missing key '{}' in {}", key, what_));
  return *value;
}

SourceLocation Section::where_key(std::string_view key) const {
  for (std::size_t i = 0; i < node_->items.size(); i += 2)
    if (node_->items[i]->text == key) return document_->where(*node_->items[i]);
  return document_->where(*node_);
}

}  // namespace alembert
