// The table of importers (see the header).
#include "import/importers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <utility>
#include <vector>

#include "import/mjcf/describe_model.hpp"
#include "import/mjcf/mjcf_model.hpp"
#include "import/opensim/describe_osim.hpp"
#include "import/sdf/describe_sdf.hpp"
#include "import/urdf/describe.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {
namespace {

/// The name of the first element of an XML text; nothing if there is none.
std::string_view root_of(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with("!--")) {
      at = text.find("-->", at);
      if (at == std::string_view::npos) break;
    } else if (!rest.starts_with('?') && !rest.starts_with('!')) {
      return rest.substr(0, rest.find_first_of(" \t\r\n/>"));
    }
  }
  return {};
}

/// Behind white space and the mark that some editors put first.
bool begins_with_element(std::string_view text) {
  if (constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"; text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

constexpr unsigned options_of(std::initializer_list<ImportOption> options) {
  unsigned out = 0;
  for (const ImportOption option : options) out |= static_cast<unsigned>(option);
  return out;
}

constexpr Importer kImporters[] = {
    {"URDF", ".urdf",
     options_of({ImportOption::root, ImportOption::massless, ImportOption::friction,
                 ImportOption::snap_angles, ImportOption::include, ImportOption::name}),
     [](std::string_view text) { return root_of(text) == "robot"; },
     [](const std::shared_ptr<const SourceText>& source, const DescribeOptions& options, Warnings& warnings) {
       return describe_robot(read_urdf(source, warnings), source, options);
     }},
    {"MJCF", ".mjcf",
     options_of(
         {ImportOption::friction, ImportOption::snap_angles, ImportOption::include, ImportOption::name}),
     [](std::string_view text) { return root_of(text) == "mujoco" || root_of(text) == "mujocoinclude"; },
     [](const std::shared_ptr<const SourceText>& source, const DescribeOptions& options, Warnings& warnings) {
       return describe_model(read_mjcf(source, options.include_folders, warnings), source, options);
     }},
    {"SDF", ".sdf",
     options_of(
         {ImportOption::friction, ImportOption::snap_angles, ImportOption::include, ImportOption::name}),
     [](std::string_view text) { return root_of(text) == "sdf"; }, describe_sdf},
    {"OpenSim", ".osim", options_of({ImportOption::snap_angles, ImportOption::name}),
     [](std::string_view text) { return root_of(text) == "OpenSimDocument"; }, describe_osim},
};

struct OptionName {
  ImportOption option;
  std::string_view name;
  bool (*is_given)(const DescribeOptions& options);
};

constexpr OptionName kOptionNames[] = {
    {ImportOption::root, "--root", [](const DescribeOptions& options) { return options.floating; }},
    {ImportOption::massless, "--massless",
     [](const DescribeOptions& options) { return options.massless != Massless::keep; }},
    {ImportOption::friction, "--no-friction",
     [](const DescribeOptions& options) { return !options.resistance; }},
    {ImportOption::snap_angles, "--snap-angles",
     [](const DescribeOptions& options) { return options.snap_angles != DescribeOptions{}.snap_angles; }},
    {ImportOption::include, "--include",
     [](const DescribeOptions& options) { return !options.include_folders.empty(); }},
    {ImportOption::name, "--name", [](const DescribeOptions& options) { return !options.name.empty(); }},
};

const Importer* importer_by_name(const SourceText& source) {
  const auto found = std::ranges::find_if(
      kImporters, [&](const Importer& importer) { return source.name.ends_with(importer.extension); });
  return found == std::end(kImporters) ? nullptr : found;
}

}  // namespace

std::span<const Importer> importers() {
  return kImporters;
}

const Importer& importer_of(const SourceText& source) {
  const Importer* const by_name = importer_by_name(source);
  const auto by_text = std::ranges::find_if(
      kImporters, [&](const Importer& importer) { return importer.recognises(source.text); });
  // What stands in a file counts more than its name.
  if (by_name != nullptr && (by_text == std::end(kImporters) || by_name->recognises(source.text)))
    return *by_name;
  return by_text != std::end(kImporters) ? *by_text : kImporters[0];
}

const Importer* importer_unless_description(const SourceText& source) {
  const bool is_named = importer_by_name(source) != nullptr;
  return is_named || begins_with_element(source.text) ? &importer_of(source) : nullptr;
}

void warn_of_unused(const std::shared_ptr<const SourceText>& source, std::string_view format, unsigned taken,
                    const DescribeOptions& options, Warnings& warnings) {
  std::string names;
  int count = 0;
  for (const OptionName& each : kOptionNames) {
    if ((taken & static_cast<unsigned>(each.option)) != 0 || !each.is_given(options)) continue;
    names += (names.empty() ? "" : ", ") + std::string(each.name);
    ++count;
  }
  if (count > 0)
    warnings.push_back(
        {{source, 1, 1}, fmt::format("{} {} no meaning for {}", names, count == 1 ? "has" : "have", format)});
}

DescribedRobot describe_source(const std::shared_ptr<const SourceText>& source,
                               const DescribeOptions& options, Warnings& warnings) {
  if (importer_by_name(*source) == nullptr && !begins_with_element(source->text))
    throw InputError({source, 1, 1},
                     fmt::format("expected a file of {}, which are XML", importable_formats()),
                     "what is a description already needs no import: the other commands take it as it is");
  const Importer& importer = importer_of(*source);
  warn_of_unused(source, importer.format, importer.options, options, warnings);
  DescribeOptions all = options;
  if (all.folder.empty() && source->name != "<stdin>")
    all.folder = std::filesystem::absolute(source->name).parent_path().string();
  return importer.describe(source, all, warnings);
}

std::string summary(const DescribedRobot& described) {
  constexpr std::pair<std::string_view, std::string_view> kSections[] = {{"bodies", "body"},
                                                                         {"frames", "frame"},
                                                                         {"coordinates", "coordinate"},
                                                                         {"definitions", "definition"},
                                                                         {"inputs", "input"},
                                                                         {"states", "state"},
                                                                         {"forces", "force"},
                                                                         {"outputs", "output"},
                                                                         {"constraints", "constraint"}};
  const std::vector<const YamlNode*>& entries = described.document.root().items;
  std::string out = "taken:";
  for (const auto& [many, one] : kSections)
    for (std::size_t i = 0; i + 1 < entries.size(); i += 2) {
      const YamlNode& section = *entries[i + 1];
      if (entries[i]->text != many || section.items.empty()) continue;
      const std::size_t count = section.items.size() / (section.kind == YamlNode::Kind::mapping ? 2 : 1);
      out += fmt::format("{} {} {}", out.ends_with(':') ? "" : ",", count, count == 1 ? one : many);
    }
  return described.left.empty() ? out : out + "; " + described.left;
}

std::string importable_formats() {
  std::string list;
  for (const Importer& importer : kImporters) {
    if (!list.empty()) list += &importer == std::end(kImporters) - 1 ? " or " : ", ";
    list += importer.format;
  }
  return list;
}

}  // namespace alembert
