// XML in, a skeleton out: bodies, frames, joints and coordinates, then the tree that they make.
#include "import/opensim/osim_model.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "import/opensim/osim_joints.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

/// What is placed on frames or points: names of the sockets that say on which.
struct OsimFrameElement {
  const char* name;
  std::array<const char*, 4> sockets;
  bool is_point = false;
};
constexpr OsimFrameElement kFrameElements[] = {
    {"PhysicalOffsetFrame", {"socket_parent"}},
    {"OffsetFrame", {"socket_parent"}},
    {"StationDefinedFrame", {"socket_point_a", "socket_point_b", "socket_point_c", "socket_origin_point"}},
    {"Station", {"socket_parent_frame"}, true},
    {"Marker", {"socket_parent_frame"}, true}};

/// A socket of 4.0 and later, a connector of 3.3's successor, or a property of 3.0.
std::string socket_text(pugi::xml_node element, const char* socket, const char* connector,
                        const char* property) {
  if (std::string text = OsimXml::text(element, {socket, property}); !text.empty()) return text;
  for (const pugi::xml_node child : element.child("connectors").children())
    if (child.attribute("name").value() == std::string_view(connector))
      return OsimXml::text(child, "connectee_name");
  return {};
}

constexpr double kNoMass = 1.9e-14;  // kg: OpenSim takes so little for none

/// Frames that stand on one another, each with its offset: all of them are written for each.
constexpr std::size_t kDeepestFrame = 200;

class SkeletonReader {
 public:
  SkeletonReader(const OsimXml& xml, pugi::xml_node root) : xml_(xml), root_(root) {}

  OsimModel read() {
    if (std::string_view(root_.name()) != "OpenSimDocument")
      throw InputError(xml_.where(root_),
                       fmt::format("expected an <OpenSimDocument>, found <{}>", printable(root_.name())));
    const pugi::xml_node element = root_.child("Model");
    if (!element) throw InputError(xml_.where(root_), "no <Model> in the document");
    model_.element = element;
    model_.where = xml_.where(element);
    model_.name = OsimXml::name_of(element);
    model_.gravity = xml_.vector<3>(element, "gravity", {0, -9.80665, 0});
    read_bodies();
    read_frames();
    read_places();
    read_joints();
    check_tree();
    return std::move(model_);
  }

