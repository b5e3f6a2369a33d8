#include "import/mjcf/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <optional>

#include "import/mjcf/inertial.hpp"
#include "support/shortest_turn.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDeepestElement = 400;

using Words = std::initializer_list<std::string_view>;
const Words kBodyChildren = {"inertial", "joint",     "freejoint", "geom",   "site",
                             "body",     "camera",    "light",     "frame",  "replicate",
                             "attach",   "composite", "flexcomp",  "plugin", "include"};
const Words kBodyAttributes = {"name",  "childclass", "pos",      "quat",  "mocap", "axisangle", "xyaxes",
                               "zaxis", "euler",      "gravcomp", "sleep", "user",  "class"};
const Words kFrameAttributes = {"name", "childclass", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};
const Words kReplicateAttributes = {"count", "offset", "euler", "sep", "childclass"};
}  // namespace

MjcfTree::MjcfTree(MjcfFiles& files, MjcfModel& model) : files_(files), model_(model) {}

void MjcfTree::read() {
  model_.bodies.emplace_back().name = "world";
  bodies["world"] = 0;
  geoms_.emplace_back();
  Scope scope;
  scope.part.file = &files_.own();
  parts_.push_back(scope.part);
  read_worlds(scope);
  for (const MjcfGeom& geom : geoms_[0])
    if (geom.shape().kind != SolidKind::none) model_.bodies[0].shapes.push_back(geom.shape());
  sort_joints();
  set_total_mass();
}

void MjcfTree::read_worlds(Scope scope) {
  const MjcfText& text = scope.text();
  for (const pugi::xml_node world : text.children(text.root(), "worldbody")) {
    text.of(world).check_spelling(world, "the worldbody", kBodyChildren, kBodyAttributes);
    const pugi::xml_attribute childclass = world.attribute("childclass");
    scope.part.file->defaults.require(childclass);
    scope.childclass = childclass.value();
    read_children(world, scope);
  }
}

std::string MjcfTree::add_name(pugi::xml_node element, const Scope& scope, MjcfNames& names,
                               std::size_t index) {
  std::string name = scope.part.name(element.attribute("name").value());
  if (name.empty()) return name;
  if (!names.emplace(name, index).second)
    throw InputError(scope.text().where(element.attribute("name")),
                     fmt::format("a second {} '{}'", element.name(), printable(name)));
  return name;
}

void MjcfTree::read_children(pugi::xml_node parent, const Scope& scope) {
  if (++depth_ > kDeepestElement)
    throw InputError(
        scope.text().where(parent),
        fmt::format("with what is attached, elements are nested more than {} deep", kDeepestElement));
  for (const pugi::xml_node child : scope.text().children(parent)) {
    if (++count_ > kMaximumMjcfElements)
      throw InputError(scope.text().where(child),
                       fmt::format("the model has more than {} elements", kMaximumMjcfElements));
    const std::string_view kind = child.name();
    if (scope.compiler().global && (kind == "frame" || kind == "replicate" || kind == "attach"))
      throw InputError(scope.text().where(child),
                       fmt::format("a <{}> in a model with global coordinates", kind),
                       "global coordinates ended with MuJoCo 2.3.3, and this element came later");
    if (kind == "body") {
      read_body(child, scope);
    } else if (kind == "inertial") {
      read_inertial_of(child, scope);
    } else if (kind == "joint") {
      read_joint(child, scope);
    } else if (kind == "freejoint") {
      read_free_joint(child, scope);
    } else if (kind == "geom") {
      read_geom(child, scope);
    } else if (kind == "site") {
      read_place(child, scope, model_.sites, sites);
    } else if (kind == "camera") {
      read_place(child, scope, camera_places, cameras);
    } else if (kind == "frame") {
      read_frame(child, scope);
    } else if (kind == "replicate") {
      read_replicate(child, scope);
    } else if (kind == "attach") {
      read_attached(child, scope);
    } else if (kind == "composite" || kind == "flexcomp") {
      throw InputError(scope.text().where(child),
                       fmt::format("<{}> makes bodies that are not worked out here", kind),
                       "MuJoCo can save the model with these bodies written out (mj_saveLastXML)");
    } else if (kind == "plugin") {
      scope.text().warn({scope.text().where(child),
                         "a plugin is left out: its forces are not in the equations",
                         {},
                         "plugin"});
    }
  }
  --depth_;
}

