// Lists of factors in, transforms out.
#include "mechanism/transforms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "mechanism/coordinates.hpp"
#include "mechanism/joints.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transform_checks.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

Expr named_coordinate(Loading& loading, const YamlNode& node, const std::string& what) {
  const int index = expect_coordinate(loading, node, CoordinateType::real, what);
  return loading.mechanism.coordinates[static_cast<std::size_t>(index)].symbols[0];
}

Factor read_rotation(Loading& loading, const YamlNode& node, const std::string& what) {
  const Section section(loading.document, node, fmt::format("a rotation in {}", what),
                        {"axis", "angle", "quaternion"});
  if (const YamlNode* quaternion = section.find("quaternion")) {
    for (const char* key : {"axis", "angle"})
      if (section.find(key) != nullptr)
        throw InputError(section.where_key(key),
                         fmt::format("'{}' beside 'quaternion'; expected one or the other", key));
    return rotation_by_quaternion(loading, *quaternion, what);
  }
  const Axis axis =
      read_axis(loading, section.require("axis"), fmt::format("the axis of a rotation in {}", what));
  const Quantity angle =
      loading.reader.read(section.require("angle"), Allowed::transform, fmt::format("an angle in {}", what));
  return rotation_about(axis, angle.expr, loading.document.where(node));
}

Factor read_matrix(Loading& loading, const YamlNode& node, const std::string& what) {
  const std::string what_matrix = fmt::format("a matrix in {}", what);
  const auto& rows = expect_list(loading.document, node, fmt::format("the rows of {}", what_matrix), 3);
  RigidMatrix matrix;
  for (std::size_t r = 0; r < 3; ++r) {
    const auto& row = expect_list(loading.document, *rows[r],
                                  fmt::format("a row (rotation, then translation) of {}", what_matrix), 4);
    for (std::size_t c = 0; c < 4; ++c) {
      const Expr entry = loading.reader.read(*row[c], Allowed::transform, what_matrix).expr;
      if (c < 3)
        matrix.rotation(r, c) = entry;
      else
        matrix.translation[r] = entry;
    }
  }
  loading.matrices.push_back({matrix.rotation, loading.document.where(node)});
  return {matrix, loading.document.where(node)};
}

void expect_dependence(const Loading& loading, const Vec3& point, const Expr& along, const YamlNode& node,
                       const YamlNode& name) {
  if (!depends_on(point.entries, along))
    throw InputError(
        loading.document.where(node),
        fmt::format("the point does not move with '{}', along which its frame is taken", name.text));
}

Factor read_curve(Loading& loading, const YamlNode& node, const std::string& what) {
  const Document& document = loading.document;
  const Section section(document, node, fmt::format("a curve in {}", what), {"point", "along", "frame"});
  CurveFrame curve;
  const YamlNode& point = section.require("point");
  curve.point =
      loading.reader.read_vector(point, Allowed::transform, fmt::format("the point of a curve in {}", what));
  const YamlNode& along = section.require("along");
  curve.along = named_coordinate(loading, along, fmt::format("'along' of a curve in {}", what));
  expect_dependence(loading, curve.point, curve.along, point, along);
  const YamlNode* frame = section.find("frame");
  if (frame != nullptr && frame->kind == YamlNode::Kind::scalar) {
    if (frame->text != "frenet")
      throw InputError(
          document.where(*frame),
          fmt::format("unknown frame '{}'{}; expected 'frenet' or a mapping with 'reference'",
                      printable(frame->text), did_you_mean(frame->text, std::vector<std::string>{"frenet"})));
  } else if (frame != nullptr) {
    const Section reference(document, *frame, "a curve's frame", {"reference"});
    const YamlNode& vector = reference.require("reference");
    curve.reference =
        loading.reader.read_vector(vector, Allowed::parameters, "the reference direction of a curve");
    if ((*curve.reference)[0].is_zero() && (*curve.reference)[1].is_zero() && (*curve.reference)[2].is_zero())
      throw InputError(document.where(vector), "the reference direction of a curve is zero");
  }
  return {curve, document.where(node)};
}

