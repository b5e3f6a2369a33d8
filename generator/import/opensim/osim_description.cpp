#include "import/opensim/osim_description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "import/common/snapped_angle.hpp"
#include "mechanism/names.hpp"

namespace alembert {
namespace {

constexpr const char* kLists[] = {"coordinates", "inputs", "states",  "bodies",
                                  "frames",      "forces", "outputs", "constraints"};

/// Names in the texts of a tree.
void collect_words(const YamlNode& node, std::set<std::string>& out) {
  std::string word;
  for (const char c : node.text + " ") {
    if (is_word_character(c)) {
      word += c;
    } else {
      if (!word.empty()) out.insert(word);
      word.clear();
    }
  }
  const bool mapping = node.kind == YamlNode::Kind::mapping;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    // A name is no use of it.
    if (mapping && i % 2 == 1 && node.items[i - 1]->text == "name") continue;
    collect_words(*node.items[i], out);
  }
}

}  // namespace

OsimDescription::OsimDescription(const OsimModel& of, const OsimXml& from, const DescribeOptions& with)
    : model(of),
      xml(from),
      options(with),
      factors(nodes, from, with.snap_angles,
              [this](const std::string& name, const std::string& text, const SourceLocation& at) {
                return define(name, text, at);
              }) {
  for (const char* list : kLists) sections[list] = &nodes.sequence(model.where);
  for (const OsimBody& body : model.bodies) body_names.reserve(body.name);
  for (const OsimBody& body : model.bodies)
    bodies.push_back(bodies.empty() ? "world" : body_names.add(body.name, body.where));
  for (const OsimCoordinate& coordinate : model.coordinates) names.reserve(coordinate.name);
}

std::optional<std::pair<std::size_t, double>> OsimDescription::driver(std::size_t coordinate) const {
  std::pair<std::size_t, double> out{coordinate, 1};
  for (auto found = follows.find(out.first); found != follows.end(); found = follows.find(out.first))
    out = {found->second.first, out.second * found->second.second};
  if (!independent[out.first]) return {};
  return out;
}

std::string OsimDescription::define(const std::string& name, const std::string& text,
                                    const SourceLocation& at) {
  const std::string fit = names.add(name, at);
  definitions.push_back({fit, text, at});
  return fit;
}

std::string OsimDescription::add_frame(const std::string& name, std::size_t on,
                                       const std::array<std::string, 3>& point, const SourceLocation& at,
                                       const std::array<double, 3>& orientation) {
  const std::string key = fmt::format("{} {} {}", name, fmt::join(point, " "), fmt::join(orientation, " "));
  if (const auto made = frames_made_.find({on, key}); made != frames_made_.end()) return made->second;
  const OsimFrame& frame = model.frames[on];
  const std::string fit = frame_names.add(name, at);
  YamlNode& node = nodes.add_named(*sections["frames"], fit, at);
  nodes.put(node, "body", nodes.text(bodies[frame.body], at));
  YamlNode& transform = nodes.sequence(at);
  factors.add_offsets(transform, frame, at);
  if (std::ranges::any_of(point, [](const std::string& text) { return text != "0"; }))
    transform.items.push_back(&nodes.single("translate", nodes.list({point[0], point[1], point[2]}, at)));
  factors.add_offset(transform, {{}, orientation}, at);
  if (!transform.items.empty()) nodes.put(node, "transform", transform);
  frames_made_.emplace(std::pair(on, key), fit);
  return fit;
}

std::string OsimDescription::frame_of(std::size_t frame, const SourceLocation& at) {
  const OsimFrame& of = model.frames[frame];
  return add_frame(of.name.empty() ? model.bodies[of.body].name : of.name, frame, {"0", "0", "0"}, at);
}

std::string OsimDescription::add_input(const std::string& name, double initial,
                                       const std::array<double, 2>& limits, const SourceLocation& at) {
  const std::string fit = names.add(name, at);
  YamlNode& node = nodes.add_named(*sections["inputs"], fit, at);
  if (initial != 0) put(node, "initial", number_text(initial), at);
  if (std::isfinite(limits[1] - limits[0]) && limits[0] < limits[1] && limits[0] <= initial &&
      initial <= limits[1])
    nodes.put(node, "limits", nodes.list({number_text(limits[0]), number_text(limits[1])}, at));
  return fit;
}

std::string OsimDescription::add_state(const std::string& name, double initial,
                                       const std::array<double, 2>& limits, const std::string& rate,
                                       const SourceLocation& at) {
  YamlNode& node = nodes.add_named(*sections["states"], name, at);
  const bool ordered = limits[0] < limits[1];
  put(node, "initial", number_text(ordered ? std::clamp(initial, limits[0], limits[1]) : initial), at);
  if (ordered && std::isfinite(limits[0]) && std::isfinite(limits[1]))
    nodes.put(node, "limits", nodes.list({number_text(limits[0]), number_text(limits[1])}, at));
  put(node, "rate", rate, at);
  return name;
}

YamlNode& OsimDescription::add_force(const std::string& name, const SourceLocation& at) {
  return nodes.add_named(*sections["forces"], force_names.add(name, at), at);
}

void OsimDescription::put(YamlNode& mapping, const char* key, const std::string& text,
                          const SourceLocation& at) {
  nodes.put(mapping, key, nodes.text(text, at));
}

void OsimDescription::left(pugi::xml_node element, const std::string& why, const std::string& note) {
  ++left_out[element.name()];
  warnings.push_back({xml.where(element), fmt::format("{} is left out: {}", OsimXml::title(element), why),
                      note, fmt::format("left {} {}", element.name(), why)});
}

void OsimDescription::approximated(pugi::xml_node element, const std::string& how, const std::string& note) {
  ++nearly[element.name()];
  warnings.push_back({xml.where(element), fmt::format("{} {}", OsimXml::title(element), how), note,
                      fmt::format("approximated {}", element.name())});
}

/// Parameters and definitions that nothing needs, such as the position of a locked coordinate that turns nothing.
void OsimDescription::drop_unused() {
  for (bool more = true; more;) {
    std::set<std::string> words;
    for (const auto& [name, list] : sections) collect_words(*list, words);
    for (const Named& definition : definitions)
      collect_words(nodes.text(definition.text, definition.at), words);
    const auto unused = [&](const Named& named) { return !words.contains(named.name); };
    more = std::erase_if(definitions, unused) + std::erase_if(parameters, unused) > 0;
  }
}

YamlNode& OsimDescription::finish() {
  drop_unused();
  const SourceLocation& top = model.where;
  std::string about = fmt::format("OpenSim model '{}'", printable(model.name));
  if (!taken.empty()) about += "; taken: " + counts_text(taken);
  if (const std::string rest = left_text(nearly, left_out); !rest.empty()) about += "; " + rest;
  YamlNode& root = nodes.root(options.name_or(model.name), about, top);
  nodes.put(root, "gravity", nodes.numbers(model.gravity, top));
  const auto put_named = [&](const char* key, const std::vector<Named>& list) {
    if (list.empty()) return;
    YamlNode& mapping = nodes.mapping(top);
    for (const Named& named : list) nodes.put(mapping, named.name, nodes.text(named.text, named.at));
    nodes.put(root, key, mapping);
  };
  const auto put_list = [&](const char* key) {
    if (!sections[key]->items.empty()) nodes.put(root, key, *sections[key]);
  };
  put_named("parameters", parameters);
  put_list("inputs");
  put_list("coordinates");
  put_list("states");
  put_named("definitions", definitions);
  for (const char* key : {"bodies", "frames", "forces", "outputs", "constraints"}) put_list(key);
  return root;
}

}  // namespace alembert