void MjcfTree::read_attached(pugi::xml_node element, const Scope& scope) {
  scope.text().of(element).check_spelling(element, "an attach", {}, {"model", "body", "frame", "prefix"});
  const MjcfElement of(scope.text(), {element}, "an attach");
  if (!of.has("prefix")) throw InputError(of.where(), "no attribute 'prefix' of an attach");
  if (of.has("body") && of.has("frame")) throw of.error("frame", "a body or a frame is attached, not both");
  if (std::ranges::find(open_, element) != open_.end())
    throw InputError(of.where(), "what is attached here attaches itself");
  Scope inner = scope;
  inner.childclass.clear();
  inner.part.prefix += of.string("prefix");
  inner.part.whole = !of.has("body") && !of.has("frame");
  inner.part.attached = true;
  if (of.has("model"))
    inner.part.file = &files_.attached(*scope.part.file, of);
  else if (inner.part.whole)
    throw InputError(of.where(), "expected what is attached: a model, or a body or frame of this one");
  parts_.push_back(inner.part);
  open_.push_back(element);
  if (inner.part.whole) {
    read_worlds(inner);
  } else {
    const char* const kind = of.has("body") ? "body" : "frame";
    const std::string name = of.string(kind);
    const Attachables& all = attachables(*inner.part.file);
    const auto& known = of.has("body") ? all.bodies : all.frames;
    const auto found = known.find(name);
    if (found == known.end()) {
      std::vector<std::string> names;
      for (const auto& [each, at] : known) names.push_back(each);
      throw of.error(kind, fmt::format("there is no {} '{}' to be attached{}", kind, printable(name),
                                       did_you_mean(name, names)));
    }
    inner.childclass = found->second.childclass;
    if (of.has("body"))
      read_body(found->second.element, inner);
    else
      read_frame(found->second.element, inner);
  }
  open_.pop_back();
}

const MjcfTree::Attachables& MjcfTree::attachables(const MjcfFile& file) {
  const auto [found, is_new] = attachables_.try_emplace(&file);
  if (is_new)
    for (const pugi::xml_node world : file.text.children(file.text.root(), "worldbody"))
      find(file.text, world, world.attribute("childclass").value(), found->second);
  return found->second;
}

void MjcfTree::find(const MjcfText& text, pugi::xml_node parent, const std::string& childclass,
                    Attachables& to) {
  for (const pugi::xml_node child : text.children(parent)) {
    const std::string_view kind = child.name();
    if (kind != "body" && kind != "frame") continue;
    (kind == "body" ? to.bodies : to.frames)
        .try_emplace(child.attribute("name").value(), Found{child, childclass});
    const pugi::xml_attribute own = child.attribute("childclass");
    find(text, child, own ? own.value() : childclass, to);
  }
}

void MjcfTree::read_frame(pugi::xml_node element, Scope scope) {
  scope.text().of(element).check_spelling(element, "a frame", kBodyChildren, kFrameAttributes);
  const pugi::xml_attribute childclass = element.attribute("childclass");
  scope.part.file->defaults.require(childclass);
  if (childclass) scope.childclass = childclass.value();
  scope.frame = scope.frame * scope.compiler().pose({scope.text(), {element}, "a frame"});
  read_children(element, scope);
}

void MjcfTree::read_replicate(pugi::xml_node element, Scope scope) {
  scope.text().of(element).check_spelling(element, "a replicate", kBodyChildren, kReplicateAttributes);
  const MjcfElement of(scope.text(), {element}, "a replicate");
  const double count = of.number("count", 0);
  if (!(count >= 1 && count <= static_cast<double>(kMaximumMjcfElements) && count == std::floor(count)))
    throw of.error("count", fmt::format("expected a number of copies from 1 to {}", kMaximumMjcfElements));
  const pugi::xml_attribute childclass = element.attribute("childclass");
  scope.part.file->defaults.require(childclass);
  if (childclass) scope.childclass = childclass.value();
  const Eigen::Vector3d step = of.vector("offset", Eigen::Vector3d::Zero()),
                        angles = of.vector("euler", Eigen::Vector3d::Zero());
  const std::string outer = scope.part.suffix;
  const RigidPose first = scope.frame;
  RigidPose copy;
  scope.part.attached = true;
  scope.part.whole = false;
  const std::size_t digits = std::to_string(static_cast<std::size_t>(count)).size();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    scope.part.suffix = fmt::format("{}{:0{}}{}", of.string("sep"), i, digits, outer);
    scope.frame = first * copy;
    parts_.push_back(scope.part);
    read_children(element, scope);
    // Each copy is shifted in the axes of the one before it, and turned by a multiple of the angles.
    copy = {(copy * RigidPose{step}).shift, scope.compiler().euler_turn(static_cast<double>(i + 1) * angles),
            copy.longest()};
  }
}

