// Section `forces`: list of mappings in, forces out: along speeds, of potentials, along functions of the coordinates, of
// tensions along paths from frame to frame, and wrenches on frames.
#include "mechanism/force_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/contact_reader.hpp"
#include "mechanism/names.hpp"
#include "mechanism/section.hpp"
#include "mechanism/wrapped_path.hpp"

namespace alembert {
namespace {

/// A key that says what kind of force it is, and the keys that go with it.
struct KindKey {
  std::string_view key;
  ForceKind kind;
  std::vector<std::string_view> others;
};

const std::vector<KindKey>& kind_keys() {
  static const std::vector<KindKey> keys = {
      {"on", ForceKind::on_speed, {"value"}}, {"potential", ForceKind::potential, {}},
      {"along", ForceKind::along, {"value"}}, {"between", ForceKind::path, {"tension"}},
      {"path", ForceKind::path, {"tension"}}, {"at", ForceKind::wrench, {"axes", "force", "torque"}},
      {"contact", ForceKind::wrench, {}}};
  return keys;
}

class ForceReader {
 public:
  ForceReader(Loading& loading, const YamlNode& item)
      : loading_(loading),
        document_(loading.document),
        section_(loading.document, item, "a force",
                 {"name", "on", "value", "potential", "along", "between", "path", "tension", "at", "axes",
                  "force", "torque", "contact"}) {}

  /// Name, kind, and of a path its frames: forces may use the lengths of paths that come later.
  void declare() {
    const YamlNode& name = section_.require("name");
    force_.name = expect_name(document_, name, "a force");
    force_.where = document_.where(name);
    const KindKey& key = kind_key();
    force_.kind = key.kind;
    if (key.kind == ForceKind::path) declare_path(section_.require(key.key), key.key == "between");
  }
  /// What a force is along, once all paths are declared.
  void declare_function() {
    if (force_.kind != ForceKind::along) return;
    const YamlNode& node = section_.require("along");
    const std::string what = of_force("what it is along");
    const Quantity function = loading_.reader.read(node, Allowed::potential, what);
    if (!includes(function.dependence, Dependence::coordinate))
      throw InputError(document_.where(node), what + " depends on no coordinate: it moves nothing");
    declare_length(function.expr);
  }
  const Force& declared() const { return force_; }

  /// The rest, once all are declared.
  std::vector<Force> read() {
    if (const YamlNode* contact = section_.find("contact"))
      return read_contact(loading_, *contact, force_.name, force_.where);
    switch (force_.kind) {
      case ForceKind::on_speed:
        read_speed(section_.require("on"));
        force_.value = read_expression("value", Allowed::force, "the value");
        break;
      case ForceKind::potential:
        force_.value = read_expression("potential", Allowed::potential, "the potential");
        break;
      case ForceKind::along:
        force_.value = loading_.reader
                           .read_with(section_.require("value"), {{"rate", force_.rate, kMoving}},
                                      Allowed::force, of_force("the value"))
                           .expr;
        break;
      case ForceKind::path:
        read_tension();
        break;
      case ForceKind::wrench:
        read_wrench();
        break;
    }
    return {force_};
  }

 private:
  std::string of_force(std::string_view what) const {
    return fmt::format("{} of force '{}'", what, force_.name);
  }

  const KindKey& kind_key() const {
    const KindKey* found = nullptr;
    for (const KindKey& key : kind_keys()) {
      if (section_.find(key.key) == nullptr) continue;
      if (found != nullptr)
        throw InputError(
            section_.where_key(key.key),
            fmt::format("force '{}' has '{}' already; one force, one of them", force_.name, found->key));
      found = &key;
    }
    if (found == nullptr)
      throw InputError(force_.where, fmt::format("force '{}' does not say what it acts on", force_.name),
                       "expected one of on, potential, along, between, path, at, contact");
    for (const KindKey& other : kind_keys())
      for (const std::string_view key : other.others)
        if (section_.find(key) != nullptr && std::ranges::find(found->others, key) == found->others.end())
          throw InputError(section_.where_key(key),
                           fmt::format("a force with '{}' takes no '{}'", found->key, key));
    return *found;
  }

  Expr read_expression(std::string_view key, Allowed allowed, std::string_view what) {
    return loading_.reader.read(section_.require(key), allowed, of_force(what)).expr;
  }

