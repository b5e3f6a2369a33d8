// Section `geometry` of a body: list of shapes in, shapes with checked sizes out.
#include "mechanism/geometry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mechanism/names.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transform_checks.hpp"
#include "mechanism/transforms.hpp"

namespace alembert {
namespace {

/// Shapes by the key that makes them.
struct KindOfShape {
  std::string_view key;
  ShapeKind kind;
};
constexpr KindOfShape kKinds[] = {
    {"box", ShapeKind::box},           {"sphere", ShapeKind::sphere},   {"ellipsoid", ShapeKind::ellipsoid},
    {"cylinder", ShapeKind::cylinder}, {"capsule", ShapeKind::capsule}, {"torus", ShapeKind::torus},
    {"tube", ShapeKind::tube},         {"surface", ShapeKind::surface}, {"mesh", ShapeKind::mesh},
};

/// One shape while it is being read.
struct ShapeReader {
  Loading& loading;
  Shape& shape;
  std::string what;  ///< `the sphere of body 'ball'`

  void add_size(const YamlNode& node, std::string_view name) const {
    const std::string of = fmt::format("{} of {}", name, what);
    const double size = loading.reader.read(node, Allowed::parameters, of).initial;
    if (!(size > 0))
      throw InputError(loading.document.where(node),
                       fmt::format("expected a positive number as {}, found {:.6g}", of, size));
    shape.sizes.push_back(size);
  }
  void add_three(const YamlNode& node, std::string_view names, std::string_view name) const {
    for (const YamlNode* item : expect_list(loading.document, node, fmt::format("{} of {}", names, what), 3))
      add_size(*item, name);
  }
  void add_two(const YamlNode& node, std::string_view first, std::string_view second) const {
    const Section section(loading.document, node, what, {first, second});
    add_size(section.require(first), fmt::format("the {}", first));
    add_size(section.require(second), fmt::format("the {}", second));
  }

  /// A name that stands for a coordinate of the curve or surface, in this shape only.
  ExpressionReader::LocalName local_name(const YamlNode& node) const {
    const std::string& name = expect_name(loading.document, node, fmt::format("'along' of {}", what));
    const std::vector<std::string>& reserved = reserved_names();
    const NameEntry* declared = loading.scope.find(name);
    if (declared != nullptr || std::find(reserved.begin(), reserved.end(), name) != reserved.end())
      throw InputError(loading.document.where(node),
                       declared != nullptr ? fmt::format("'{}' is already a {} (line {})", name,
                                                         noun(declared->kind), declared->where.line)
                                           : fmt::format("'{}' is reserved", name),
                       "'along' of a shape takes new names, known to this shape only");
    return {name, loading.graph.symbol(name)};
  }
  void expect_along(const YamlNode& point, const ExpressionReader::LocalName& name) const {
    if (!depends_on(shape.point.entries, name.value))
      throw InputError(
          loading.document.where(point),
          fmt::format("the point does not move with '{}', along which {} lies", name.name, what));
  }
  std::array<double, 2> range(const YamlNode& node) const {
    const std::string of = fmt::format("a range of {}", what);
    const auto& items = expect_list(loading.document, node, of, 2);
    const double lower = loading.reader.read(*items[0], Allowed::parameters, of).initial;
    const double upper = loading.reader.read(*items[1], Allowed::parameters, of).initial;
    if (!(lower < upper))
      throw InputError(loading.document.where(node),
                       fmt::format("expected a lower and a larger upper end as {}, found {:.6g} and {:.6g}",
                                   of, lower, upper));
    return {lower, upper};
  }

  void read_tube(const YamlNode& node) const {
    const Section section(loading.document, node, what, {"curve", "along", "range", "radius"});
    const ExpressionReader::LocalName along = local_name(section.require("along"));
    const YamlNode& curve = section.require("curve");
    shape.u = along.value;
    shape.point = loading.reader.read_point(curve, {along}, fmt::format("the curve of {}", what));
    expect_along(curve, along);
    shape.u_range = range(section.require("range"));
    add_size(section.require("radius"), "the radius");
  }
  void read_surface(const YamlNode& node) const {
    const Document& document = loading.document;
    const Section section(document, node, what, {"point", "along", "range"});
    const auto& names =
        expect_list(document, section.require("along"), fmt::format("'along' of {}", what), 2);
    const ExpressionReader::LocalName u = local_name(*names[0]), v = local_name(*names[1]);
    if (u.name == v.name)
      throw InputError(document.where(*names[1]),
                       fmt::format("'{}' twice; a surface lies along two different names", u.name));
    const YamlNode& point = section.require("point");
    shape.u = u.value;
    shape.v = v.value;
    shape.point = loading.reader.read_point(point, {u, v}, fmt::format("the point of {}", what));
    expect_along(point, u);
    expect_along(point, v);
    const auto& ranges =
        expect_list(document, section.require("range"), fmt::format("the ranges of {}", what), 2);
    shape.u_range = range(*ranges[0]);
    shape.v_range = range(*ranges[1]);
  }