 private:
  void read_bodies() {
    OsimBody& ground = model_.bodies.emplace_back();
    ground.name = "ground";
    ground.element = model_.element.child("Ground");
    ground.where = ground.element ? xml_.where(ground.element) : model_.where;
    std::vector<pugi::xml_node> elements = xml_.objects(model_.element, "BodySet");
    for (const pugi::xml_node element : xml_.components(model_.element))
      if (std::string_view(element.name()) == "Body") elements.push_back(element);
    std::set<std::string> names;
    for (const pugi::xml_node element : elements) {
      const std::string name = OsimXml::name_of(element);
      if (std::string_view(element.name()) != "Body")
        throw InputError(xml_.where(element),
                         fmt::format("expected a <Body>, found <{}>", printable(element.name())));
      if (name == "ground") {
        model_.bodies[0].element = element;
        continue;
      }
      OsimBody body;
      body.name = name;
      body.mass = xml_.number(element, "mass", 0);
      body.mass_center = xml_.vector<3>(element, "mass_center", {});
      body.element = element;
      body.where = xml_.where(element);
      constexpr const char* kEntries[] = {"inertia_xx", "inertia_yy", "inertia_zz",
                                          "inertia_xy", "inertia_xz", "inertia_yz"};
      for (std::size_t i = 0; i < 6; ++i) body.inertia[i] = xml_.number(element, kEntries[i], 0);
      body.inertia = xml_.vector<6>(element, "inertia", body.inertia);
      if (std::abs(body.mass) <= kNoMass && body.inertia != std::array<double, 6>{}) {
        xml_.warn({body.where,
                   fmt::format("body '{}' has an inertia and no mass: OpenSim takes it to have neither",
                               printable(name)),
                   {},
                   "inertia without mass"});
        body.inertia = {};
      }
      if (!names.insert(name).second)
        throw InputError(body.where, fmt::format("a second body '{}'", printable(name)));
      model_.bodies.push_back(body);
    }
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      const OsimBody& body = model_.bodies[i];
      model_.add_frame({body.name, i == 0 ? "/ground" : "/bodyset/" + body.name, i, {}, false, body.where});
    }
  }

  void read_frames() {
    for (const OsimBody& body : model_.bodies) {
      const std::string path = body.name == "ground" ? "/ground" : "/bodyset/" + body.name;
      collect_frames(body.element.child("components"), path, true);
    }
    for (const pugi::xml_node joint : joint_elements()) {
      const std::string path = "/jointset/" + OsimXml::name_of(joint);
      collect_frames(joint.child("frames"), path, false);
      collect_frames(joint.child("components"), path, false);
    }
    for (const pugi::xml_node force : xml_.objects(model_.element, "ForceSet"))
      collect_frames(force.child("frames"), "/forceset/" + OsimXml::name_of(force), false);
    for (const pugi::xml_node constraint : xml_.objects(model_.element, "ConstraintSet"))
      collect_frames(constraint.child("frames"), "/constraintset/" + OsimXml::name_of(constraint), false);
    collect_frames(model_.element.child("components"), "", true);
    collect_frames(model_.element.child("ComponentSet").child("objects"), "/componentset", true);
    collect_frames(model_.element.child("FrameSet").child("objects"), "/frameset", true);
    // Markers may be the stations of a frame.
    if (std::ranges::any_of(pending_, [](const Pending& each) { return each.on.size() > 1; }))
      collect_frames(model_.element.child("MarkerSet").child("objects"), "/markerset", false);
    // Forces and constraints among the model's components, with frames of their own.
    for (const pugi::xml_node element : xml_.components(model_.element))
      if (!std::string_view(element.name()).ends_with("Joint"))
        collect_frames(element.child("frames"), "/" + OsimXml::name_of(element), false);
    place_frames();
  }

  /// In the order of the file, and where a frame stands on one that comes later, after that.
  void place_frames() {
    std::map<std::string, std::vector<std::size_t>, std::less<>> waiting;  // by the name that they stand on
    std::set<std::string, std::less<>> open;
    std::set<std::size_t> round, next;
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      open.insert(pending_[i].frame.name);
      round.insert(i);
    }
    while (!round.empty()) {
      const std::size_t i = *round.begin();
      round.erase(round.begin());
      const std::string on = waits_for(pending_[i], open);
      if (on.empty()) {
        place(pending_[i]);
        if (const auto found = waiting.find(pending_[i].frame.name); found != waiting.end()) {
          for (const std::size_t each : found->second) (each > i ? round : next).insert(each);
          waiting.erase(found);
        }
      } else {
        waiting[on].push_back(i);
      }
      if (round.empty()) round.swap(next);
    }
    if (waiting.empty()) return;
    const OsimFrame& frame = pending_[waiting.begin()->second.front()].frame;
    throw InputError(frame.where, fmt::format("frame '{}' stands on itself", printable(frame.name)));
  }
  struct Pending {
    OsimFrame frame;
    std::vector<std::string> on;  ///< as the file says it: the parent; or the stations of the frame
    OsimOffset offset;
    pugi::xml_node element;
  };
  void collect_frames(pugi::xml_node parent, const std::string& path, bool own) {
    for (const OsimFrameElement& type : kFrameElements)
      for (const pugi::xml_node element : parent.children(type.name)) {
        const std::string name = OsimXml::name_of(element);
        // Step by step: GCC 12 destroys an aggregate twice when a part of it throws.
        Pending frame;
        frame.frame.name = name;
        frame.frame.path = path + "/" + name;
        frame.frame.own = own && !type.is_point;
        frame.frame.where = xml_.where(element);
        frame.element = element;
        for (const char* socket : type.sockets)
          if (socket != nullptr) frame.on.push_back(socket_text(element, socket, "parent", "parent"));
        if (type.is_point && frame.on[0].empty()) frame.on[0] = OsimXml::text(element, "body");
        frame.offset.translation = xml_.vector<3>(element, type.is_point ? "location" : "translation", {});
        frame.offset.orientation = xml_.vector<3>(element, "orientation", {});
        pending_.push_back(frame);
        collect_frames(element.child("components"), path + "/" + name, own);
      }
  }
  static std::string last_part(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }
  /// The first frame of those not placed yet that this one needs; empty if there is none.
  std::string waits_for(const Pending& pending, const std::set<std::string, std::less<>>& open) const {
    for (const std::string& on : pending.on)
      if (const std::string name = last_part(on);
          open.contains(name) && !find_osim_frame(model_, on, pending.frame.path))
        return name;
    return {};
  }
  void place(const Pending& pending) {
    std::vector<std::size_t> on;
    for (const std::string& socket : pending.on)
      on.push_back(resolve_osim_frame(model_, socket, pending.frame.path, pending.frame.where,
                                      fmt::format("frame '{}'", printable(pending.frame.name))));
    OsimFrame frame = pending.frame;
    frame.body = model_.frames[on[0]].body;
    const bool stations = on.size() > 1;
    if (!stations) frame.offsets = model_.frames[on[0]].offsets;
    if (frame.offsets.size() >= kDeepestFrame)
      throw InputError(frame.where, fmt::format("frame '{}' stands on more than {} others, one on the next",
                                                printable(frame.name), kDeepestFrame));
    const OsimOffset offset = stations ? offset_by_stations(pending, on) : pending.offset;
    if (!offset.is_identity()) frame.offsets.push_back(offset);
    model_.add_frame(std::move(frame));
  }

  /// The frame whose origin is a station, one axis along a -> b and another along (a -> b) x (a -> c).
  OsimOffset offset_by_stations(const Pending& pending, const std::vector<std::size_t>& stations) const {
    const std::string what = fmt::format("frame '{}'", printable(pending.frame.name));
    std::array<Eigen::Vector3d, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      const OsimFrame& station = model_.frames[stations[i]];
      if (station.body != model_.frames[stations[0]].body)
        throw InputError(pending.frame.where, what + " has stations on different bodies");
      points[i] = pose_of(station.offsets).translation();
    }
    const auto& [a, b, c, origin] = points;
    const Eigen::Vector3d along = b - a, across = c - a, normal = along.cross(across);
    // What rounding leaves of points on one line, by how far they are from the origin.
    const double blur =
        16 * std::numeric_limits<double>::epsilon() * std::max({a.norm(), b.norm(), c.norm()});
    if (!(normal.norm() > blur * std::max(along.norm(), across.norm())))
      throw InputError(pending.frame.where, what + " has its stations on one line");
    const auto [first, first_sign] = direction(pending.element, "ab_axis", "+x");
    const auto [second, second_sign] = direction(pending.element, "ab_x_ac_axis", "+y");
    if (first == second)
      throw InputError(pending.frame.where, fmt::format("the axes of {} are one and the same", what));
    Eigen::Matrix3d axes;
    axes.col(first) = first_sign * along.normalized();
    axes.col(second) = second_sign * normal.normalized();
    const int third = 3 - first - second;
    axes.col(third) = axes.col((third + 1) % 3).cross(axes.col((third + 2) % 3));
    OsimOffset out;
    for (int i = 0; i < 3; ++i) out.translation[static_cast<std::size_t>(i)] = origin[i];
    out.orientation = {std::atan2(-axes(1, 2), axes(2, 2)),
                       std::atan2(axes(0, 2), std::hypot(axes(0, 0), axes(0, 1))),
                       std::atan2(-axes(0, 1), axes(0, 0))};
    return out;
  }
  /// Number and sign of an axis, as in "-x".
  std::pair<int, int> direction(pugi::xml_node element, const char* property, const char* otherwise) const {
    const std::string said = OsimXml::text(element, property);
    const std::string text = said.empty() ? otherwise : said;
    const std::size_t letter = text.size() == 2 ? 1 : 0;
    const std::size_t axis = std::string_view("xyzXYZ").find(text[letter]);
    if (text.size() > 2 || axis == std::string_view::npos ||
        (letter == 1 && text[0] != '+' && text[0] != '-'))
      throw InputError(
          xml_.where(element.child(property)),
          fmt::format("expected an axis such as +x as <{}>, found '{}'", property, printable(text)));
    return {static_cast<int>(axis % 3), text[0] == '-' ? -1 : 1};
  }

  /// Before 4.0, welds and bushings say where they stand on two bodies.
  void read_places() {
    for (const char* set : {"ForceSet", "ConstraintSet"})
      for (const pugi::xml_node element : xml_.objects(model_.element, set)) {
        const std::string_view type = element.name();
        if (type != "WeldConstraint" && type != "BushingForce") continue;
        if (!element.child("body_1") || !element.child("body_2")) continue;
        const auto place = [&](const char* body, const char* location, const char* orientation) {
          const std::size_t on = resolve_osim_frame(model_, OsimXml::text(element, body), "",
                                                    xml_.where(element), OsimXml::title(element));
          return frame_off(on,
                           {xml_.vector<3>(element, location, {}), xml_.vector<3>(element, orientation, {})});
        };
        const std::size_t first = place("body_1", "location_body_1", "orientation_body_1");
        model_.places.emplace(element,
                              std::array{first, place("body_2", "location_body_2", "orientation_body_2")});
      }
  }

  /// Joints of the set, and of 3.0 those within bodies.
  std::vector<pugi::xml_node> joint_elements() const {
    std::vector<pugi::xml_node> out;
    for (const OsimBody& body : model_.bodies)
      for (const pugi::xml_node joint : OsimXml::elements(body.element.child("Joint"))) out.push_back(joint);
    for (const pugi::xml_node joint : xml_.objects(model_.element, "JointSet")) out.push_back(joint);
    for (const pugi::xml_node joint : xml_.components(model_.element))
      if (std::string_view(joint.name()).ends_with("Joint")) out.push_back(joint);
    return out;
  }

  void read_joints() {
    for (const pugi::xml_node element : joint_elements()) {
      OsimJoint joint;
      joint.name = OsimXml::name_of(element);
      joint.type = element.name();
      joint.element = element;
      joint.where = xml_.where(element);
      const std::string path = "/jointset/" + joint.name, what = OsimXml::title(element);
      const pugi::xml_node outer = element.parent().parent();
      std::string parent = socket_text(element, "socket_parent_frame", "parent_frame", "parent_body"),
                  child = socket_text(element, "socket_child_frame", "child_frame", "child_body");
      if (parent.empty()) parent = socket_text(element, "socket_parent_body", "parent_body", "parent_body");
      if (child.empty() && std::string_view(outer.name()) == "Body") child = OsimXml::name_of(outer);
      if (child.empty()) child = socket_text(element, "socket_child_body", "child_body", "child_body");
      if (parent.empty() || child.empty())
        throw InputError(joint.where, fmt::format("{} has no {}", what, parent.empty() ? "parent" : "child"));
      joint.parent = offset_frame(element, resolve_osim_frame(model_, parent, path, joint.where, what), true);
      joint.child = offset_frame(element, resolve_osim_frame(model_, child, path, joint.where, what), false);
      if (xml_.flag(element, "reverse", false)) std::swap(joint.parent, joint.child);
      read_osim_coordinates(xml_, joint, model_.joints.size(), model_.coordinates);
      model_.joints.push_back(joint);
    }
  }
  /// Of 3.0: the joint's own place on a body.
  std::size_t offset_frame(pugi::xml_node joint, std::size_t on, bool parent) {
    const std::array<double, 3> none{};
    OsimOffset offset;
    if (parent) {
      offset = {xml_.vector<3>(joint, "location_in_parent", none),
                xml_.vector<3>(joint, "orientation_in_parent", none)};
    } else {
      offset = {xml_.vector<3>(joint, "location", none), xml_.vector<3>(joint, "orientation", none)};
      offset = {xml_.vector<3>(joint, "location_in_child", offset.translation),
                xml_.vector<3>(joint, "orientation_in_child", offset.orientation)};
    }
    return frame_off(on, offset);
  }
  /// A frame without a name, so far off another one; that one itself if it is no way.
  std::size_t frame_off(std::size_t on, const OsimOffset& offset) {
    if (offset.is_identity()) return on;
    OsimFrame frame = model_.frames[on];
    frame.name = frame.path = "";
    frame.offsets.push_back(offset);
    frame.own = false;
    model_.add_frame(std::move(frame));
    return model_.frames.size() - 1;
  }

  /// Each body is moved by one joint, in the direction away from the ground. Where none leads to a body from there, a
  /// FreeJoint does, as in OpenSim.
  void check_tree() {
    const std::size_t given = model_.joints.size();
    model_.joint_of.assign(model_.bodies.size(), static_cast<std::size_t>(-1));
    std::vector<bool> placed(model_.bodies.size(), false), used(given, false);
    placed[0] = true;
    do {
      grow_tree(placed, used);
    } while (add_free_joint(placed));
    for (std::size_t j = 0; j < given; ++j)
      if (!used[j]) close_chain(j);
    for (const auto& [body, copies] : copies_) share_mass(body, copies);
  }

  void grow_tree(std::vector<bool>& placed, std::vector<bool>& used) {
    for (bool more = true; more;) {
      more = false;
      for (std::size_t j = 0; j < used.size(); ++j) {
        OsimJoint& joint = model_.joints[j];
        const std::size_t parent = model_.frames[joint.parent].body, child = model_.frames[joint.child].body;
        if (used[j] || placed[parent] == placed[child]) continue;
        // What stands nearer to the ground carries the other.
        joint.reversed = !placed[parent];
        model_.joint_of[joint.reversed ? parent : child] = j;
        placed[parent] = placed[child] = used[j] = more = true;
      }
    }
  }

  /// For the first of the bodies without a place that are no joint's child or, if there are none, of all of them, that
  /// carry the most joints. False where each body has its place.
  bool add_free_joint(std::vector<bool>& placed) {
    std::vector<std::size_t> as_parent(placed.size(), 0), as_child(placed.size(), 0);
    for (const OsimJoint& joint : model_.joints) {
      ++as_parent[model_.frames[joint.parent].body];
      ++as_child[model_.frames[joint.child].body];
    }
    std::size_t best = 0;
    const auto is_better = [&](std::size_t b) {
      if (best == 0) return true;
      if ((as_child[b] == 0) != (as_child[best] == 0)) return as_child[b] == 0;
      return as_parent[b] > as_parent[best];
    };
    for (std::size_t b = 1; b < placed.size(); ++b)
      if (!placed[b] && is_better(b)) best = b;
    if (best == 0) return false;
    const OsimBody& body = model_.bodies[best];
    xml_.warn({body.where,
               fmt::format("no joint joins body '{}' to the ground: a FreeJoint lets it move, as in OpenSim",
                           printable(body.name)),
               {},
               "body without joint"});
    OsimJoint joint;
    joint.name = "free_" + body.name;
    joint.type = "FreeJoint";
    joint.child = best;
    joint.where = body.where;
    read_osim_coordinates(xml_, joint, model_.joints.size(), model_.coordinates);
    model_.joint_of[best] = model_.joints.size();
    model_.joints.push_back(joint);
    placed[best] = true;
    return true;
  }

  void close_chain(std::size_t j) {
    OsimJoint& joint = model_.joints[j];
    if (model_.frames[joint.parent].body == model_.frames[joint.child].body)
      throw InputError(joint.where,
                       fmt::format("{} joins body '{}' to itself", OsimXml::title(joint.element),
                                   printable(model_.bodies[model_.frames[joint.child].body].name)));
    if (joint.type == "WeldJoint") {
      model_.closures.push_back({joint.element, {joint.parent, joint.child}});
      return;
    }
    joint.reversed = model_.frames[joint.child].body == 0;
    std::size_t& end = joint.reversed ? joint.parent : joint.child;
    const std::size_t body = model_.frames[end].body, copy = model_.bodies.size();
    OsimBody copied = model_.bodies[body];
    copied.name += "_of_" + joint.name;
    copied.element = {};
    copied.where = joint.where;
    const auto add_frame = [&](std::size_t of, std::vector<OsimOffset> offsets) {
      OsimFrame frame = model_.frames[of];
      frame.body = copy;
      frame.name = copied.name;
      frame.path = "";
      frame.offsets = std::move(offsets);
      frame.own = false;
      model_.add_frame(std::move(frame));
      return model_.frames.size() - 1;
    };
    model_.closures.push_back({joint.element, {body, add_frame(body, {})}});
    end = add_frame(end, model_.frames[end].offsets);
    model_.bodies.push_back(std::move(copied));
    model_.joint_of.push_back(j);
    copies_[body].push_back(copy);
  }
  void share_mass(std::size_t body, const std::vector<std::size_t>& copies) {
    const double share = 1 / static_cast<double>(copies.size() + 1);
    const auto scale = [&](OsimBody& of) {
      of.mass *= share;
      for (double& entry : of.inertia) entry *= share;
    };
    scale(model_.bodies[body]);
    for (const std::size_t copy : copies) scale(model_.bodies[copy]);
  }

  const OsimXml& xml_;
  pugi::xml_node root_;
  OsimModel model_;
  std::vector<Pending> pending_;
  std::map<std::size_t, std::vector<std::size_t>> copies_;  // of bodies, where joints close chains
};

}  // namespace

Eigen::Isometry3d pose_of(const std::vector<OsimOffset>& offsets) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (const OsimOffset& offset : offsets) {
    out.translate(Eigen::Vector3d(offset.translation.data()));
    for (int i = 0; i < 3; ++i)
      out.rotate(
          Eigen::AngleAxisd(offset.orientation[static_cast<std::size_t>(i)], Eigen::Vector3d::Unit(i)));
  }
  return out;
}

void OsimModel::add_frame(OsimFrame frame) {
  // A joint's own place on a body has no name.
  if (!frame.path.empty()) {
    frame_of_path.try_emplace(frame.path, frames.size());
    frames_of_name[frame.name].push_back(frames.size());
  }
  frames.push_back(std::move(frame));
}

OsimModel read_osim_model(const OsimXml& xml, pugi::xml_node root) {
  return SkeletonReader(xml, root).read();
}

}  // namespace alembert
