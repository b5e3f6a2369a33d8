// Joints: names for common products of factors.
#include "mechanism/joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "mechanism/coordinates.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transforms.hpp"

namespace alembert {
namespace {

/// What a type of joint takes. `coordinates` names them in order.
struct JointType {
  std::string_view name;
  std::string_view coordinates;
  int count;
  bool axis, axes, pitch;
};
constexpr std::array kJointTypes = {
    JointType{"revolute", "[angle]", 1, true, false, false},
    JointType{"prismatic", "[shift]", 1, true, false, false},
    JointType{"helical", "[angle]", 1, true, false, true},
    JointType{"cylindrical", "[angle, shift]", 2, true, false, false},
    JointType{"universal", "[first angle, second angle]", 2, false, true, false},
    JointType{"planar", "[x, y, angle]", 3, false, false, false},
    JointType{"spherical", "[quaternion]", 1, false, false, false},
    JointType{"free", "[x, y, z, quaternion]", 4, false, false, false},
};

const JointType& read_joint_type(const Document& document, const YamlNode& node) {
  const std::string& text = expect_text(document, node, "the type of a joint");
  for (const JointType& type : kJointTypes)
    if (type.name == text) return type;
  std::vector<std::string> known;
  for (const JointType& type : kJointTypes) known.emplace_back(type.name);
  throw InputError(document.where(node),
                   fmt::format("unknown joint type '{}'{}", printable(text), did_you_mean(text, known)),
                   fmt::format("joints are {}", fmt::join(known, ", ")));
}

/// One joint while its factors are being made.
struct JointReader {
  Loading& loading;
  const Section& section;
  const JointType& type;
  std::string what;
  const std::vector<const YamlNode*>& names;
  SourceLocation where;
  Transform& transform;

  Expr real(std::size_t i) const {
    const int index =
        expect_coordinate(loading, *names[i], CoordinateType::real, fmt::format("a coordinate of {}", what));
    return loading.mechanism.coordinates[static_cast<std::size_t>(index)].symbols[0];
  }
  Axis axis() const {
    const YamlNode* node = section.find("axis");
    return node != nullptr ? read_axis(loading, *node, fmt::format("the axis of {}", what))
                           : coordinate_axis(loading.graph, 2);
  }
  void append(Factor factor) const { transform.factors.push_back(std::move(factor)); }

  void universal() const {
    Axis first = coordinate_axis(loading.graph, 0), second = coordinate_axis(loading.graph, 1);
    if (const YamlNode* node = section.find("axes")) {
      const std::string what_axes = fmt::format("the axes of {}", what);
      const auto& items = expect_list(loading.document, *node, what_axes, 2);
      first = read_axis(loading, *items[0], what_axes);
      second = read_axis(loading, *items[1], what_axes);
      const Vec3 normal = cross(first.direction, second.direction);
      if (normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero())
        throw InputError(loading.document.where(*node), fmt::format("{} are parallel", what_axes));
    }
    append(rotation_about(first, real(0), where));
    append(rotation_about(second, real(1), where));
  }
  Factor shift(std::size_t count) const {
    Vec3 offset = zeros<3, 1>(loading.graph);
    for (std::size_t i = 0; i < count; ++i) offset[i] = real(i);
    return {Translation{offset}, where};
  }
};

}  // namespace

void append_joint(Loading& loading, const YamlNode& node, const std::string& what, Transform& transform) {
  const Document& document = loading.document;
  const Section section(document, node, fmt::format("a joint of {}", what),
                        {"type", "coordinates", "axis", "axes", "pitch"});
  const JointType& type = read_joint_type(document, section.require("type"));
  const std::string what_joint = fmt::format("a {} joint of {}", type.name, what);
  for (const auto& [key, taken] :
       {std::pair{"axis", type.axis}, std::pair{"axes", type.axes}, std::pair{"pitch", type.pitch}})
    if (!taken && section.find(key) != nullptr)
      throw InputError(section.where_key(key), fmt::format("a {} joint takes no '{}'", type.name, key));
  const YamlNode& list = section.require("coordinates");
  const auto& names = expect_list(
      document, list, fmt::format("coordinates {} of {}", type.coordinates, what_joint), type.count);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (names[i]->kind == YamlNode::Kind::scalar && names[i]->text == names[k]->text)
        throw InputError(document.where(*names[i]),
                         fmt::format("coordinate '{}' twice in {}", printable(names[i]->text), what_joint));

  const JointReader joint{loading, section, type, what_joint, names, document.where(node), transform};
  if (type.name == "revolute") {
    const Axis axis = joint.axis();
    joint.append(rotation_about(axis, joint.real(0), joint.where));
  } else if (type.name == "prismatic") {
    const Axis axis = joint.axis();
    joint.append(shift_along(axis, joint.real(0), joint.where));
  } else if (type.name == "helical") {
    const Axis axis = joint.axis();
    const Expr angle = joint.real(0);
    const Expr pitch =
        loading.reader
            .read(section.require("pitch"), Allowed::parameters, fmt::format("the pitch of {}", what_joint))
            .expr;
    joint.append(rotation_about(axis, angle, joint.where));
    joint.append(shift_along(axis, pitch * angle, joint.where));
  } else if (type.name == "cylindrical") {
    const Axis axis = joint.axis();
    joint.append(rotation_about(axis, joint.real(0), joint.where));
    joint.append(shift_along(axis, joint.real(1), joint.where));
  } else if (type.name == "universal") {
    joint.universal();
  } else if (type.name == "planar") {
    joint.append(joint.shift(2));
    joint.append(rotation_about(coordinate_axis(loading.graph, 2), joint.real(2), joint.where));
  } else if (type.name == "spherical") {
    joint.append(rotation_by_quaternion(loading, *names[0], what_joint));
  } else {
    joint.append(joint.shift(3));
    joint.append(rotation_by_quaternion(loading, *names[3], what_joint));
  }
}

}  // namespace alembert