  void read_mesh(const YamlNode& node) const {
    const Section section(loading.document, node, what, {"file", "scale"});
    const YamlNode& file = section.require("file");
    shape.file = expect_text(loading.document, file, fmt::format("the file of {}", what));
    if (shape.file.empty())
      throw InputError(loading.document.where(file), fmt::format("the file of {} has no name", what));
    shape.sizes.assign(3, 1.0);
    const YamlNode* scale = section.find("scale");
    if (scale == nullptr) return;
    const std::string of = fmt::format("the scale of {}", what);
    const auto& items = expect_list(loading.document, *scale, of, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      shape.sizes[i] = loading.reader.read(*items[i], Allowed::parameters, of).initial;
      if (shape.sizes[i] == 0)
        throw InputError(loading.document.where(*items[i]),
                         fmt::format("{} is 0: nothing is left of it", of));
    }
  }

  void read(const YamlNode& node) const {
    switch (shape.kind) {
      case ShapeKind::box:
        add_three(node, "the edges", "an edge");
        break;
      case ShapeKind::sphere:
        add_size(node, "the radius");
        break;
      case ShapeKind::ellipsoid:
        add_three(node, "the semi-axes", "a semi-axis");
        break;
      case ShapeKind::cylinder:
      case ShapeKind::capsule:
        add_two(node, "radius", "length");
        break;
      case ShapeKind::torus:
        add_two(node, "radius", "tube");
        break;
      case ShapeKind::tube:
        read_tube(node);
        break;
      case ShapeKind::surface:
        read_surface(node);
        break;
      case ShapeKind::mesh:
        read_mesh(node);
        break;
    }
  }
};

std::array<double, 3> read_color(Loading& loading, const YamlNode& node, const std::string& what) {
  std::array<double, 3> color{};
  const auto& items = expect_list(loading.document, node, what, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = loading.reader.read(*items[i], Allowed::parameters, what).initial;
    if (!(color[i] >= 0 && color[i] <= 1))
      throw InputError(
          loading.document.where(*items[i]),
          fmt::format("expected red, green and blue from 0 to 1 as {}, found {:.6g}", what, color[i]));
  }
  return color;
}

Shape read_shape(Loading& loading, const YamlNode& item, const std::string& body) {
  const Document& document = loading.document;
  const Section section(document, item, fmt::format("a shape of body '{}'", body),
                        {"box", "sphere", "ellipsoid", "cylinder", "capsule", "torus", "tube", "surface",
                         "mesh", "transform", "color"});
  const KindOfShape* found = nullptr;
  for (const KindOfShape& kind : kKinds) {
    if (section.find(kind.key) == nullptr) continue;
    if (found != nullptr)
      throw InputError(section.where_key(kind.key),
                       fmt::format("'{}' and '{}' in one shape of body '{}'; each is an item of the list",
                                   found->key, kind.key, body));
    found = &kind;
  }
  if (found == nullptr) {
    std::vector<std::string_view> keys;
    for (const KindOfShape& kind : kKinds) keys.push_back(kind.key);
    throw InputError(document.where(item), fmt::format("expected a shape of body '{}', found none", body),
                     fmt::format("its key is one of {}", fmt::join(keys, ", ")));
  }
  Shape shape;
  shape.kind = found->kind;
  shape.where = document.where(item);
  const std::string what = fmt::format("the {} of body '{}'", found->key, body);
  ShapeReader{loading, shape, what}.read(section.require(found->key));
  if (const YamlNode* transform = section.find("transform"))
    shape.transform = read_transform(loading, *transform, fmt::format("the transform of {}", what));
  if (const YamlNode* color = section.find("color"))
    shape.color = read_color(loading, *color, fmt::format("the color of {}", what));
  return shape;
}

}  // namespace

std::vector<Shape> read_geometry(Loading& loading, const YamlNode& list, const std::string& body) {
  std::vector<Shape> shapes;
  for (const YamlNode* item :
       expect_list(loading.document, list, fmt::format("the geometry of body '{}'", body)))
    shapes.push_back(read_shape(loading, *item, body));
  return shapes;
}

}  // namespace alembert
