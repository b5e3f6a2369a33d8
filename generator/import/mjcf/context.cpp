#include "import/mjcf/context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <set>

#include "import/mjcf/spelling.hpp"
#include "mechanism/wrapped_path.hpp"

namespace alembert {
namespace {

using Words = std::initializer_list<std::string_view>;

/// Elements times parts of the model.
constexpr std::size_t kMaximumTries = 2000000;

/// A name that the part does not have.
struct UnknownName : InputError {
  explicit UnknownName(InputError error) : InputError(std::move(error)) {}
};

MjcfTendon read_fixed(const MjcfContext& context, pugi::xml_node node) {
  MjcfTendon out;
  out.fixed = true;
  context.text().of(node).check_spelling(
      node, "a fixed tendon", {"joint", "include"},
      {"name", "class", "group", "limited", "actuatorfrclimited", "range", "actuatorfrcrange", "solreflimit",
       "solimplimit", "solreffriction", "solimpfriction", "frictionloss", "springlength", "margin",
       "stiffness", "damping", "armature", "user"});
  for (const pugi::xml_node child : context.text().children(node, "joint")) {
    const MjcfElement of(context.text(), {child}, "the joint of a tendon");
    context.text().of(child).check_spelling(child, of.what(), {}, {"joint", "coef"});
    const std::size_t joint = context.find(of, "joint", "joint", context.tree.joints);
    if (speed_count(context.model.joints[joint].type) != 1)
      throw of.error("joint", "a fixed tendon is of hinges and slides only");
    out.terms.push_back({joint, of.number("coef", 0)});
  }
  if (out.terms.empty()) throw InputError(context.text().where(node), "a fixed tendon without joints");
  return out;
}

/// Nothing where it is passed by.
std::optional<MjcfWrap> read_wrap(MjcfContext& context, const MjcfElement& of) {
  MjcfModel& model = context.model;
  const auto left_out = [&](const std::string& why) {
    context.text().warn(
        {of.where(),
         fmt::format("a tendon wraps around {}, which is left out: its path leads straight from "
                     "site to site",
                     why),
         "the equations differ where the tendon would touch the geom", "wrapping"});
    return std::nullopt;
  };
  const MjcfPlace geom = context.tree.geom_places[context.find(of, "geom", "geom", context.tree.geoms)];
  MjcfWrap wrap{0, std::nullopt};
  if (of.has("sidesite")) wrap.side = context.find(of, "sidesite", "site", context.tree.sites);
  if (!geom.round) return left_out("a geom that is no sphere or cylinder");
  if (wrap.side) {
    const MjcfPlace& side = model.sites[*wrap.side];
    if (side.body != geom.body) return left_out("a geom with a sidesite on another body");
    if ((side.pose.shift - geom.pose.shift).norm() < geom.round->radius)
      return left_out("the inside of a geom");
  }
  wrap.geom = context.place(geom, context.name(of, "geom"), of.where("geom"));
  return wrap;
}

/// Of a site or another place, in the world.
RigidPose place_at_rest(const MjcfModel& model, std::size_t place) {
  return rest_pose(model, model.sites[place].body) * model.sites[place].pose;
}

/// Of a path between two points in the world.
double wrapped_length(const MjcfModel& model, const MjcfWrap& wrap, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to) {
  const RigidPose into = inverse(place_at_rest(model, wrap.geom));
  const auto seen = [&](const Eigen::Vector3d& world) { return (into * RigidPose{world}).shift; };
  const MjcfRound& round = *model.sites[wrap.geom].round;
  return length_around(
      round.cylinder, round.radius, seen(from), seen(to),
      wrap.side ? std::optional(seen(place_at_rest(model, *wrap.side).shift)) : std::nullopt);
}

MjcfTendon read_spatial(MjcfContext& context, pugi::xml_node node) {
  MjcfTendon out;
  const MjcfText& text = context.text();
  text.of(node).check_spelling(node, "a spatial tendon", {"site", "geom", "pulley", "include"},
                               kTendonAttributes);
  out.branches.emplace_back();
  for (const pugi::xml_node child : text.children(node)) {
    const MjcfElement of(text, {child}, fmt::format("the {} of a tendon", child.name()));
    const std::string_view kind = child.name();
    text.of(child).check_spelling(child, of.what(), {}, {"site", "geom", "sidesite", "divisor"});
    if (kind == "site") {
      out.branches.back().sites.push_back(context.find(of, "site", "site", context.tree.sites));
    } else if (kind == "pulley") {
      const double divisor = of.number("divisor", 1);
      if (!(divisor > 0)) throw of.error("divisor", "the divisor of a pulley is positive");
      out.branches.push_back({{}, divisor});
    } else if (kind == "geom") {
      MjcfBranch& branch = out.branches.back();
      if (branch.sites.empty() || branch.wraps.contains(branch.sites.size() - 1))
        throw InputError(of.where(), "a tendon wraps around a geom between two sites");
      if (const std::optional<MjcfWrap> wrap = read_wrap(context, of))
        branch.wraps.emplace(branch.sites.size() - 1, *wrap);
    }
  }
  for (const MjcfBranch& branch : out.branches)
    if (!branch.sites.empty() && branch.wraps.contains(branch.sites.size() - 1))
      throw InputError(text.where(node), "a tendon wraps around a geom between two sites");
  std::erase_if(out.branches, [](const MjcfBranch& branch) { return branch.sites.empty(); });
  for (const MjcfBranch& branch : out.branches)
    if (branch.sites.size() < 2)
      throw InputError(text.where(node), "a branch of a spatial tendon has one site: a path has two or more");
  if (out.branches.empty()) throw InputError(text.where(node), "a spatial tendon without sites");
  return out;
}

double length_at_rest(const MjcfModel& model, const MjcfTendon& tendon) {
  double length = 0;
  for (const MjcfTerm& term : tendon.terms) length += term.factor * model.joints[term.joint].rest;
  for (const MjcfBranch& branch : tendon.branches) {
    for (std::size_t i = 0; i + 1 < branch.sites.size(); ++i) {
      const Eigen::Vector3d begin = place_at_rest(model, branch.sites[i]).shift,
                            end = place_at_rest(model, branch.sites[i + 1]).shift;
      const auto wrap = branch.wraps.find(i);
      length += (wrap == branch.wraps.end() ? (end - begin).norm()
                                            : wrapped_length(model, wrap->second, begin, end)) /
                branch.divisor;
    }
  }
  return length;
}

void add_ends_of_bodies(MjcfContext& context, const MjcfElement& of, MjcfEquality& equality) {
  const bool weld = equality.type == MjcfEqualityType::weld;
  MjcfModel& model = context.model;
  if (of.has("site1") || of.has("site2")) {
    const MjcfPlace& first = model.sites[context.find(of, "site1", "site", context.tree.sites)];
    const MjcfPlace& second = model.sites[context.find(of, "site2", "site", context.tree.sites)];
    equality.first = first.body;
    equality.second = second.body;
    equality.first_pose = first.pose;
    equality.second_pose = second.pose;
    return;
  }
  equality.first = context.find(of, "body1", "body", context.tree.bodies);
  equality.second = of.has("body2") ? context.find(of, "body2", "body", context.tree.bodies) : 0;
  const RigidPose between =
      inverse(reference_pose(model, equality.first)) * reference_pose(model, *equality.second);
  Eigen::Vector3d anchor = of.vector("anchor", Eigen::Vector3d::Zero());
  if (!weld && context.part.file->compiler.global)
    anchor = (inverse(reference_pose(model, equality.first)) * RigidPose{anchor}).shift;
  if (weld) {
    equality.second_pose.shift = anchor;
    equality.first_pose = between * equality.second_pose;
    if (const std::vector<double> given = of.list("relpose", 7, 7); !given.empty()) {
      const Eigen::Quaterniond turn(given[3], given[4], given[5], given[6]);
      if (turn.norm() > 0) equality.first_pose = {{given[0], given[1], given[2]}, turn.normalized()};
    }
  } else {
    equality.first_pose.shift = anchor;
    equality.second_pose = inverse(between) * equality.first_pose;
    equality.second_pose.turn.setIdentity();
  }
}

}  // namespace

void MjcfContext::read_each(const char* section, const std::function<void(pugi::xml_node)>& read_one) {
  for (const pugi::xml_node top : text().children(text().root(), section))
    for (const pugi::xml_node node : text().children(top)) {
      if (++tried > kMaximumTries)
        throw InputError(text().where(node), "too many elements for so many copies and attached models");
      if (count > kMaximumMjcfElements)
        throw InputError(text().where(node),
                         fmt::format("the model has more than {} elements", kMaximumMjcfElements));
      const std::size_t sites = model.sites.size();
      try {
        read_one(node);
        read.insert(node);
        ++count;
      } catch (const UnknownName& error) {
        model.sites.erase(model.sites.begin() + static_cast<std::ptrdiff_t>(sites), model.sites.end());
        if ((!part.attached || part.whole) && missed.insert(node).second) unknown.emplace_back(node, error);
      }
    }
}

void MjcfContext::check_unknown(const MjcfFile& own) const {
  for (const auto& [node, error] : unknown) {
    if (read.contains(node)) continue;
    const MjcfText& from = own.text;
    if (from.holds(node)) throw error;
    from.warn({error.where(),
               fmt::format("{}; what speaks of it is left out", error.message()),
               {},
               "part that is not attached"});
  }
}

std::size_t MjcfContext::find(const MjcfElement& element, const char* attribute, const char* noun,
                              const MjcfNames& names) const {
  if (!element.has(attribute))
    throw InputError(element.where(), fmt::format("no attribute '{}' of {}", attribute, element.what()));
  const auto found = names.find(name(element, attribute));
  if (found != names.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [each, index] : names)
    if (each.starts_with(part.prefix) && each.ends_with(part.suffix) &&
        each.size() > part.prefix.size() + part.suffix.size())
      known.push_back(each.substr(part.prefix.size(), each.size() - part.prefix.size() - part.suffix.size()));
  const std::string own = element.string(attribute);
  throw UnknownName(element.error(
      attribute, fmt::format("there is no {} '{}'{}", noun, printable(own), did_you_mean(own, known))));
}

std::size_t MjcfContext::place(const MjcfElement& element, const char* type, const char* name) {
  MjcfPlace place;
  switch (element.word(type, {"body", "xbody", "geom", "site", "camera"}, 1)) {
    case 0:
    case 1:
      place.body = find(element, name, "body", tree.bodies);
      // The frame of `body` is that of its inertia; its origin is the centre of mass. Axes are looked at in references.
      if (element.string(type) == "body") {
        const MjcfBody& body = model.bodies[place.body];
        place.pose = body.mass.frame(std::string_view(type) == "reftype"
                                         ? body.inertial_turn.value_or(Eigen::Quaterniond::Identity())
                                         : Eigen::Quaterniond::Identity());
      }
      break;
    case 2:
      place = tree.geom_places[find(element, name, "geom", tree.geoms)];
      break;
    case 3:
      return find(element, name, "site", tree.sites);
    default:
      place = tree.camera_places[find(element, name, "camera", tree.cameras)];
      break;
  }
  return this->place(place, this->name(element, name), element.where(name));
}

std::size_t MjcfContext::place(MjcfPlace place, const std::string& name, const SourceLocation& where) {
  const auto is_same = [&](const MjcfPlace& other) {
    return other.name == name && other.body == place.body &&
           other.round.has_value() == place.round.has_value() && other.pose.shift == place.pose.shift &&
           other.pose.turn.coeffs() == place.pose.turn.coeffs();
  };
  if (const auto found = std::ranges::find_if(model.sites, is_same);
      place.round && found != model.sites.end())
    return static_cast<std::size_t>(found - model.sites.begin());
  place.name = name;
  place.where = where;
  model.sites.push_back(std::move(place));
  return model.sites.size() - 1;
}

std::optional<std::array<double, 2>> MjcfContext::range(const MjcfElement& element, const char* attribute,
                                                        const char* limited) const {
  const std::vector<double> values = element.list(attribute, 2, 2);
  if (values.empty()) return std::nullopt;
  const bool counts =
      element.flag_or_auto(limited).value_or(part.file->compiler.autolimits && values[0] < values[1]);
  if (!counts) return std::nullopt;
  if (!(values[0] < values[1]))
    throw element.error(attribute, fmt::format("the {} of {} has no room", attribute, element.what()));
  return std::array{values[0], values[1]};
}

void read_tendons(MjcfContext& context) {
  context.read_each("tendon", [&](pugi::xml_node node) {
    const std::string_view kind = node.name();
    const MjcfElement of = context.element(node, {"tendon"});
    if (kind != "fixed" && kind != "spatial") {
      context.text().warn(
          {of.where(), fmt::format("<{}> is no tendon that is known; it is left out", printable(kind))});
      return;
    }
    MjcfTendon tendon = kind == "fixed" ? read_fixed(context, node) : read_spatial(context, node);
    tendon.name = context.name(of);
    tendon.where = of.has("name") ? of.where("name") : of.where();
    for (const auto& [name, to] : {std::pair("stiffness", &tendon.stiffness), {"damping", &tendon.damping}}) {
      const std::vector<double> values = of.overlaid(name, 3);
      for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i] != 0)
          throw of.error(name,
                         fmt::format("the {} of {} is a polynomial, which is not taken", name, of.what()));
      if (!values.empty()) *to = values[0];
    }
    tendon.friction = of.number("frictionloss", 0);
    tendon.drive = context.range(of, "actuatorfrcrange", "actuatorfrclimited");
    tendon.armature = of.number("armature", 0);
    if (tendon.armature != 0 && !tendon.fixed)
      throw of.error(
          "armature",
          fmt::format("the armature of {}, which is no fixed tendon, cannot be expressed", of.what()));
    tendon.limits = context.range(of, "range", "limited");
    const std::vector<double> rest = of.list("springlength", 1, 2);
    tendon.rest = rest.empty() ? std::array{-1.0, -1.0} : std::array{rest.front(), rest.back()};
    if (tendon.rest[0] == -1 && tendon.rest[1] == -1) tendon.rest.fill(length_at_rest(context.model, tendon));
    if (!tendon.name.empty() && !context.tendons.emplace(tendon.name, context.model.tendons.size()).second)
      throw InputError(tendon.where, fmt::format("a second tendon '{}'", printable(tendon.name)));
    context.model.tendons.push_back(std::move(tendon));
  });
}

