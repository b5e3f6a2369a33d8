#include "import/common/solid_shape.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "import/common/mesh_names.hpp"
#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

constexpr double kPi = std::numbers::pi;

/// Inertia about the centre from integrals of x^2, y^2 and z^2.
Eigen::Matrix3d from_squares(double xx, double yy, double zz) {
  return Eigen::Vector3d(yy + zz, xx + zz, xx + yy).asDiagonal();
}

}  // namespace

BodyMass solid_of_unit_density(SolidKind kind, const std::array<double, 3>& s) {
  const double a = s[0], b = s[1], c = s[2];
  switch (kind) {
    case SolidKind::sphere: {
      const double m = 4 * kPi / 3 * a * a * a, each = m * a * a / 5;
      return {m, {0, 0, 0}, from_squares(each, each, each)};
    }
    case SolidKind::ellipsoid: {
      const double m = 4 * kPi / 3 * a * b * c / 5;
      return {5 * m, {0, 0, 0}, from_squares(m * a * a, m * b * b, m * c * c)};
    }
    case SolidKind::box: {
      const double m = 8 * a * b * c / 3;
      return {3 * m, {0, 0, 0}, from_squares(m * a * a, m * b * b, m * c * c)};
    }
    case SolidKind::cylinder: {
      const double m = 2 * kPi * a * a * b;
      return {m, {0, 0, 0}, from_squares(m * a * a / 4, m * a * a / 4, m * b * b / 3)};
    }
    case SolidKind::capsule: {
      // A cylinder, and two halves of a ball whose centres of mass lie 3/8 of the radius outside its ends.
      const double m = 2 * kPi * a * a * b, ball = 4 * kPi / 3 * a * a * a;
      const double across = m * a * a / 4 + ball * a * a / 5;
      const double along = m * b * b / 3 + ball * (a * a / 5 + b * b + 3 * a * b / 4);
      return {m + ball, {0, 0, 0}, from_squares(across, across, along)};
    }
    case SolidKind::mesh:
    case SolidKind::none:
      break;
  }
  return {};
}

BodyMass surface_of_unit_density(SolidKind kind, const std::array<double, 3>& s) {
  const double a = s[0], b = s[1], c = s[2];
  switch (kind) {
    case SolidKind::sphere: {
      const double m = 4 * kPi * a * a, each = m * a * a / 3;
      return {m, {0, 0, 0}, from_squares(each, each, each)};
    }
    case SolidKind::box: {
      const double x = 8 * b * c, y = 8 * a * c, z = 8 * a * b;  // areas of pairs of faces
      return {x + y + z,
              {0, 0, 0},
              from_squares(a * a * (x + y / 3 + z / 3), b * b * (y + x / 3 + z / 3),
                           c * c * (z + x / 3 + y / 3))};
    }
    case SolidKind::cylinder: {
      const double side = 4 * kPi * a * b, ends = 2 * kPi * a * a;
      const double across = side * a * a / 2 + ends * a * a / 4;
      return {side + ends, {0, 0, 0}, from_squares(across, across, side * b * b / 3 + ends * b * b)};
    }
    case SolidKind::capsule: {
      const double side = 4 * kPi * a * b, ball = 4 * kPi * a * a;
      const double across = side * a * a / 2 + ball * a * a / 3;
      const double along = side * b * b / 3 + ball * (a * a / 3 + b * b + a * b);
      return {side + ball, {0, 0, 0}, from_squares(across, across, along)};
    }
    case SolidKind::ellipsoid: {
      // Between this ellipsoid and one whose half axes are longer by `thick`.
      constexpr double kThomsen = 1.6075, thick = 1e-6;
      const double powers = std::pow(a * b, kThomsen) + std::pow(b * c, kThomsen) + std::pow(c * a, kThomsen);
      const double area = 4 * kPi * std::pow(powers / 3, 1 / kThomsen);
      const double layer = a * b + b * c + c * a + thick * (a + b + c) + thick * thick;
      const auto square = [&](double half) {
        return area / 5 * ((half + thick) * (half + thick) + a * b * c / layer * (2 * half + thick));
      };
      return {area, {0, 0, 0}, from_squares(square(a), square(b), square(c))};
    }
    case SolidKind::mesh:
    case SolidKind::none:
      break;
  }
  return {};
}

void add_shape(DescriptionNodes& nodes, YamlNode& shapes, const SolidShape& shape, const YamlNode& pose,
               const std::string& folder) {
  YamlNode& item = nodes.mapping(shape.where);
  const std::array<double, 3>& s = shape.sizes;
  const auto put_radius_and_length = [&](std::string key) {
    YamlNode& size = nodes.mapping(shape.where);
    nodes.put(size, "radius", nodes.text(number_text(s[0]), shape.where));
    nodes.put(size, "length", nodes.text(number_text(s[1]), shape.where));
    nodes.put(item, std::move(key), size);
  };
  switch (shape.kind) {
    case SolidKind::sphere:
      nodes.put(item, "sphere", nodes.text(number_text(s[0]), shape.where));
      break;
    case SolidKind::box:
      nodes.put(item, "box", nodes.numbers(s, shape.where));
      break;
    case SolidKind::ellipsoid:
      nodes.put(item, "ellipsoid", nodes.numbers(s, shape.where));
      break;
    case SolidKind::cylinder:
      put_radius_and_length("cylinder");
      break;
    case SolidKind::capsule:
      put_radius_and_length("capsule");
      break;
    case SolidKind::mesh: {
      YamlNode& mesh = nodes.mapping(shape.where);
      nodes.put(mesh, "file", nodes.text(described_mesh_name(shape.file, folder), shape.where));
      if (s != std::array<double, 3>{1, 1, 1}) nodes.put(mesh, "scale", nodes.numbers(s, shape.where));
      nodes.put(item, "mesh", mesh);
      break;
    }
    case SolidKind::none:
      return;
  }
  if (!pose.items.empty()) nodes.put(item, "transform", pose);
  if (shape.colour) nodes.put(item, "color", nodes.numbers(*shape.colour, shape.where));
  shapes.items.push_back(&item);
}

void add_shape(DescriptionNodes& nodes, const TransformFactors& factors, YamlNode& shapes,
               const PlacedShape& shape, const std::string& folder) {
  YamlNode& pose = nodes.sequence(shape.where);
  factors.add_pose(pose, shape.pose, shape.where);
  add_shape(nodes, shapes, shape, pose, folder);
}

}  // namespace alembert
