#include "import/sdf/sdf_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/sdf/sdf_spelling.hpp"

namespace alembert {
namespace {

constexpr double kUnlimited = 1e16;

struct SdfTypeName {
  std::string_view name;
  SdfJointType type;
  std::size_t axes;
};

constexpr SdfTypeName kSdfTypes[] = {
    {"revolute", SdfJointType::revolute, 1},   {"continuous", SdfJointType::revolute, 1},
    {"prismatic", SdfJointType::prismatic, 1}, {"screw", SdfJointType::screw, 1},
    {"universal", SdfJointType::universal, 2}, {"revolute2", SdfJointType::universal, 2},
    {"ball", SdfJointType::ball, 0},           {"fixed", SdfJointType::fixed, 0},
    {"gearbox", SdfJointType::fixed, 2},
};

/// A gearbox couples two hinges that are there already.
struct Gearbox {
  std::size_t joint = 0;  ///< its frame and axes
  std::size_t reference = kSdfWorld;
  double ratio = 1;
};

class SdfJointReader {
 public:
  SdfJointReader(const SdfFiles& files, SdfScopes& scopes, SdfModel& model)
      : files_(files), scopes_(scopes), model_(model) {}

  void read() {
    for (std::size_t scope = 0; scope < scopes_.all.size(); ++scope)
      for (std::size_t i = 0; i < scopes_.all[scope].named.size(); ++i)
        if (scopes_.all[scope].named[i].kind == SdfKind::joint) read(scope, i);
    for (const Gearbox& gearbox : gearboxes_) couple(gearbox);
    std::vector<std::size_t> index(model_.joints.size(), 0);
    for (const Gearbox& gearbox : gearboxes_) index[gearbox.joint] = kNoSdf;
    remove_gearboxes(index);
  }

 private:
  void read(std::size_t scope, std::size_t i) {
    const SdfNamed named = scopes_.all[scope].named[i];
    const pugi::xml_node node = named.node;
    check_sdf_spelling(files_, node);
    SdfJoint& joint = model_.joints[named.index];
    joint.name = scopes_.all[scope].prefix + named.name;
    joint.where = named.where;
    joint.type_where = files_.where(node, "type");
    const XmlText& text = files_.of(node);
    const std::string what = sdf_title(node);
    const SdfTypeName& type = type_of(node, what);
    joint.type = type.type;
    const pugi::xml_node parent = text.require(node, "parent", what),
                         child = text.require(node, "child", what);
    joint.parent = moving_link(scope, named.base, parent);
    joint.child = moving_link(scope, named.base, child);
    const RigidPose frame = scopes_.in_world(scope) * scopes_.pose(scope, i);
    const auto in = [&](std::size_t link) {
      return link == kSdfWorld ? frame : inverse(model_.links[link].pose) * frame;
    };
    joint.in_parent = in(joint.parent);
    joint.in_child = in(joint.child);
    joint.cut_first = files_.flag(node.child("physics").child("simbody"), "must_be_loop_joint", false);
    if (type.axes == 1 && !node.child("axis")) {
      files_.warn({joint.where, fmt::format("no <axis> in {}; the z axis is taken", what), {}, "no axis"});
      joint.axes.emplace_back().where = joint.where;
    }
    for (std::size_t a = joint.axes.size(); a < type.axes; ++a)
      joint.axes.push_back(read_axis(scope, i, text.require(node, a == 0 ? "axis" : "axis2", what)));
    for (const char* other : {"axis", "axis2"}) warn_of_dynamics(joint, node.child(other), what);
    if (type.name == "continuous")
      for (SdfAxis& axis : joint.axes) axis.limits.reset();
    if (joint.type == SdfJointType::screw) read_pitch(node, named.minor, joint);
    for (const char* kind : {"sensor", "plugin"})
      for ([[maybe_unused]] const pugi::xml_node each : node.children(kind)) ++model_.left_out[kind];
    if (type.name == "gearbox") {
      const pugi::xml_node reference = text.require(node, "gearbox_reference_body", what);
      gearboxes_.push_back(
          {named.index, moving_link(scope, named.base, reference), files_.number(node, "gearbox_ratio", 1)});
    } else if (joint.parent == joint.child) {
      const bool world = joint.parent == kSdfWorld;
      // Joints of what stands still.
      if (!world)
        throw InputError(joint.where, fmt::format("{} joins link '{}' to itself", what,
                                                  printable(model_.links[joint.child].name)));
    }
  }

