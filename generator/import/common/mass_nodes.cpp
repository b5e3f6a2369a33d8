#include "import/common/mass_nodes.hpp"

#include <string_view>

#include "import/common/snapped_angle.hpp"
#include "import/common/transform_factors.hpp"

namespace alembert {

void add_mass(DescriptionNodes& nodes, YamlNode& body, const BodyMass& mass, const SourceLocation& where) {
  if (mass.mass == 0 && mass.inertia.isZero(0)) return;
  nodes.put(body, "mass", nodes.text(number_text(mass.mass), where));
  const std::array<double, 3> com = shift_without_rounding(mass.frame());
  if (com != std::array<double, 3>{}) nodes.put(body, "com", nodes.numbers(com, where));
  if (mass.inertia.isZero(0)) return;
  YamlNode& entries = nodes.mapping(where);
  const double rounding = 1e-14 * mass.inertia.cwiseAbs().maxCoeff();
  for (const std::string_view key : {"xx", "yy", "zz", "xy", "xz", "yz"}) {
    const double value = mass.inertia(key[0] - 'x', key[1] - 'x');
    if (key[0] == key[1] || std::abs(value) > rounding)
      nodes.put(entries, std::string(key), nodes.text(number_text(value), where));
  }
  nodes.put(body, "inertia", entries);
}

void add_borne_weight(DescriptionNodes& nodes, YamlNode& forces, const std::string& name,
                      const std::string& frame, const Eigen::Vector3d& lift, const SourceLocation& where) {
  YamlNode& node = nodes.add_named(forces, name, where);
  nodes.put(node, "at", nodes.text(frame, where));
  nodes.put(node, "axes", nodes.text("world", where));
  nodes.put(node, "force", nodes.numbers({lift.x(), lift.y(), lift.z()}, where));
}

}  // namespace alembert