void MjcfTree::read_body(pugi::xml_node element, const Scope& scope) {
  const MjcfElement of(scope.text(), {element},
                       fmt::format("body '{}'", printable(element.attribute("name").value())));
  scope.text().of(element).check_spelling(element, of.what(), kBodyChildren, kBodyAttributes);
  const std::size_t index = model_.bodies.size();
  MjcfBody& body = model_.bodies.emplace_back();
  geoms_.emplace_back();
  body.parent = scope.body;
  body.where = of.has("name") ? of.where("name") : of.where();
  body.name = add_name(element, scope, bodies, index);
  const pugi::xml_attribute childclass = element.attribute("childclass");
  scope.part.file->defaults.require(childclass);
  Scope inside{scope.part, index, {}, childclass ? childclass.value() : scope.childclass};
  if (scope.compiler().global) {
    const RigidPose in_world = global_pose(of, inside);
    body.pose = scope.frame * in_world;
    inside.frame = inverse(in_world);
  } else {
    body.pose = scope.frame * scope.compiler().pose(of);
  }
  body.weightless = of.number("gravcomp", 0);
  if (of.flag("mocap", false))
    scope.text().warn({of.where("mocap"),
                       fmt::format("{} is moved from outside (mocap); it stands still here", of.what()),
                       {},
                       "mocap"});
  read_children(element, inside);
  finish_body(index, of, scope);
}

/// Without a `pos`, the frame is where the body's mass is. Joints and shapes have places of their own: only the
/// coordinates of a free joint and the body's frame depend on it.
RigidPose MjcfTree::global_pose(const MjcfElement& body, const Scope& inside) const {
  const MjcfCompiler& compiler = inside.compiler();
  std::optional<RigidPose> said;
  if (body.has("pos"))
    inside.text().of(body.node()).tolerate("the body's frame is at its centre of mass", [&] {
      said = compiler.pose(body);
    });
  if (said) return *said;
  std::vector<MjcfGeom> shapes;
  for (const pugi::xml_node child : inside.text().children(body.node())) {
    const std::string_view kind = child.name();
    if (kind == "inertial" && compiler.inertia_from_geoms != MjcfCompiler::FromGeoms::yes)
      return compiler.pose({inside.text(), {child}, "the inertial of " + body.what()});
    if (kind == "geom")
      shapes.emplace_back(inside.element(child), RigidPose{}, compiler, inside.part.file->assets);
  }
  const BodyMass mass = mass_of_geoms(shapes, compiler);
  if (mass.mass == 0)
    throw InputError(body.where(),
                     fmt::format("no attribute 'pos' of {}, and no mass that tells its place", body.what()));
  if (const MjcfGeom* only = only_geom_with_mass(shapes, compiler)) return only->shape().pose;
  return {mass.centre, principal_turn(mass)};
}

void MjcfTree::read_inertial_of(pugi::xml_node element, const Scope& scope) {
  if (scope.body == 0)
    throw InputError(scope.text().where(element), "an inertial of the world, which does not move");
  if (!inertials_.emplace(scope.body, Inertial{element, &scope.text(), scope.frame}).second)
    throw InputError(scope.text().where(element), fmt::format("a second inertial of body '{}'",
                                                              printable(model_.bodies[scope.body].name)));
}