void read_equalities(MjcfContext& context) {
  context.read_each("equality", [&](pugi::xml_node node) {
    const MjcfElement of = context.element(node, {"equality"});
    MjcfEquality equality;
    equality.name = context.name(of);
    equality.where = of.where();
    const std::string_view kind = node.name();
    if (!of.flag("active", true)) {
      context.text().warn(
          {of.where("active"), fmt::format("{} is not active; it is left out", of.what()), {}, "inactive"});
      return;
    }
    context.text().of(node).check_spelling(
        node, of.what(), {},
        {"name", "class", "active", "solref", "solimp", "body1", "body2", "site1", "site2", "anchor",
         "relpose", "torquescale", "joint1", "joint2", "tendon1", "tendon2", "polycoef"});
    const auto pair = [&](const char* first, const char* second, const char* noun, const MjcfNames& names) {
      equality.first = context.find(of, first, noun, names);
      if (of.has(second)) equality.second = context.find(of, second, noun, names);
      const std::vector<double> polynomial = of.list("polycoef", 1, 5);
      std::ranges::copy(polynomial, equality.polynomial.begin());
    };
    if (kind == "connect" || kind == "weld") {
      equality.type = kind == "weld" ? MjcfEqualityType::weld : MjcfEqualityType::connect;
      add_ends_of_bodies(context, of, equality);
      // Then the rows of the turn are zeros: points are held together, and nothing else.
      if (kind == "weld" && of.number("torquescale", 1) == 0) equality.type = MjcfEqualityType::connect;
    } else if (kind == "joint") {
      equality.type = MjcfEqualityType::joint;
      pair("joint1", "joint2", "joint", context.tree.joints);
      for (const std::size_t joint : {equality.first, equality.second.value_or(equality.first)})
        if (speed_count(context.model.joints[joint].type) != 1)
          throw InputError(of.where(), fmt::format("{} is of hinges and slides only", of.what()));
    } else if (kind == "tendon") {
      equality.type = MjcfEqualityType::tendon;
      pair("tendon1", "tendon2", "tendon", context.tendons);
    } else {
      throw InputError(of.where(), fmt::format("the equality <{}> cannot be expressed", printable(kind)));
    }
    context.model.equalities.push_back(std::move(equality));
  });
}

