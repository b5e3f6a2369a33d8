// Sections `bodies` and `frames`: lists of mappings in, bodies ordered parents first and frames out.
#include "mechanism/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mechanism/geometry.hpp"
#include "mechanism/names.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transform_checks.hpp"
#include "mechanism/transforms.hpp"

namespace alembert {
namespace {

MassProperties read_mass_properties(Loading& loading, const Section& section, const std::string& name) {
  const Document& document = loading.document;
  ExprGraph& graph = loading.graph;
  MassProperties out{graph.zero(), zeros<3, 1>(graph), zeros<3, 3>(graph)};
  if (const YamlNode* node = section.find("mass")) {
    const Quantity value =
        loading.reader.read(*node, Allowed::parameters, fmt::format("the mass of body '{}'", name));
    out.mass = value.expr;
    if (value.initial < 0)
      throw InputError(document.where(*node),
                       fmt::format("the mass of body '{}' is negative: {:.6g}", name, value.initial));
  }
  if (const YamlNode* node = section.find("com"))
    out.com = loading.reader.read_vector(*node, Allowed::parameters,
                                         fmt::format("the centre of mass of body '{}'", name));
  if (const YamlNode* node = section.find("inertia")) {
    const std::string what = fmt::format("the inertia of body '{}'", name);
    const Section inertia(document, *node, what, {"xx", "yy", "zz", "xy", "xz", "yz"});
    loading.inertia_places[name] = document.where(*node);
    for (const std::string_view key : {"xx", "yy", "zz", "xy", "xz", "yz"}) {
      const YamlNode* entry = key[0] == key[1] ? &inertia.require(key) : inertia.find(key);
      if (entry == nullptr) continue;
      const Quantity value = loading.reader.read(*entry, Allowed::parameters, what);
      const auto r = static_cast<std::size_t>(key[0] - 'x'), c = static_cast<std::size_t>(key[1] - 'x');
      out.inertia(r, c) = out.inertia(c, r) = value.expr;
    }
  }
  return out;
}

Section body_section(const Document& document, const YamlNode& item) {
  return Section(document, item, "a body",
                 {"name", "parent", "transform", "mass", "com", "inertia", "external_wrench", "geometry"});
}
Section frame_section(const Document& document, const YamlNode& item) {
  return Section(document, item, "a frame", {"name", "body", "transform"});
}

std::map<std::string, int, std::less<>> declare_names(const Document& document, const YamlNode& list,
                                                      const std::string& kind,
                                                      Section (*section_of)(const Document&,
                                                                            const YamlNode&)) {
  std::map<std::string, int, std::less<>> indices;
  std::map<std::string, int, std::less<>> lines;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const Section section = section_of(document, *list.items[i]);
    const YamlNode& node = section.require("name");
    const std::string& name = expect_name(document, node, "a " + kind);
    if (name == "world")
      throw InputError(document.where(node), "'world' is reserved: it is the frame that does not move");
    if (!indices.emplace(name, static_cast<int>(i)).second)
      throw InputError(document.where(node),
                       fmt::format("'{}' is already a {} (line {})", name, kind, lines[name]));
    lines[name] = node.line;
  }
  return indices;
}

/// Positions of bodies in the file, in its order except that ancestors that come later stand just before the
/// first body that needs them.
std::vector<int> parents_first(const std::vector<Body>& bodies,
                               const std::vector<SourceLocation>& parent_places) {
  enum class Mark { unseen, on_path, placed };
  std::vector<Mark> marks(bodies.size(), Mark::unseen);
  std::vector<int> order, path;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    int at = static_cast<int>(i);
    for (; at >= 0 && marks[static_cast<std::size_t>(at)] == Mark::unseen;
         at = bodies[static_cast<std::size_t>(at)].parent) {
      marks[static_cast<std::size_t>(at)] = Mark::on_path;
      path.push_back(at);
    }
    if (at >= 0 && marks[static_cast<std::size_t>(at)] == Mark::on_path) {
      const Body& body = bodies[static_cast<std::size_t>(at)];
      std::string cycle = body.name;
      int length = 1;
      for (int k = body.parent; k != at; k = bodies[static_cast<std::size_t>(k)].parent)
        if (++length <= 8) cycle += fmt::format(" -> {}", bodies[static_cast<std::size_t>(k)].name);
      if (length > 8) cycle += " -> ...";
      throw InputError(
          parent_places[static_cast<std::size_t>(at)],
          fmt::format("the parents of body '{}' make a cycle: {} -> {}", body.name, cycle, body.name));
    }
    for (; !path.empty(); path.pop_back()) {
      marks[static_cast<std::size_t>(path.back())] = Mark::placed;
      order.push_back(path.back());
    }
  }
  return order;
}

}  // namespace

