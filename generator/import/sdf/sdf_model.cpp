// XML in, a model out: names and frames of all scopes first, then what they hold.
#include "import/sdf/sdf_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <map>
#include <set>
#include <string_view>

#include "import/sdf/sdf_joints.hpp"
#include "import/sdf/sdf_links.hpp"
#include "import/sdf/sdf_spelling.hpp"

namespace alembert {
namespace {

constexpr int kMaximumModelDepth = 50;
constexpr std::size_t kMaximumNamed = 200000, kMaximumFollowing = 100;
constexpr int kOldestMinor = 3, kNewestMinor = 12;
/// Gravity of a world that says none.
const Eigen::Vector3d kSdfGravity(0, 0, -9.8);

/// What an <include> says in place of the model itself.
struct SdfOverride {
  pugi::xml_node include;
  std::string name;
};

class SdfReader {
 public:
  SdfReader(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
            Warnings& warnings)
      : files_(std::move(source), folders, warnings) {}

  SdfModel read() {
    const pugi::xml_node root = files_.root();
    const int minor = version_of(root);
    model_.where = files_.where(root);
    scopes_.all.emplace_back();
    const pugi::xml_node world = root.child("world");
    if (world) {
      read_world(root, world, minor);
    } else {
      model_.name = "world";
      read_contents(root, 0, kNoSdf, minor, 0);
    }
    name_by_only_model();
    read_links();
    for (std::size_t j = 0; j < joint_count_; ++j) model_.joints.emplace_back();
    read_sdf_joints(files_, scopes_, model_);
    read_frames();
    check_mimics();
    model_.places = files_.places();
    model_.files.assign(files_.named_files().begin(), files_.named_files().end());
    return std::move(model_);
  }

 private:
  int version_of(pugi::xml_node root) const {
    if (std::string_view(root.name()) != "sdf")
      throw InputError(
          files_.where(root), fmt::format("expected an <sdf>, found <{}>", printable(root.name())),
          std::string_view(root.name()) == "robot" ? "a URDF is imported on its own, not as an SDF" : "");
    check_sdf_spelling(files_, root);
    const pugi::xml_attribute attribute = root.attribute("version");
    if (!attribute) {
      files_.warn({files_.where(root), "no version of <sdf>; it is read as 1.11", {}, "no version"});
      return 11;
    }
    const std::string_view text = attribute.value();
    int minor = -1;
    if (text.starts_with("1.")) std::from_chars(text.data() + 2, text.data() + text.size(), minor);
    const SourceLocation where = files_.of(root).where(attribute);
    if (minor < kOldestMinor)
      throw InputError(where, fmt::format("version '{}' of SDF is not read", printable(text)),
                       "versions 1.3 to 1.12 are");
    if (minor > kNewestMinor)
      files_.warn({where, fmt::format("version '{}' of SDF is read as 1.{}", printable(text), kNewestMinor)});
    return minor;
  }

  void read_world(pugi::xml_node root, pugi::xml_node world, int minor) {
    check_sdf_spelling(files_, world);
    model_.name = world.attribute("name").value();
    model_.where = files_.where(world, "name");
    if (const pugi::xml_node other = world.next_sibling("world"))
      files_.warn({files_.where(other), "a second <world>; the first is read"});
    if (const pugi::xml_node other = root.child("model"))
      files_.warn({files_.where(other), "a model beside the world; it is left out"});
    if (const pugi::xml_node state = world.child("state"))
      files_.warn({files_.where(state),
                   "the <state> of a world is left out: models begin where they say themselves"});
    if (const pugi::xml_node population = world.child("population"))
      throw InputError(files_.where(population), "a <population> cannot be expressed",
                       "write its models one by one");
    const pugi::xml_node physics = world.child("physics");
    model_.gravity = files_.vector(world, "gravity",
                                   minor <= 5 ? files_.vector(physics, "gravity", kSdfGravity) : kSdfGravity);
    warn_of_wind(world);
    read_contents(world, 0, kNoSdf, minor, 0);
  }