SurfaceFrame read_surface(Loading& loading, const YamlNode& node, const std::string& what) {
  const Document& document = loading.document;
  const Section section(document, node, fmt::format("a surface in {}", what), {"point", "along", "flip"});
  SurfaceFrame surface;
  const YamlNode& point = section.require("point");
  surface.point = loading.reader.read_vector(point, Allowed::transform,
                                             fmt::format("the point of a surface in {}", what));
  const std::string what_along = fmt::format("'along' of a surface in {}", what);
  const auto& along = expect_list(document, section.require("along"), what_along, 2);
  surface.u = named_coordinate(loading, *along[0], what_along);
  surface.v = named_coordinate(loading, *along[1], what_along);
  if (surface.u == surface.v)
    throw InputError(
        document.where(*along[1]),
        fmt::format("'{}' twice; a surface is taken along two different coordinates", along[1]->text));
  expect_dependence(loading, surface.point, surface.u, point, *along[0]);
  expect_dependence(loading, surface.point, surface.v, point, *along[1]);
  if (const YamlNode* flip = section.find("flip")) surface.flip = expect_boolean(document, *flip, "'flip'");
  return surface;
}

/// S1 Rz(spin) S2^-1.
void append_mate(Loading& loading, const YamlNode& node, const YamlNode* spin, const std::string& what,
                 Transform& transform) {
  const auto& sides =
      expect_list(loading.document, node, fmt::format("the surfaces of a mate in {}", what), 2);
  const auto side = [&](std::size_t i) {
    const Section section(loading.document, *sides[i], fmt::format("a side of a mate in {}", what),
                          {"surface"});
    return read_surface(loading, section.require("surface"), what);
  };
  const SurfaceFrame first = side(0), second = side(1);
  const Expr angle =
      spin != nullptr
          ? loading.reader.read(*spin, Allowed::transform, fmt::format("the spin of a mate in {}", what)).expr
          : loading.graph.zero();
  const SourceLocation where = loading.document.where(node);
  transform.factors.push_back({first, where});
  transform.factors.push_back({AxisRotation{2, angle}, where});
  transform.factors.push_back({second, where, true});
}

void append_inverse(Transform of, Transform& transform) {
  for (auto factor = of.factors.rbegin(); factor != of.factors.rend(); ++factor) {
    factor->inverse = !factor->inverse;
    transform.factors.push_back(std::move(*factor));
  }
}

/// A factor of a description while the primitive factors that it stands for are being made.
struct FactorReader {
  Loading& loading;
  const YamlNode& value;
  const YamlNode* spin;
  const std::string& what;
  Transform& transform;

  void append(Factor factor) const { transform.factors.push_back(std::move(factor)); }
  SourceLocation where() const { return loading.document.where(value); }
};

struct FactorKind {
  std::string_view key;
  void (*append)(const FactorReader& factor);
};
constexpr FactorKind kFactorKinds[] = {
    {"translate",
     [](const FactorReader& f) {
       const std::string what = fmt::format("a translation in {}", f.what);
       f.append({Translation{f.loading.reader.read_vector(f.value, Allowed::transform, what)}, f.where()});
     }},
    {"rotate", [](const FactorReader& f) { f.append(read_rotation(f.loading, f.value, f.what)); }},
    {"matrix", [](const FactorReader& f) { f.append(read_matrix(f.loading, f.value, f.what)); }},
    {"curve", [](const FactorReader& f) { f.append(read_curve(f.loading, f.value, f.what)); }},
    {"surface",
     [](const FactorReader& f) {
       f.append({read_surface(f.loading, f.value, f.what), f.where()});
     }},
    {"mate", [](const FactorReader& f) { append_mate(f.loading, f.value, f.spin, f.what, f.transform); }},
    {"inverse",
     [](const FactorReader& f) { append_inverse(read_transform(f.loading, f.value, f.what), f.transform); }},
    {"joint", [](const FactorReader& f) { append_joint(f.loading, f.value, f.what, f.transform); }},
};