int expect_body(const Loading& loading, const YamlNode& node, const std::string& what) {
  const std::string& name =
      expect_text(loading.document, node, fmt::format("the name of a body as {}", what));
  if (name == "world") return -1;
  const auto found = loading.body_indices.find(name);
  if (found != loading.body_indices.end()) return found->second;
  std::vector<std::string> names = {"world"};
  for (const auto& [known, index] : loading.body_indices) names.push_back(known);
  throw InputError(loading.document.where(node), fmt::format("unknown body '{}' as {}{}", printable(name),
                                                             what, did_you_mean(name, names)));
}

void read_bodies(Loading& loading, const YamlNode& list) {
  const Document& document = loading.document;
  if (expect_list(document, list, "the bodies").empty())
    throw InputError(document.where(list), "no bodies; a mechanism has at least one");
  loading.body_indices = declare_names(document, list, "body", body_section);
  std::vector<Body> bodies;
  std::vector<SourceLocation> parent_places;
  for (const YamlNode* item : list.items) {
    const Section section = body_section(document, *item);
    Body body;
    body.name = section.require("name").text;
    body.where = document.where(section.require("name"));
    const YamlNode* parent = section.find("parent");
    if (parent != nullptr)
      body.parent = expect_body(loading, *parent, fmt::format("the parent of body '{}'", body.name));
    parent_places.push_back(parent != nullptr ? document.where(*parent) : body.where);
    if (const YamlNode* transform = section.find("transform"))
      body.transform =
          read_transform(loading, *transform, fmt::format("the transform of body '{}'", body.name));
    body.mass_properties = read_mass_properties(loading, section, body.name);
    if (const YamlNode* wrench = section.find("external_wrench"))
      body.external_wrench = expect_boolean(document, *wrench, "'external_wrench'");
    if (const YamlNode* geometry = section.find("geometry"))
      body.geometry = read_geometry(loading, *geometry, body.name);
    bodies.push_back(std::move(body));
  }
  const std::vector<int> order = parents_first(bodies, parent_places);
  std::vector<const Body*> in_file_order;
  for (const Body& body : bodies) in_file_order.push_back(&body);
  check_coordinates(loading, in_file_order);

  std::vector<int> new_index(bodies.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    new_index[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  for (auto& [name, index] : loading.body_indices) index = new_index[static_cast<std::size_t>(index)];
  for (const int old : order) {
    Body& body = bodies[static_cast<std::size_t>(old)];
    if (body.parent >= 0) body.parent = new_index[static_cast<std::size_t>(body.parent)];
    loading.mechanism.bodies.push_back(std::move(body));
  }
}

void read_frames(Loading& loading, const YamlNode& list) {
  const Document& document = loading.document;
  expect_list(document, list, "the frames");
  declare_names(document, list, "frame", frame_section);
  for (const YamlNode* item : list.items) {
    const Section section = frame_section(document, *item);
    Frame frame;
    frame.name = section.require("name").text;
    frame.where = document.where(section.require("name"));
    frame.body =
        expect_body(loading, section.require("body"), fmt::format("the body of frame '{}'", frame.name));
    if (const YamlNode* transform = section.find("transform"))
      frame.transform =
          read_transform(loading, *transform, fmt::format("the transform of frame '{}'", frame.name));
    loading.mechanism.frames.push_back(std::move(frame));
    loading.reader.declare_last_frame();
  }
}

}  // namespace alembert