  void warn_of_wind(pugi::xml_node world) {
    const pugi::xml_node wind = world.child("wind");
    if (files_.vector(wind, "linear_velocity", Eigen::Vector3d::Zero()).isZero(0)) return;
    const pugi::xml_node blown = world.find_node([&](pugi::xml_node node) {
      return std::string_view(node.name()) == "enable_wind" &&
             files_.flag(node.parent(), "enable_wind", false);
    });
    if (blown)
      files_.warn({files_.where(wind), "wind is left out", "write its force on a link as a force", "wind"});
  }

  /// Links, joints, frames and models of an element. \param base  as in SdfNamed
  void read_contents(pugi::xml_node element, std::size_t scope, std::size_t base, int minor, int depth) {
    if (depth > kMaximumModelDepth)
      throw InputError(files_.where(element),
                       fmt::format("models are nested more than {} deep", kMaximumModelDepth));
    NamesOfKinds names;
    for (const pugi::xml_node child : element.children())
      names[child.name()].emplace(child.attribute("name").value());
    for (const pugi::xml_node child : element.children()) {
      const std::string_view kind = child.name();
      if (kind == "model") {
        SdfOverride by;
        if (scope != 0) by.name = distinct_name(child, names, {"link"}, minor);
        read_model(child, scope, base, minor, depth, by);
      } else if (kind == "include") {
        read_include(child, scope, base, minor, depth);
      } else if (kind == "link" || kind == "frame" || kind == "joint") {
        read_named(child, kind, scope, base, minor, names);
      } else if (kind == "plugin" || kind == "light" || kind == "actor" || kind == "gripper") {
        ++model_.left_out[std::string(kind)];
      } else if (kind.starts_with("drake:")) {
        files_.warn({files_.where(child),
                     fmt::format("<{}> is of Drake alone; it is left out", printable(kind)),
                     {},
                     std::string(kind)});
      }
    }
  }

  /// Names of siblings by the kind of element.
  using NamesOfKinds = std::map<std::string_view, std::set<std::string_view>>;

  /// Up to version 1.6 siblings of two kinds could have one name: libsdformat tells them apart as this does.
  static std::string distinct_name(pugi::xml_node node, const NamesOfKinds& names,
                                   std::initializer_list<const char*> before, int minor) {
    std::string name = node.attribute("name").value();
    const auto taken = [&](const char* kind) {
      const auto of = names.find(kind);
      return of != names.end() && of->second.contains(name);
    };
    const std::string_view kind = node.name();
    if (minor < 7 && std::ranges::any_of(before, taken))
      name += kind == "model" ? "_nested_model" : fmt::format("_{}", kind);
    return name;
  }

  void read_named(pugi::xml_node node, std::string_view kind, std::size_t scope, std::size_t base, int minor,
                  const NamesOfKinds& names) {
    SdfNamed named = begin(node, base, minor);
    if (kind == "link") {
      named.kind = SdfKind::link;
      named.index = link_count_++;
    } else if (kind == "joint") {
      named.kind = SdfKind::joint;
      if (named.name == "world")
        files_.warn(
            {named.where,
             "a joint is called 'world': as a parent or child, 'world' is the world, and not this joint"});
      named.name = distinct_name(node, names, {"link", "model"}, minor);
      named.index = joint_count_++;
      const pugi::xml_node child = node.child("child");
      named.attached_to = SdfFiles::text(child);
      named.attached_where = child ? files_.where_text(child) : named.where;
    } else {
      check_sdf_spelling(files_, node);
      named.kind = SdfKind::frame;
      named.name = distinct_name(node, names, {"link", "model", "joint"}, minor);
      named.attached_to = node.attribute("attached_to").value();
      named.attached_where = files_.where(node, "attached_to");
    }
    scopes_.add(scope, std::move(named));
  }

