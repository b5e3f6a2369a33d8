#include "import/mjcf/compiler_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>

namespace alembert {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr const char* kTurns[] = {"axisangle", "xyaxes", "zaxis", "euler"};

Vector3d normalised(const Vector3d& v, const MjcfElement& element, const char* name) {
  if (!(v.norm() > kNoDirection))
    throw element.error(name, fmt::format("the {} of {} has no direction", name, element.what()));
  return v.normalized();
}

Quaterniond from_axes(const MjcfElement& element, const std::vector<double>& axes) {
  const Vector3d x = normalised({axes[0], axes[1], axes[2]}, element, "xyaxes");
  Vector3d y(axes[3], axes[4], axes[5]);
  y = normalised(y - x.dot(y) * x, element, "xyaxes");
  Eigen::Matrix3d turn;
  turn << x, y, x.cross(y);
  return Quaterniond(turn);
}

Quaterniond from_z(const Vector3d& z) {
  const Vector3d about = Vector3d::UnitZ().cross(z);
  const double sine = about.norm();
  const Vector3d axis = sine < kNoDirection ? Vector3d::UnitX() : Vector3d(about / sine);
  return Quaterniond(AngleAxisd(std::atan2(sine, z.z()), axis));
}

}  // namespace

double MjcfCompiler::angle(double value) const {
  return degrees ? value * std::numbers::pi / 180 : value;
}

Quaterniond MjcfCompiler::turn(const MjcfElement& element) const {
  // An angle or axes before a quaternion, whichever class they come from; the innermost of them.
  for (const pugi::xml_node layer : element.layers()) {
    const char* name = nullptr;
    for (const char* each : kTurns) {
      if (!layer.attribute(each)) continue;
      if (name != nullptr)
        throw InputError(element.text().where(layer.attribute(each)),
                         fmt::format("{} has two orientations, '{}' and '{}'", element.what(), name, each));
      name = each;
    }
    if (name == nullptr) continue;
    const std::string_view kind = name;
    const std::size_t count = kind == "axisangle" ? 4 : kind == "xyaxes" ? 6 : 3;
    const std::vector<double> v = element.list(name, count, count);
    if (kind == "axisangle")
      return Quaterniond(AngleAxisd(angle(v[3]), normalised({v[0], v[1], v[2]}, element, name)));
    if (kind == "xyaxes") return from_axes(element, v);
    if (kind == "zaxis") return from_z(normalised({v[0], v[1], v[2]}, element, name));
    return euler_turn({v[0], v[1], v[2]});
  }
  const std::vector<double> q = element.list("quat", 4, 4);
  if (q.empty()) return Quaterniond::Identity();
  const Quaterniond out(q[0], q[1], q[2], q[3]);
  if (!(out.norm() > kNoDirection))
    throw element.error("quat", fmt::format("the quat of {} is 0", element.what()));
  return out.normalized();
}

Quaterniond MjcfCompiler::euler_turn(const Vector3d& angles) const {
  Quaterniond out = Quaterniond::Identity();
  for (int i = 0; i < 3; ++i) {
    const auto letter = static_cast<unsigned char>(euler[static_cast<std::size_t>(i)]);
    const Quaterniond each(AngleAxisd(angle(angles[i]), Vector3d::Unit(std::tolower(letter) - 'x')));
    out = std::islower(letter) != 0 ? out * each : each * out;
  }
  return out;
}

RigidPose MjcfCompiler::pose(const MjcfElement& element) const {
  return {element.vector("pos", Vector3d::Zero()), turn(element)};
}

MjcfCompiler read_compiler(const MjcfText& text) {
  MjcfCompiler out;
  for (const pugi::xml_node node : text.children(text.root(), "compiler")) {
    const MjcfElement element(text, {node}, "the compiler");
    text.of(node).check_spelling(
        node, "the compiler", {"lengthrange"},
        {"autolimits",      "boundmass",         "boundinertia",  "settotalmass", "balanceinertia",
         "strippath",       "coordinate",        "angle",         "fitaabb",      "eulerseq",
         "meshdir",         "texturedir",        "discardvisual", "usethread",    "fusestatic",
         "inertiafromgeom", "inertiagrouprange", "saveinertial",  "assetdir",     "alignfree",
         "convexhull",      "exactmeshinertia",  "conflict"});
    out.degrees = element.word("angle", {"radian", "degree"}, out.degrees ? 1 : 0) == 1;
    out.autolimits = element.flag("autolimits", out.autolimits);
    out.balance = element.flag("balanceinertia", out.balance);
    out.strip_path = element.flag("strippath", out.strip_path);
    out.exact_meshes = element.flag("exactmeshinertia", out.exact_meshes);
    out.fit_bounds = element.flag("fitaabb", out.fit_bounds);
    out.least_mass = element.number("boundmass", out.least_mass);
    out.least_inertia = element.number("boundinertia", out.least_inertia);
    out.total_mass = element.number("settotalmass", out.total_mass);
    out.resolves_conflicts = element.word("conflict", {"warning", "merge", "error"}, 0) != 0;
    using FromGeoms = MjcfCompiler::FromGeoms;
    out.inertia_from_geoms = static_cast<FromGeoms>(element.word(
        "inertiafromgeom", {"false", "true", "auto"}, static_cast<std::size_t>(out.inertia_from_geoms)));
    if (const auto groups = element.list("inertiagrouprange", 2, 2); !groups.empty())
      out.inertia_groups = {groups[0], groups[1]};
    if (element.has("assetdir")) out.mesh_folder = element.string("assetdir");
    if (element.has("meshdir")) out.mesh_folder = element.string("meshdir");
    out.global = element.word("coordinate", {"local", "global"}, out.global ? 1 : 0) == 1;
    if (element.flag("alignfree", false))
      text.warn({element.where("alignfree"),
                 "alignfree is passed over: coordinates of free bodies are those of their own frames"});
    if (!element.has("eulerseq")) continue;
    out.euler = element.string("eulerseq");
    if (out.euler.size() != 3 || out.euler.find_first_not_of("xyzXYZ") != std::string::npos)
      throw element.error("eulerseq",
                          fmt::format("expected three of x, y, z, X, Y, Z as the eulerseq, found '{}'",
                                      printable(out.euler)));
  }
  return out;
}

}  // namespace alembert
