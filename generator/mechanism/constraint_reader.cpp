// Section `constraints`: list of mappings in, constraints out: rows linear in the speeds, equations of
// coordinates and positions of frames, and the mates whose surfaces roll on each other.
#include "mechanism/constraint_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "mechanism/bodies.hpp"
#include "mechanism/coordinates.hpp"
#include "mechanism/mate.hpp"
#include "mechanism/names.hpp"
#include "mechanism/section.hpp"
#include "mechanism/symbols_below.hpp"
#include "mechanism/transform_checks.hpp"
#include "mechanism/transforms.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {
namespace {

Section constraint_section(const Document& document, const YamlNode& item) {
  return Section(document, item, "a constraint", {"name", "type", "rows", "of", "on", "equations"});
}

ConstraintType read_constraint_type(const Document& document, const YamlNode& node) {
  const std::string& type = expect_text(document, node, "the type of a constraint");
  if (type == "pfaffian") return ConstraintType::pfaffian;
  if (type == "rolling") return ConstraintType::rolling;
  if (type == "holonomic") return ConstraintType::holonomic;
  const std::vector<std::string> known = {"pfaffian", "rolling", "holonomic"};
  throw InputError(document.where(node),
                   fmt::format("unknown constraint type '{}'{}", printable(type), did_you_mean(type, known)),
                   "constraints are pfaffian, rolling, holonomic");
}

bool takes(ConstraintType type, std::string_view key) {
  switch (type) {
    case ConstraintType::pfaffian:
      return key == "rows";
    case ConstraintType::rolling:
      return key == "of" || key == "on";
    case ConstraintType::holonomic:
      return key == "equations";
  }
  return false;
}

std::string_view name_of(ConstraintType type) {
  switch (type) {
    case ConstraintType::pfaffian:
      return "pfaffian";
    case ConstraintType::rolling:
      return "rolling";
    case ConstraintType::holonomic:
      return "holonomic";
  }
  return {};
}

void read_equations(Loading& loading, const YamlNode& list, Constraint& constraint) {
  const bool speeds = constraint.type == ConstraintType::pfaffian;
  const std::string_view one = speeds ? "row" : "equation";
  const auto& items =
      expect_list(loading.document, list, fmt::format("the {}s of constraint '{}'", one, constraint.name));
  if (items.empty())
    throw InputError(loading.document.where(list),
                     fmt::format("constraint '{}' has no {}s", constraint.name, one));
  for (std::size_t i = 0; i < items.size(); ++i)
    constraint.equations.push_back(
        loading.reader
            .read(*items[i], speeds ? Allowed::pfaffian : Allowed::holonomic,
                  fmt::format("{} {} of constraint '{}'", one, i + 1, constraint.name))
            .expr);
}

/// Throws where nothing is left, after simplification, of what a row or equation is to constrain.
void check_equations(const Document& document, const YamlNode& list, const Constraint& constraint,
                     const SymbolsBelow& below) {
  const bool speeds = constraint.type == ConstraintType::pfaffian;
  for (std::size_t i = 0; i < constraint.equations.size(); ++i)
    if (!includes(below.kinds(constraint.equations[i]), speeds ? Dependence::speed : Dependence::coordinate))
      throw InputError(document.where(*list.items[i]),
                       fmt::format("{} {} of constraint '{}' depends on no {}", speeds ? "row" : "equation",
                                   i + 1, constraint.name, speeds ? "speed" : "coordinate"),
                       speeds ? "a relation of coordinates is a holonomic constraint" : "");
}

std::string along(const SurfaceFrame& surface) {
  return fmt::format("[{}, {}]", to_string(surface.u), to_string(surface.v));
}

/// Throws where the surfaces of a mate that rolls are not fixed to their bodies: a factor beside it that
/// moves, or a point that moves with more than its own coordinates.
void check_rolling(const Mechanism& mechanism, const Constraint& constraint, const SymbolsBelow& below) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(constraint.body)];
  for (std::size_t i = 0; i < body.transform.factors.size(); ++i) {
    if (i >= constraint.factor && i < constraint.factor + kMateFactors) continue;
    for (const Expr& x : expressions_of(body.transform.factors[i], mechanism))
      if (moves(below.kinds(x)))
        throw InputError(
            body.transform.factors[i].where,
            fmt::format("the transform of body '{}' moves apart from the mate of rolling constraint '{}'",
                        body.name, constraint.name),
            "its surfaces must be fixed to the two bodies; what moves besides belongs to a body between "
            "them");
  }
  const Factor& factor = body.transform.factors[constraint.factor];
  const Mate mate = *mate_at(body.transform, constraint.factor);
  for (const SurfaceFrame* surface : {&mate.first, &mate.second}) {
    std::vector<int> own = below.coordinates(surface->u);
    SymbolsBelow::merge(own, below.coordinates(surface->v));
    for (const Expr& x : surface->point.entries) {
      const std::vector<int>& used = below.coordinates(x);
      if (includes(below.kinds(x), Dependence::time) ||
          !std::includes(own.begin(), own.end(), used.begin(), used.end()))
        throw InputError(factor.where,
                         fmt::format("a surface of rolling constraint '{}' moves with more than {}; it must "
                                     "be rigid",
                                     constraint.name, along(*surface)));
    }
  }
}

/// One side of a rolling constraint: a body and the coordinates of the contact on its surface.
struct Side {
  int body;
  Expr u, v;
  const YamlNode* node;
  std::string text;  ///< `[u, v]`, for messages
};

std::string body_name(const Mechanism& mechanism, int body) {
  return body < 0 ? "world" : mechanism.bodies[static_cast<std::size_t>(body)].name;
}