void MjcfTree::finish_body(std::size_t index, const MjcfElement& element, const Scope& scope) {
  using FromGeoms = MjcfCompiler::FromGeoms;
  const MjcfCompiler& compiler = scope.compiler();
  MjcfBody& body = model_.bodies[index];
  const std::vector<MjcfGeom>& own = geoms_[index];
  for (const MjcfGeom& geom : own) {
    if (geom.shape().kind != SolidKind::none) body.shapes.push_back(geom.shape());
    if (const std::optional<MjcfFluidShape> shape = geom.fluid_shape()) body.fluid_shapes.push_back(*shape);
  }
  const FromGeoms from = compiler.inertia_from_geoms;
  const auto given = inertials_.find(index);
  if (from == FromGeoms::yes || (from == FromGeoms::where_missing && given == inertials_.end())) {
    body.mass = mass_of_geoms(own, compiler);
    // Of one geom alone, MuJoCo takes its own axes.
    if (const MjcfGeom* only = only_geom_with_mass(own, compiler); only != nullptr && !only->is_mesh())
      body.inertial_turn = only->shape().pose.turn;
  } else if (given != inertials_.end()) {
    const MjcfElement inertial(*given->second.text, {given->second.element},
                               "the inertial of " + element.what());
    body.mass = read_inertial(inertial, given->second.frame, compiler);
    if (inertial.has("diaginertia")) body.inertial_turn = given->second.frame.turn * compiler.turn(inertial);
  }
  // What MuJoCo gives to a body that says nothing of its mass (boundmass) lies as far from it as it from its parent.
  if (body.mass.mass == 0 && given == inertials_.end()) {
    const RigidPose said = compiler.global ? body.pose : compiler.pose(element);
    body.mass.centre = said.shift;
    body.inertial_turn = said.turn;
  }
  body.turn_is_exact = body.inertial_turn.has_value();
  if (!body.inertial_turn) body.inertial_turn = principal_turn(body.mass);
  body.mass = corrected(body.mass, compiler, body.where, element.what());
}

void MjcfTree::read_free_joint(pugi::xml_node element, const Scope& scope) {
  scope.text().of(element).check_spelling(element, "a freejoint", {}, {"name", "group", "align", "class"});
  MjcfJoint joint;
  joint.type = MjcfJointType::free;
  joint.where = scope.text().where(element);
  if (std::string_view(element.attribute("align").value()) == "true")
    scope.text().warn({joint.where,
                       "align is passed over: the coordinates are those of the body's own frame",
                       {},
                       "align"});
  add_joint(element, scope, std::move(joint));
}

void MjcfTree::read_joint(pugi::xml_node element, const Scope& scope) {
  const MjcfElement of = scope.element(element);
  MjcfJoint joint;
  joint.where = of.where();
  joint.type = static_cast<MjcfJointType>(of.word("type", {"free", "ball", "slide", "hinge"}, 3));
  const bool hinge = joint.type == MjcfJointType::hinge, single = hinge || joint.type == MjcfJointType::slide;
  const auto radians = [&](double value) { return hinge ? scope.compiler().angle(value) : value; };
  if (joint.type != MjcfJointType::free) {
    joint.anchor = scope.frame * RigidPose{of.vector("pos", {0, 0, 0})};
    joint.anchor.turn.setIdentity();
  }
  if (single) {
    joint.axis = scope.frame.turn * of.vector("axis", {0, 0, 1});
    if (!(joint.axis.norm() > kNoDirection))
      throw of.error("axis", fmt::format("the axis of {} is 0", of.what()));
    joint.reference = radians(of.number("ref", 0));
    joint.rest = radians(of.number("springref", 0));
  }
  // Newer models may have the factors of higher powers behind the first.
  const auto first_only = [&](const char* name) {
    const std::vector<double> values = of.overlaid(name, 3);
    for (std::size_t i = 1; i < values.size(); ++i)
      if (values[i] != 0)
        throw of.error(name,
                       fmt::format("the {} of {} is a polynomial, which is not taken", name, of.what()));
    if (!values.empty() && values[0] < 0)
      throw of.error(name, fmt::format("the {} of {} is negative", name, of.what()));
    return values.empty() ? 0 : values[0];
  };
  joint.stiffness = first_only("stiffness");
  joint.damping = first_only("damping");
  joint.armature = of.number("armature", 0);
  joint.friction = of.number("frictionloss", 0);
  if (const std::vector<double> asked = of.list("springdamper", 2, 2);
      !asked.empty() && (asked[0] != 0 || asked[1] != 0)) {
    if (!(asked[0] > 0 && asked[1] > 0))
      throw of.error("springdamper", fmt::format("the springdamper of {} is not positive", of.what()));
    joint.spring_damper = {asked[0], asked[1]};
  }
  read_ranges(of, scope.compiler(), joint, single);
  add_joint(element, scope, std::move(joint));
}

