// The table of importers (see the header).
#include "import/importers.hpp"

#include <algorithm>

#include "import/mjcf/describe_model.hpp"
#include "import/mjcf/mjcf_model.hpp"
#include "import/opensim/describe_osim.hpp"
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

constexpr Importer kImporters[] = {
    {"URDF", ".urdf", [](std::string_view text) { return root_of(text) == "robot"; },
     [](const std::shared_ptr<const SourceText>& source, const DescribeOptions& options, Warnings& warnings) {
       return describe_robot(read_urdf(source, warnings), source, options);
     }},
    {"MJCF", ".mjcf", [](std::string_view text) { return root_of(text) == "mujoco"; },
     [](const std::shared_ptr<const SourceText>& source, const DescribeOptions& options, Warnings& warnings) {
       return describe_model(read_mjcf(source, warnings), source, options);
     }},
    {"OpenSim", ".osim", [](std::string_view text) { return root_of(text) == "OpenSimDocument"; },
     describe_osim},
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
  if (const Importer* const by_name = importer_by_name(source)) return *by_name;
  const auto by_text = std::ranges::find_if(
      kImporters, [&](const Importer& importer) { return importer.recognises(source.text); });
  return by_text != std::end(kImporters) ? *by_text : kImporters[0];
}

const Importer* importer_unless_description(const SourceText& source) {
  if (const Importer* const by_name = importer_by_name(source)) return by_name;
  const std::size_t first = source.text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && source.text[first] == '<' ? &importer_of(source) : nullptr;
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