  /// Of an axis that a joint does not have.
  void warn_of_dynamics(const SdfJoint& joint, pugi::xml_node axis, const std::string& what) const {
    const pugi::xml_node dynamics = axis.child("dynamics");
    if (joint.type != SdfJointType::ball || !dynamics) return;
    for (const char* kind : {"damping", "friction", "spring_stiffness"})
      if (files_.number(dynamics, kind, 0) != 0)
        files_.warn({files_.where(dynamics.child(kind)),
                     fmt::format("{} has no axes: the <{}> of its <{}> is left out", what, kind, axis.name()),
                     "write a force by the speeds of the joint", "no axes"});
  }

  static const SdfTypeName* find_type(std::string_view name) {
    const auto found = std::ranges::find(kSdfTypes, name, &SdfTypeName::name);
    return found == std::end(kSdfTypes) ? nullptr : found;
  }
  const SdfTypeName& type_of(pugi::xml_node node, const std::string& what) const {
    const pugi::xml_attribute attribute = files_.of(node).require_attribute(node, "type", what);
    std::string name = attribute.value();
    std::ranges::transform(name, name.begin(), [](char c) {
      return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    if (const SdfTypeName* found = find_type(name)) return *found;
    std::vector<std::string> known;
    for (const SdfTypeName& each : kSdfTypes) known.emplace_back(each.name);
    throw InputError(
        files_.of(node).where(attribute),
        fmt::format("unknown type '{}' of {}{}", printable(attribute.value()), what,
                    did_you_mean(name, known)),
        "joints are revolute, continuous, prismatic, screw, universal, revolute2, gearbox, ball, fixed");
  }

  /// The link that an element names; the world for one that stands still.
  std::size_t moving_link(std::size_t scope, std::size_t base, pugi::xml_node element) {
    const std::string name = SdfFiles::text(element);
    const SourceLocation where = files_.where_text(element);
    if (name.empty()) throw InputError(where, fmt::format("<{}> names no link", element.name()));
    const std::size_t link = scopes_.link(scope, base, name, where);
    return link != kSdfWorld && model_.links[link].fixed ? kSdfWorld : link;
  }

  SdfAxis read_axis(std::size_t scope, std::size_t i, pugi::xml_node node) {
    check_sdf_spelling(files_, node);
    const SdfNamed named = scopes_.all[scope].named[i];
    const std::string what = fmt::format("the {} of {}", node.name(), sdf_title(named.node));
    SdfAxis out;
    out.where = files_.where(node);
    const pugi::xml_node xyz = node.child("xyz");
    check_sdf_spelling(files_, xyz);
    out.xyz = files_.vector(node, "xyz", out.xyz);
    if (out.xyz.norm() == 0) throw InputError(files_.where_text(xyz), fmt::format("{} has length 0", what));
    const bool in_model =
        named.minor <= 4 || (named.minor <= 6 && files_.flag(node, "use_parent_model_frame", false));
    const std::string expressed = in_model ? "__model__" : xyz.attribute("expressed_in").value();
    if (!expressed.empty()) {
      const SourceLocation where = in_model ? out.where : files_.where(xyz, "expressed_in");
      out.xyz = scopes_.pose(scope, i).turn.conjugate() *
                (scopes_.pose(scope, named.base, expressed, where).turn * out.xyz);
      const double rounding = 1e-15 * out.xyz.norm();
      for (double& entry : out.xyz)
        if (std::abs(entry) < rounding) entry = 0;
    }
    out.xyz.normalize();
    read_dynamics(node, what, out);
    if (const pugi::xml_node mimic = files_.of(node).find(node, "mimic", what)) read_mimic(scope, mimic, out);
    return out;
  }

  void read_dynamics(pugi::xml_node node, const std::string& what, SdfAxis& out) {
    const pugi::xml_node dynamics = files_.of(node).find(node, "dynamics", what);
    check_sdf_spelling(files_, dynamics);
    out.damping = files_.number(dynamics, "damping", 0);
    out.friction = files_.number(dynamics, "friction", 0);
    out.stiffness = files_.number(dynamics, "spring_stiffness", 0);
    out.rest = files_.number(dynamics, "spring_reference", 0);
    out.initial = files_.number(node, "initial_position", 0);
    const pugi::xml_node limit = files_.of(node).find(node, "limit", what);
    check_sdf_spelling(files_, limit);
    const auto read = [&](const char* name, double otherwise) {
      double value = otherwise;
      files_.of(node).tolerate("it is left out",
                               [&] { value = files_.number_or_infinite(limit, name, otherwise); });
      return value;
    };
    const double lower = read("lower", -kUnlimited), upper = read("upper", kUnlimited);
    const bool below = lower > -kUnlimited, above = upper < kUnlimited;
    if (below && above && lower < upper) {
      out.limits = {lower, upper};
    } else if (below && above) {
      files_.warn(
          {files_.where(limit),
           fmt::format("the limits of {} leave no room: lower {:.6g}, upper {:.6g}; they are left out", what,
                       lower, upper),
           "a joint that stands still is fixed", "no room"});
    } else if (below || above) {
      files_.warn(
          {files_.where(limit), fmt::format("{} has one limit only; it is left out", what), {}, "one limit"});
    }
    const auto largest = [&](const char* name, std::optional<double>& to) {
      const double value = read(name, -1);
      if (value > 0 && value < kUnlimited) to = value;
    };
    largest("effort", out.effort);
    largest("velocity", out.speed);
  }

  void read_mimic(std::size_t scope, pugi::xml_node node, SdfAxis& out) {
    check_sdf_spelling(files_, node);
    SdfMimic mimic;
    const pugi::xml_attribute name = files_.of(node).require_attribute(node, "joint", "a mimic");
    mimic.where = files_.of(node).where(name);
    mimic.joint = scopes_.joint(scope, name.value(), mimic.where);
    const std::string axis = node.attribute("axis").value();
    if (!axis.empty() && axis != "axis" && axis != "axis2")
      throw InputError(files_.where(node, "axis"),
                       fmt::format("a mimic follows 'axis' or 'axis2', not '{}'", printable(axis)));
    mimic.axis = axis == "axis2" ? 1 : 0;
    mimic.multiplier = files_.number(node, "multiplier", 1);
    mimic.offset = files_.number(node, "offset", 0);
    mimic.reference = files_.number(node, "reference", 0);
    out.mimic = mimic;
  }

  /// Metres per turn of a right-handed thread; before 1.10, radians per metre of a left-handed one.
  void read_pitch(pugi::xml_node node, int minor, SdfJoint& joint) {
    const bool older = node.child("thread_pitch") || minor < 10;
    if (node.child("screw_thread_pitch") || !older) {
      joint.pitch = files_.number(node, "screw_thread_pitch", 1) / (2 * std::numbers::pi);
    } else {
      const double pitch = files_.number(node, "thread_pitch", 1);
      if (pitch == 0)
        throw InputError(files_.where_text(node.child("thread_pitch")),
                         "a thread_pitch of 0 radians per metre is no screw");
      joint.pitch = -1 / pitch;
    }
    if (!node.child("screw_thread_pitch") && !node.child("thread_pitch"))
      files_.warn(
          {joint.where,
           fmt::format("screw '{}' says no pitch; it is 1 {}, as SDF 1.{} has it", printable(joint.name),
                       older ? "radian per metre, left-handed" : "metre per turn, right-handed", minor),
           {},
           "no pitch"});
  }

  struct Hinge {
    std::size_t joint;
    double sign;  ///< the angle from the reference body is this times the joint's
  };
  /// The hinge between a gearbox' reference body and one of its links.
  Hinge hinge(const Gearbox& gearbox, std::size_t link, std::size_t axis) {
    const SdfJoint& of = model_.joints[gearbox.joint];
    const auto world = [&](const SdfJoint& joint) {
      return joint.child == kSdfWorld ? joint.in_child : model_.links[joint.child].pose * joint.in_child;
    };
    const Eigen::Vector3d along = world(of).turn * of.axes[axis].xyz;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const SdfJoint& joint = model_.joints[j];
      if (joint.type != SdfJointType::revolute) continue;
      const bool forward = joint.parent == gearbox.reference && joint.child == link;
      const bool back = joint.child == gearbox.reference && joint.parent == link;
      if (!forward && !back) continue;
      const double cosine = along.dot(world(joint).turn * joint.axes[0].xyz);
      if (std::abs(std::abs(cosine) - 1) > 1e-6) continue;
      return {j, (cosine > 0 ? 1.0 : -1.0) * (forward ? 1.0 : -1.0)};
    }
    const auto name = [&](std::size_t body) {
      return body == kSdfWorld ? std::string("the world")
                               : fmt::format("'{}'", printable(model_.links[body].name));
    };
    throw InputError(
        of.where,
        fmt::format("the gearbox '{}' couples no hinges: no revolute joint about its {} joins {} and {}",
                    printable(of.name), axis == 0 ? "axis" : "axis2", name(gearbox.reference), name(link)));
  }

  void couple(const Gearbox& gearbox) {
    const SdfJoint& of = model_.joints[gearbox.joint];
    const Hinge first = hinge(gearbox, of.parent, 0), second = hinge(gearbox, of.child, 1);
    SdfAxis &driving = model_.joints[first.joint].axes[0], &driven = model_.joints[second.joint].axes[0];
    // second angle = -ratio * first angle
    const double factor = -gearbox.ratio * first.sign * second.sign;
    SdfMimic mimic;
    mimic.where = of.where;
    mimic.joint = first.joint;
    mimic.multiplier = factor;
    if (!driven.mimic) {
      driven.mimic = mimic;
    } else if (!driving.mimic && factor != 0) {
      mimic.joint = second.joint;
      mimic.multiplier = 1 / factor;
      driving.mimic = mimic;
    } else {
      throw InputError(
          of.where, fmt::format("both hinges of the gearbox '{}' follow others already", printable(of.name)));
    }
  }

  /// \param index  by joint: kNoSdf for those that go
  void remove_gearboxes(std::vector<std::size_t>& index) {
    std::vector<SdfJoint> kept;
    for (std::size_t j = 0; j < index.size(); ++j) {
      if (index[j] == kNoSdf) continue;
      index[j] = kept.size();
      kept.push_back(std::move(model_.joints[j]));
    }
    for (SdfJoint& joint : kept) {
      for (SdfAxis& axis : joint.axes) {
        if (!axis.mimic) continue;
        if (index[axis.mimic->joint] == kNoSdf)
          throw InputError(axis.mimic->where, "a gearbox has no position");
        axis.mimic->joint = index[axis.mimic->joint];
      }
    }
    model_.joints = std::move(kept);
  }

  const SdfFiles& files_;
  SdfScopes& scopes_;
  SdfModel& model_;
  std::vector<Gearbox> gearboxes_;
};

}  // namespace

void read_sdf_joints(const SdfFiles& files, SdfScopes& scopes, SdfModel& model) {
  SdfJointReader(files, scopes, model).read();
}

}  // namespace alembert