  /// What all that is named has: a name and a pose.
  SdfNamed begin(pugi::xml_node node, std::size_t base, int minor) {
    if (++named_count_ > kMaximumNamed)
      throw InputError(files_.where(node), "too many links, joints, frames and models");
    SdfNamed named;
    named.node = node;
    named.name = files_.of(node).require_attribute(node, "name", sdf_title(node)).value();
    named.where = files_.where(node, "name");
    named.base = base;
    named.minor = minor;
    set_pose(named, node);
    return named;
  }
  void set_pose(SdfNamed& named, pugi::xml_node owner) const {
    const pugi::xml_node pose = files_.of(owner).find(owner, "pose", sdf_title(owner));
    check_sdf_spelling(files_, pose);
    named.pose = pose ? files_.pose(pose) : RigidPose{};
    const char* attribute = pose.attribute("relative_to") ? "relative_to" : "frame";
    named.relative_to = pose.attribute(attribute).value();
    named.relative_where = pose ? files_.where(pose, attribute) : named.where;
  }

  void read_model(pugi::xml_node node, std::size_t scope, std::size_t base, int minor, int depth,
                  const SdfOverride& by) {
    check_sdf_spelling(files_, node);
    SdfNamed named = begin(node, base, minor);
    if (!by.name.empty()) named.name = by.name;
    named.kind = SdfKind::model;
    SdfScope inner;
    inner.where = named.where;
    inner.parent = scope;
    inner.name = scopes_.all[scope].name.empty() ? named.name : scopes_.all[scope].name + "::" + named.name;
    inner.fixed = files_.flag(node, "static", false);
    inner.placement = node.attribute("placement_frame").value();
    inner.canonical = node.attribute("canonical_link").value();
    if (by.include) {
      inner.fixed = files_.flag(by.include, "static", inner.fixed);
      named.where = files_.where(by.include);
      if (by.include.child("pose")) set_pose(named, by.include);
      if (const std::string placement = SdfFiles::text(by.include.child("placement_frame"));
          !placement.empty())
        inner.placement = placement;
    }
    const std::size_t index = scopes_.all.size();
    named.index = index;
    inner.as_named = scopes_.add(scope, std::move(named));
    scopes_.all.push_back(std::move(inner));
    read_contents(node, index, kNoSdf, minor, depth + 1);
  }

  void read_include(pugi::xml_node node, std::size_t scope, std::size_t base, int outer_minor, int depth) {
    check_sdf_spelling(files_, node);
    if (SdfFiles::is_scenery(node)) {
      ++model_.left_out["scenery"];
      return;
    }
    if (const pugi::xml_node changes = node.child("experimental:params"))
      throw InputError(files_.where(changes),
                       "what <experimental:params> changes of the included model is not read",
                       "write the changed model into a file of its own");
    const pugi::xml_node root = files_.include(node);
    const int minor = version_of(root);
    const pugi::xml_node model = root.child("model");
    const SourceLocation uri = files_.where_text(node.child("uri"));
    if (!model) {
      if (!root.child("actor") && !root.child("light"))
        throw InputError(uri, fmt::format("'{}' has no model", printable(SdfFiles::text(node.child("uri")))));
      ++model_.left_out[root.child("actor") ? "actor" : "light"];
      return files_.close();
    }
    if (const pugi::xml_node other = model.next_sibling("model"))
      files_.warn({files_.where(other), "a second model in a file that is included; the first is read"});
    if (files_.flag(node.attribute("merge"), node, false)) {
      merge(node, model, scope, base, outer_minor, minor, depth);
    } else {
      read_model(model, scope, base, minor, depth, {node, SdfFiles::text(node.child("name"))});
    }
    files_.close();
  }

  /// The contents of a model, in the names of the one that includes it.
  void merge(pugi::xml_node node, pugi::xml_node model, std::size_t scope, std::size_t base, int outer_minor,
             int minor, int depth) {
    check_sdf_spelling(files_, model);
    if (node.child("placement_frame") || model.attribute("placement_frame"))
      throw InputError(files_.where(node), "an include with merge and a placement frame is not read",
                       "give the pose of the model instead");
    SdfNamed frame = begin(model, base, outer_minor);
    frame.name = fmt::format("_merged__{}__model__", frame.name);
    frame.where = files_.where(node);
    frame.kind = SdfKind::frame;
    frame.carrier = model.attribute("canonical_link").value();
    if (frame.carrier.empty()) frame.carrier = model.child("link").attribute("name").value();
    if (node.child("pose")) set_pose(frame, node);
    const std::size_t index = scopes_.add(scope, std::move(frame));
    merged_.emplace_back(scope, index);
    read_contents(model, scope, index, minor, depth + 1);
  }

