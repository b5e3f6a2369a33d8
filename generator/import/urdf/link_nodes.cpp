// Inertia and shapes of a link as the values of a body's keys.
#include "import/urdf/link_nodes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <string>

#include "import/common/snapped_angle.hpp"
#include "import/urdf/mesh_files.hpp"

namespace alembert {

void LinkNodes::add_inertial(YamlNode& node, const UrdfInertial& inertial) const {
  nodes_.put(node, "mass", nodes_.text(number_text(inertial.mass), inertial.mass_where));
  if (inertial.origin.xyz != std::array<double, 3>{})
    nodes_.put(node, "com", nodes_.numbers(inertial.origin.xyz, inertial.origin.where));
  const auto& i = inertial.inertia;
  if (std::ranges::all_of(i, [](double x) { return x == 0; })) return;
  Eigen::Matrix3d inertia;
  inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  for (const int about : {0, 1, 2}) {
    const SnappedAngle angle(inertial.origin.rpy[static_cast<std::size_t>(about)], options_.snap_angles);
    if (angle.is_zero()) continue;
    const auto [c, s] = angle.cosine_and_sine();
    const int u = (about + 1) % 3, v = (about + 2) % 3;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn(u, u) = turn(v, v) = c;
    turn(v, u) = s;
    turn(u, v) = -s;
    inertia = (turn * inertia * turn.transpose()).eval();
  }
  YamlNode& entries = nodes_.mapping(inertial.inertia_where);
  constexpr std::string_view kKeys[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  for (const std::string_view key : kKeys) {
    const double value = inertia(key[0] - 'x', key[1] - 'x');
    if (key[0] == key[1] || value != 0)
      nodes_.put(entries, std::string(key), nodes_.text(number_text(value), inertial.inertia_where));
  }
  nodes_.put(node, "inertia", entries);
}

void LinkNodes::add_shapes(YamlNode& shapes, const UrdfLink& link, const UrdfPose& place) const {
  for (UrdfShape shape : link.shapes) {
    if (shape.kind == SolidKind::mesh) {
      const auto file = find_urdf_mesh(shape.file, link.where.source->name, options_.include_folders);
      if (!file) continue;
      shape.file = file->string();
    }
    YamlNode& pose = nodes_.sequence(shape.where);
    factors_.add_origin(pose, place);
    factors_.add_origin(pose, shape.origin);
    add_shape(nodes_, shapes, shape, pose, options_.folder);
  }
}

}  // namespace alembert