  /// `on: q` or, of a quaternion, `on: base.x`.
  void read_speed(const YamlNode& node) {
    const std::string& text = expect_text(document_, node, of_force("the coordinate"));
    const std::size_t point = text.find('.');
    const std::string name = text.substr(0, point);
    const std::string part = point == std::string::npos ? "" : text.substr(point + 1);
    NameEntry* entry = loading_.scope.find(name);
    if (entry == nullptr || entry->index < 0)
      throw InputError(document_.where(node),
                       entry != nullptr
                           ? fmt::format("'{}' is {}; a force is on a coordinate", name, a_noun(entry->kind))
                           : fmt::format("unknown coordinate '{}'{}", printable(name),
                                         did_you_mean(name, loading_.scope.coordinate_names())));
    entry->used = true;
    const Coordinate& coordinate = loading_.mechanism.coordinates[static_cast<std::size_t>(entry->index)];
    const bool real = coordinate.type == CoordinateType::real;
    const std::size_t axis = std::string_view("xyz").find(part);
    if (real ? point != std::string::npos : part.size() != 1 || axis == std::string::npos)
      throw InputError(
          document_.where(node, real ? point : 0),
          real ? fmt::format("coordinate '{}' has one speed: on: {}", name, name)
               : fmt::format("quaternion coordinate '{0}' has the speeds {0}.x, {0}.y and {0}.z", name));
    force_.speed = coordinate.first_speed + (real ? 0 : static_cast<int>(axis));
  }

  /// `NAME`, or `{frame: NAME, when: expression}` but for ends.
  PathPoint path_point(const YamlNode& node, bool end, const std::string& what) {
    if (node.kind != YamlNode::Kind::mapping) return {loading_.reader.expect_frame(node, what), {}};
    if (end)
      throw InputError(document_.where(node), fmt::format("the ends of {} take no condition", what),
                       "expected the name of a frame; points between the ends may be {frame: NAME, when: e}");
    const Section section(document_, node, "a point of " + what, {"frame", "when"});
    return {loading_.reader.expect_frame(section.require("frame"), what),
            loading_.reader
                .read(section.require("when"), Allowed::potential, "the condition of a point of " + what)
                .expr};
  }

  static bool is_obstacle(const YamlNode& node) {
    if (node.kind != YamlNode::Kind::mapping) return false;
    for (std::size_t i = 0; i < node.items.size(); i += 2)  // keys
      if (node.items[i]->text == "sphere" || node.items[i]->text == "cylinder") return true;
    return false;
  }
  PathObstacle obstacle(const YamlNode& node, const std::string& what) {
    const Section section(document_, node, "what " + what + " leads around",
                          {"sphere", "cylinder", "radius", "length", "side"});
    PathObstacle out{{}, 0};
    out.shape.cylinder = section.find("cylinder") != nullptr;
    if (out.shape.cylinder && section.find("sphere") != nullptr)
      throw InputError(document_.where(node), "a path leads around a sphere or a cylinder, one at a time");
    out.frame =
        loading_.reader.expect_frame(section.require(out.shape.cylinder ? "cylinder" : "sphere"), what);
    out.shape.radius = loading_.reader.coefficient(section.require("radius"),
                                                   "the radius of what " + what + " leads around", true);
    if (const YamlNode* length = section.find("length")) {
      if (!out.shape.cylinder)
        throw InputError(document_.where(*length), "a sphere has no length; that is a cylinder's");
      out.shape.length = loading_.reader.coefficient(
          *length, "the length of the cylinder that " + what + " leads around", true);
    }
    if (const YamlNode* side = section.find("side")) out.side = loading_.reader.expect_frame(*side, what);
    return out;
  }
  /// In the axes of the obstacle, from its origin; of a sphere, in the world's.
  Vec3 seen_from(const PathObstacle& obstacle, int frame) {
    ExpressionReader& reader = loading_.reader;
    const Vec3 point = reader.vector_of(frame, FrameQuantity::position),
               away = point - reader.vector_of(obstacle.frame, FrameQuantity::position);
    return obstacle.shape.cylinder ? transpose(reader.rotation_of(obstacle.frame)) * away : away;
  }
  Expr stretch(const std::vector<PathPoint>& points, std::size_t from, std::size_t to) {
    const Expr straight = loading_.reader.distance(points[from].frame, points[to].frame);
    const auto found = force_.obstacles.find(from);
    if (found == force_.obstacles.end()) return straight;
    const PathObstacle& around = found->second;
    const std::optional<Vec3> side =
        around.side ? std::optional(seen_from(around, *around.side)) : std::nullopt;
    const Vec3 begin = seen_from(around, points[from].frame), end = seen_from(around, points[to].frame);
    return length_around(around.shape, begin, end, side, straight);
  }