void append_factor(Loading& loading, const YamlNode& node, const std::string& what, Transform& transform) {
  const Document& document = loading.document;
  const Section section(
      document, node, fmt::format("a factor of {}", what),
      {"translate", "rotate", "matrix", "curve", "surface", "mate", "spin", "inverse", "joint"});
  const FactorKind* found = nullptr;
  std::vector<std::string_view> keys;
  for (const FactorKind& kind : kFactorKinds) {
    keys.push_back(kind.key);
    if (section.find(kind.key) == nullptr) continue;
    if (found != nullptr)
      throw InputError(section.where_key(kind.key),
                       fmt::format("'{}' and '{}' in one factor of {}; each is an item of the list",
                                   found->key, kind.key, what));
    found = &kind;
  }
  if (found == nullptr)
    throw InputError(document.where(node), fmt::format("expected a factor of {}, found none", what),
                     fmt::format("its key is one of {}", fmt::join(keys, ", ")));
  const YamlNode* spin = section.find("spin");
  if (spin != nullptr && found->key != "mate")
    throw InputError(section.where_key("spin"), "'spin' without 'mate'");
  found->append({loading, section.require(found->key), spin, what, transform});
}

}  // namespace

Transform read_transform(Loading& loading, const YamlNode& list, const std::string& what) {
  Transform transform;
  for (const YamlNode* factor : expect_list(loading.document, list, what))
    append_factor(loading, *factor, what, transform);
  return transform;
}

Axis coordinate_axis(ExprGraph& graph, int index) {
  Axis axis{index, false, zeros<3, 1>(graph)};
  axis.direction[static_cast<std::size_t>(index)] = graph.one();
  return axis;
}

Axis read_axis(Loading& loading, const YamlNode& node, const std::string& what) {
  const Document& document = loading.document;
  if (node.kind == YamlNode::Kind::scalar) {
    for (int i = 0; i < 3; ++i)
      if (node.text == std::string_view(&"xyz"[i], 1)) return coordinate_axis(loading.graph, i);
  }
  if (node.kind != YamlNode::Kind::sequence)
    fail_expected(document, node, fmt::format("x, y, z or a list of three constants as {}", what));
  const auto& items = expect_list(document, node, what, 3);
  Vec3 v;
  double values[3], largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Quantity value = loading.reader.read(*items[i], Allowed::constants, what);
    v[i] = value.expr;
    values[i] = value_of(value.expr);  // exact where decimals cancel, unlike what is computed while reading
    largest = std::max(largest, std::abs(values[i]));
  }
  if (largest == 0)
    throw InputError(document.where(node),
                     fmt::format("expected a direction as {}, found the zero vector", what));
  for (std::size_t i = 0; i < 3; ++i) {
    if (!v[(i + 1) % 3].is_zero() || !v[(i + 2) % 3].is_zero()) continue;
    Axis axis = coordinate_axis(loading.graph, static_cast<int>(i));
    axis.negative = values[i] < 0;
    if (axis.negative) axis.direction[i] = -axis.direction[i];
    return axis;
  }
  try {
    const Expr length = sqrt(dot(v, v));
    Axis axis{-1, false, {}};
    for (std::size_t i = 0; i < 3; ++i) axis.direction[i] = v[i] / length;
    return axis;
  } catch (const std::domain_error&) {
    throw InputError(document.where(node), fmt::format("the length of {} is out of range", what));
  }
}

Factor rotation_about(const Axis& axis, const Expr& angle, const SourceLocation& where) {
  if (axis.coordinate_axis >= 0)
    return {AxisRotation{axis.coordinate_axis, axis.negative ? -angle : angle}, where};
  return {VectorRotation{axis.direction, angle}, where};
}

Factor shift_along(const Axis& axis, const Expr& distance, const SourceLocation& where) {
  return {Translation{distance * axis.direction}, where};
}

Factor rotation_by_quaternion(Loading& loading, const YamlNode& name, const std::string& what) {
  const int index =
      expect_coordinate(loading, name, CoordinateType::quaternion, fmt::format("a quaternion in {}", what));
  const SourceLocation where = loading.document.where(name);
  std::optional<SourceLocation>& use = loading.quaternion_use[static_cast<std::size_t>(index)];
  if (use)
    throw InputError(
        where,
        fmt::format("quaternion '{}' is used a second time; the first is in line {}", name.text, use->line),
        "its speeds are the angular velocity of one rotation");
  use = where;
  return {QuaternionRotation{index}, where};
}

}  // namespace alembert