void MjcfTree::read_ranges(const MjcfElement& of, const MjcfCompiler& compiler, MjcfJoint& joint,
                           bool single) {
  const bool hinge = joint.type == MjcfJointType::hinge;
  const std::vector<double> range = of.list("range", 2, 2), drive = of.list("actuatorfrcrange", 2, 2);
  const auto is_limited = [&](const char* flag, const std::vector<double>& values) {
    return !values.empty() && of.flag_or_auto(flag).value_or(compiler.autolimits && values[0] < values[1]);
  };
  if (is_limited("limited", range)) {
    if (!single)
      of.text().warn(
          {of.where("range"), fmt::format("the range of {} is left out", of.what()), {}, "range of a ball"});
    else if (!(range[0] < range[1]))
      throw of.error("range", fmt::format("the range of {} has no room", of.what()));
    else
      joint.limits = {hinge ? compiler.angle(range[0]) : range[0],
                      hinge ? compiler.angle(range[1]) : range[1]};
  }
  if (single && is_limited("actuatorfrclimited", drive)) joint.drive = {drive[0], drive[1]};
}

void MjcfTree::add_joint(pugi::xml_node element, const Scope& scope, MjcfJoint joint) {
  const std::size_t index = model_.joints.size();
  joint.body = scope.body;
  if (const pugi::xml_attribute name = element.attribute("name")) joint.where = scope.text().where(name);
  if (scope.body == 0) throw InputError(joint.where, "a joint of the world, which does not move");
  MjcfBody& body = model_.bodies[scope.body];
  std::size_t speeds = speed_count(joint.type);
  for (const std::size_t other : body.joints) {
    const MjcfJointType type = model_.joints[other].type;
    speeds += speed_count(type);
    if (type == MjcfJointType::free || joint.type == MjcfJointType::free)
      throw InputError(joint.where, "a body with a free joint has no other one");
    if (type == MjcfJointType::ball && joint.type != MjcfJointType::slide)
      throw InputError(joint.where, "a rotation after a ball joint of the same body");
  }
  if (speeds > 6) throw InputError(joint.where, "the joints of one body have more than six speeds");
  if (joint.type == MjcfJointType::free && body.parent != 0)
    throw InputError(joint.where, "a free joint is of a child of the world only");
  joint.name = add_name(element, scope, joints, index);
  body.joints.push_back(index);
  model_.joints.push_back(std::move(joint));
}

/// In the order of bodies, wherever joints stand in them.
void MjcfTree::sort_joints() {
  std::vector<std::size_t> order(model_.joints.size()), place(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t joint) { return model_.joints[joint].body; });
  std::vector<MjcfJoint> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.push_back(model_.joints[order[i]]);
  }
  model_.joints = std::move(sorted);
  for (auto& [name, joint] : joints) joint = place[joint];
  for (MjcfBody& body : model_.bodies)
    for (std::size_t& joint : body.joints) joint = place[joint];
}

void MjcfTree::read_place(pugi::xml_node element, const Scope& scope, std::vector<MjcfPlace>& places,
                          MjcfNames& names) {
  const MjcfElement of = scope.element(element);
  MjcfPlace place;
  place.body = scope.body;
  place.where = of.has("name") ? of.where("name") : of.where();
  RigidPose pose = scope.compiler().pose(of);
  if (const std::vector<double> ends = of.list("fromto", 6, 6); !ends.empty()) {
    const Eigen::Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
    if (from == to) throw of.error("fromto", fmt::format("the ends of {} are one point", of.what()));
    pose = {(from + to) / 2, shortest_turn(Eigen::Vector3d::UnitZ(), from - to)};
  }
  place.pose = scope.frame * pose;
  place.name = add_name(element, scope, names, places.size());
  places.push_back(std::move(place));
}

void MjcfTree::read_geom(pugi::xml_node element, const Scope& scope) {
  const MjcfElement of = scope.element(element);
  MjcfGeom geom(of, scope.frame, scope.compiler(), scope.part.file->assets);
  MjcfPlace place;
  place.body = scope.body;
  place.where = of.where();
  place.pose = geom.shape().pose;
  place.of_mesh = geom.is_mesh();
  const SolidKind kind = geom.shape().kind;
  if (kind == SolidKind::sphere || kind == SolidKind::cylinder)
    place.round = MjcfRound{kind == SolidKind::cylinder, geom.shape().sizes[0]};
  place.name = add_name(element, scope, geoms, geom_places.size());
  geom_places.push_back(std::move(place));
  geoms_[scope.body].push_back(std::move(geom));
}

void MjcfTree::set_total_mass() {
  const double total = files_.own().compiler.total_mass;
  if (!(total > 0)) return;
  double sum = 0;
  for (const MjcfBody& body : model_.bodies) sum += body.mass.mass;
  if (!(sum > 0)) return;
  for (MjcfBody& body : model_.bodies) body.mass = body.mass.times(total / sum);
}

}  // namespace alembert