  /// Through the points that are on the path: beyond each of them, to the next one whose condition holds.
  Expr length_of(const std::vector<PathPoint>& points) {
    std::vector<Expr> beyond(points.size(), loading_.graph.zero());  // of a point that is on the path
    for (std::size_t i = points.size() - 1; i-- > 0;) {
      std::size_t last = i + 1;
      while (points[last].when) ++last;
      const auto to = [&](std::size_t j) {
        const int from = points[i].frame, frame = points[j].frame;
        return from == frame ? beyond[j] : stretch(points, i, j) + beyond[j];
      };
      beyond[i] = to(last);
      for (std::size_t j = last; --j > i;)
        beyond[i] = if_positive(*points[j].when, to(j)) + unless_positive(*points[j].when, beyond[i]);
    }
    return beyond.front();
  }

  void declare_path(const YamlNode& node, bool two) {
    const std::string what = of_force(two ? "the two frames" : "the path");
    const auto& items = expect_list(document_, node, what, two ? 2 : -1);
    if (items.size() < 2)
      throw InputError(document_.where(node), fmt::format("{} has {} frame{}; expected two or more", what,
                                                          items.size(), items.size() == 1 ? "" : "s"));
    std::vector<PathPoint>& points = force_.path;
    for (const YamlNode* item : items) {
      const bool end = item == items.front() || item == items.back();
      if (is_obstacle(*item)) {
        if (end || force_.obstacles.contains(points.size() - 1))
          throw InputError(document_.where(*item),
                           fmt::format("{} leads around something between two points", what));
        force_.obstacles.emplace(points.size() - 1, obstacle(*item, what));
        continue;
      }
      points.push_back(path_point(*item, end, what));
      const int frame = points.back().frame;
      if (points.size() > 1 && frame == points[points.size() - 2].frame)
        throw InputError(document_.where(*item),
                         fmt::format("{} goes from frame '{}' to itself", what,
                                     loading_.mechanism.frames[static_cast<std::size_t>(frame)].name));
    }
    for (const auto& [before, around] : force_.obstacles)
      if (points[before].when || points[before + 1].when)
        throw InputError(force_.where,
                         fmt::format("{} leads around something beside a point with a condition; that is "
                                     "not taken",
                                     what));
    declare_length(length_of(points));
  }
  void declare_length(const Expr& length) {
    force_.length = length;
    force_.rate = loading_.graph.symbol(fmt::format("rate({})", force_.name));
    loading_.reader.declare_path(force_.name, force_.length, force_.rate);
  }

  void read_tension() {
    Quantity tension = loading_.reader.read_with(
        section_.require("tension"),
        {{"length", force_.length, Dependence::coordinate}, {"rate", force_.rate, kMoving}}, Allowed::force,
        of_force("the tension"));
    force_.value = tension.expr;
    loading_.reader.set_tension(force_.name, tension);
  }

  void read_wrench() {
    force_.frame = loading_.reader.expect_frame(section_.require("at"), of_force("the place"));
    if (const YamlNode* axes = section_.find("axes")) {
      const std::string& text =
          expect_text(document_, *axes, "'frame' or 'world' as " + of_force("the axes"));
      force_.frame_axes = text == "frame";
      if (!force_.frame_axes && text != "world")
        throw InputError(document_.where(*axes), fmt::format("expected 'frame' or 'world' as {}, found '{}'",
                                                             of_force("the axes"), printable(text)));
    }
    if (section_.find("force") == nullptr && section_.find("torque") == nullptr)
      throw InputError(force_.where, fmt::format("force '{}' has neither 'force' nor 'torque'", force_.name));
    force_.force = force_.torque = zeros<3, 1>(loading_.graph);
    if (const YamlNode* node = section_.find("force"))
      force_.force = loading_.reader.read_vector(*node, Allowed::force, of_force("the force"));
    if (const YamlNode* node = section_.find("torque"))
      force_.torque = loading_.reader.read_vector(*node, Allowed::force, of_force("the torque"));
  }

  static constexpr Dependence kMoving = Dependence::coordinate | Dependence::speed;

  Loading& loading_;
  const Document& document_;
  Section section_;
  Force force_;
};

}  // namespace

void read_forces(Loading& loading, const YamlNode& list) {
  std::map<std::string, int, std::less<>> lines;
  std::deque<ForceReader> readers;
  for (const YamlNode* item : expect_list(loading.document, list, "the forces")) {
    ForceReader& reader = readers.emplace_back(loading, *item);
    reader.declare();
    const Force& force = reader.declared();
    const auto [earlier, inserted] = lines.emplace(force.name, force.where.line);
    if (!inserted)
      throw InputError(force.where,
                       fmt::format("'{}' is already a force (line {})", force.name, earlier->second));
  }
  for (ForceReader& reader : readers) reader.declare_function();
  for (ForceReader& reader : readers)
    for (Force& force : reader.read()) loading.mechanism.forces.push_back(std::move(force));
}

}  // namespace alembert