  /// The only model that moves needs no name before those of its links.
  void name_by_only_model() {
    std::vector<std::size_t> moving;
    for (std::size_t i = 1; i < scopes_.all.size(); ++i)
      if (scopes_.all[i].parent == 0 && !scopes_.all[i].fixed) moving.push_back(i);
    const std::string only = moving.size() == 1 ? scopes_.all[moving[0]].name : "";
    if (!only.empty() && (model_.name.empty() || !files_.root().child("world"))) model_.name = only;
    for (std::size_t i = 1; i < scopes_.all.size(); ++i) {
      SdfScope& scope = scopes_.all[i];
      scope.prefix = scope.name + "::";
      if (!only.empty() && scope.prefix.starts_with(only + "::")) scope.prefix.erase(0, only.size() + 2);
    }
  }

  void read_links() {
    model_.links.resize(link_count_);
    for (std::size_t scope = 0; scope < scopes_.all.size(); ++scope)
      for (std::size_t i = 0; i < scopes_.all[scope].named.size(); ++i)
        if (scopes_.all[scope].named[i].kind == SdfKind::link)
          model_.links[scopes_.all[scope].named[i].index] =
              read_sdf_link(files_, scopes_, scope, i, model_.left_out);
  }

  void read_frames() {
    for (std::size_t scope = 0; scope < scopes_.all.size(); ++scope) {
      const SdfScope of = scopes_.all[scope];
      if (!of.canonical.empty()) scopes_.link(scope, kNoSdf, of.canonical, of.where);
      for (std::size_t i = 0; i < scopes_.all[scope].named.size(); ++i) {
        const SdfNamed named = scopes_.all[scope].named[i];
        if (named.kind != SdfKind::frame || std::ranges::find(merged_, std::pair(scope, i)) != merged_.end())
          continue;
        SdfFrame frame;
        frame.name = scopes_.all[scope].prefix + named.name;
        frame.where = named.where;
        frame.link = scopes_.link(scope, named.base, named.name, named.where);
        const RigidPose in_world = scopes_.in_world(scope) * scopes_.pose(scope, i);
        if (frame.link != kSdfWorld && model_.links[frame.link].fixed) frame.link = kSdfWorld;
        frame.pose = frame.link == kSdfWorld ? in_world : inverse(model_.links[frame.link].pose) * in_world;
        model_.frames.push_back(std::move(frame));
      }
    }
  }

  /// Followers have something to follow, and in the end something that follows nothing.
  void check_mimics() const {
    for (const SdfJoint& joint : model_.joints) {
      for (const SdfAxis& axis : joint.axes) {
        const SdfAxis* at = &axis;
        for (std::size_t steps = 0; at->mimic; ++steps) {
          const SdfMimic& mimic = *at->mimic;
          const SdfJoint& leader = model_.joints[mimic.joint];
          if (mimic.axis >= leader.axes.size())
            throw InputError(mimic.where,
                             fmt::format("joint '{}' has no {} to follow", printable(leader.name),
                                         mimic.axis == 0 ? "axis" : "axis2"));
          if (steps > kMaximumFollowing || &leader.axes[mimic.axis] == &axis)
            throw InputError(axis.mimic->where,
                             fmt::format("joint '{}' follows itself", printable(joint.name)));
          at = &leader.axes[mimic.axis];
        }
      }
    }
  }

  SdfFiles files_;
  SdfScopes scopes_;
  SdfModel model_;
  std::size_t link_count_ = 0, joint_count_ = 0, named_count_ = 0;
  std::vector<std::pair<std::size_t, std::size_t>>
      merged_;  ///< scope and index of frames that stand for merged models
};

}  // namespace

SdfModel read_sdf(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
                  Warnings& warnings) {
  return SdfReader(std::move(source), folders, warnings).read();
}

}  // namespace alembert