Side read_side(Loading& loading, const YamlNode& node, const std::string& what) {
  const Document& document = loading.document;
  const auto& items = expect_list(document, node, what + ", a body and two coordinates", 3);
  Side side{expect_body(loading, *items[0], what), {}, {}, &node, {}};
  const auto coordinate = [&](const YamlNode& item) {
    const int index = expect_coordinate(loading, item, CoordinateType::real, what);
    return loading.mechanism.coordinates[static_cast<std::size_t>(index)].symbols[0];
  };
  side.u = coordinate(*items[1]);
  side.v = coordinate(*items[2]);
  side.text = fmt::format("[{}, {}]", items[1]->text, items[2]->text);
  return side;
}

bool lies_along(const SurfaceFrame& surface, const Side& side) {
  return surface.u == side.u && surface.v == side.v;
}
bool lies_across(const SurfaceFrame& surface, const Side& side) {
  return surface.u == side.v && surface.v == side.u;
}

/// A rolling constraint while its mate is looked for.
struct RollingReader {
  Loading& loading;
  Constraint& constraint;
  Side of, on;

  [[noreturn]] void fail(const YamlNode& node, const std::string& message,
                         const std::string& note = {}) const {
    throw InputError(loading.document.where(node), message, note);
  }
  std::string name(const Side& side) const { return body_name(loading.mechanism, side.body); }

  void resolve() const {
    const Mechanism& mechanism = loading.mechanism;
    const auto parent = [&](const Side& side) {
      return side.body < 0 ? -2 : mechanism.bodies[static_cast<std::size_t>(side.body)].parent;
    };
    if (of.body == on.body) fail(*on.node, fmt::format("body '{}' cannot roll on itself", name(of)));
    if (parent(of) == on.body)
      find_mate(of, on);
    else if (parent(on) == of.body)
      find_mate(on, of);
    else
      fail(*on.node, fmt::format("neither of '{}' and '{}' is the parent of the other", name(of), name(on)),
           "two bodies roll on each other where the transform of one is a mate with the other");
  }

  /// Looks in the transform of `child` for the mate of its surface, the second, with its parent's.
  void find_mate(const Side& child, const Side& parent) const {
    const Body& body = loading.mechanism.bodies[static_cast<std::size_t>(child.body)];
    std::optional<Mate> other;
    for (std::size_t i = 0; i < body.transform.factors.size(); ++i) {
      const std::optional<Mate> mate = mate_at(body.transform, i);
      if (!mate) continue;
      other = mate;
      if (!lies_along(mate->first, parent) || !lies_along(mate->second, child)) continue;
      constraint.body = child.body;
      constraint.factor = i;
      return;
    }
    if (!other)
      fail(*of.node, fmt::format("the transform of body '{}' has no mate that could roll", body.name),
           "a mate inside of 'inverse' is not looked for");
    const bool first_fits = lies_along(other->first, parent);
    const Side& wrong = first_fits ? child : parent;
    const SurfaceFrame& surface = first_fits ? other->second : other->first;
    const bool swapped = lies_across(surface, wrong);
    fail(*wrong.node,
         fmt::format("the mate in the transform of body '{}' has a surface of '{}' along {}, not {}",
                     body.name, name(wrong), along(surface), wrong.text),
         swapped ? "the coordinates are listed in the order of 'along'" : "");
  }
};

Constraint read_constraint(Loading& loading, const Section& section) {
  const Document& document = loading.document;
  Constraint constraint;
  const YamlNode& name = section.require("name");
  constraint.name = expect_name(document, name, "a constraint");
  constraint.where = document.where(name);
  constraint.type = read_constraint_type(document, section.require("type"));
  for (const std::string_view key : {"rows", "of", "on", "equations"})
    if (section.find(key) != nullptr && !takes(constraint.type, key))
      throw InputError(section.where_key(key),
                       fmt::format("a {} constraint takes no '{}'", name_of(constraint.type), key));
  switch (constraint.type) {
    case ConstraintType::pfaffian:
      read_equations(loading, section.require("rows"), constraint);
      break;
    case ConstraintType::holonomic:
      read_equations(loading, section.require("equations"), constraint);
      break;
    case ConstraintType::rolling: {
      const std::string what = fmt::format("of rolling constraint '{}'", constraint.name);
      const Side of = read_side(loading, section.require("of"), "'of' " + what);
      const Side on = read_side(loading, section.require("on"), "'on' " + what);
      RollingReader{loading, constraint, of, on}.resolve();
      break;
    }
  }
  return constraint;
}

}  // namespace

void read_constraints(Loading& loading, const YamlNode& list) {
  const Document& document = loading.document;
  std::map<std::string, int, std::less<>> lines;
  for (const YamlNode* item : expect_list(document, list, "the constraints")) {
    const Section section = constraint_section(document, *item);
    Constraint constraint = read_constraint(loading, section);
    const auto [earlier, inserted] = lines.emplace(constraint.name, constraint.where.line);
    if (!inserted)
      throw InputError(constraint.where, fmt::format("'{}' is already a constraint (line {})",
                                                     constraint.name, earlier->second));
    loading.mechanism.constraints.push_back(std::move(constraint));
  }
  const SymbolsBelow below(loading.graph, loading.mechanism);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const Section section = constraint_section(document, *list.items[i]);
    const Constraint& constraint = loading.mechanism.constraints[i];
    switch (constraint.type) {
      case ConstraintType::pfaffian:
        check_equations(document, section.require("rows"), constraint, below);
        break;
      case ConstraintType::holonomic:
        check_equations(document, section.require("equations"), constraint, below);
        break;
      case ConstraintType::rolling:
        check_rolling(loading.mechanism, constraint, below);
        break;
    }
  }
}

}  // namespace alembert