void read_sensors(MjcfContext& context) {
  std::set<std::string, std::less<>> left_out;
  context.read_each("sensor", [&](pugi::xml_node node) {
    const MjcfElement of(context.text(), {node}, fmt::format("the sensor {}", printable(node.name())));
    MjcfSensor sensor;
    sensor.name = context.name(of);
    sensor.kind = node.name();
    sensor.where = of.where();
    const auto is = [&](Words kinds) { return std::ranges::find(kinds, sensor.kind) != kinds.end(); };
    if (is({"framepos", "framexaxis", "frameyaxis", "framezaxis", "framelinvel", "frameangvel"})) {
      const bool axes = is({"framexaxis", "frameyaxis", "framezaxis"});
      const bool of_inertia =
          of.has("refname") && of.string("reftype") == "body" &&
          !context.model.bodies[context.find(of, "refname", "body", context.tree.bodies)].turn_is_exact;
      if (of_inertia || (axes && of.string("objtype") == "body")) {
        context.text().warn({of.where(),
                             "axes of a body's inertia are left out; xbody has its own axes",
                             {},
                             "inertial axes"});
        return;
      }
      const std::size_t places = context.model.sites.size();
      sensor.of = context.place(of, "objtype", "objname");
      if (of.has("refname")) sensor.reference = context.place(of, "reftype", "refname");
      const auto of_mesh = [&](std::size_t place) { return context.model.sites[place].of_mesh; };
      if (of_mesh(sensor.of) || (sensor.reference && of_mesh(*sensor.reference))) {
        context.text().warn({of.where(),
                             "the frame of a mesh is left out: MuJoCo moves it to the centre of mass",
                             "a site in its place is taken", "frame of a mesh"});
        context.model.sites.resize(places);
        return;
      }
      if (sensor.reference && is({"framelinvel", "frameangvel"})) {
        context.text().warn({of.where(),
                             fmt::format("{} in a moving frame is left out", sensor.kind),
                             {},
                             "relative velocity"});
        return;
      }
    } else if (is({"gyro", "velocimeter"})) {
      sensor.of = context.find(of, "site", "site", context.tree.sites);
    } else if (is({"jointpos", "jointvel"})) {
      sensor.of = context.find(of, "joint", "joint", context.tree.joints);
    } else if (is({"tendonpos", "tendonvel"})) {
      sensor.of = context.find(of, "tendon", "tendon", context.tendons);
    } else if (is({"actuatorpos", "actuatorvel"})) {
      const auto found = context.actuators.find(context.name(of, "actuator"));
      if (found == context.actuators.end()) return;  // its actuator was left out with a warning
      sensor.of = found->second;
    } else if (!is({"clock"})) {
      context.text().warn({of.where(),
                           fmt::format("sensors <{}> are left out", printable(sensor.kind)),
                           {},
                           "sensor " + sensor.kind});
      return;
    }
    context.model.sensors.push_back(std::move(sensor));
  });
}

}  // namespace alembert
