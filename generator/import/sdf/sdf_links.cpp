#include "import/sdf/sdf_links.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "import/common/triangle_mesh.hpp"
#include "import/sdf/sdf_spelling.hpp"

namespace alembert {
namespace {

class SdfLinkReader {
 public:
  SdfLinkReader(const SdfFiles& files, SdfScopes& scopes, std::size_t scope, std::size_t named,
                Counts& left_out)
      : files_(files),
        scopes_(scopes),
        scope_(scope),
        named_(named),
        of_(scopes.all[scope].named[named]),
        left_out_(left_out) {}

  SdfLink read() {
    const pugi::xml_node node = of_.node;
    check_sdf_spelling(files_, node);
    link_.name = scopes_.all[scope_].prefix + of_.name;
    link_.where = of_.where;
    link_.pose = scopes_.in_world(scope_) * scopes_.pose(scope_, named_);
    link_.fixed = is_static();
    link_.weightless = !files_.flag(node, "gravity", true);
    warn_of_others(node);
    read_mass(node);
    for (const pugi::xml_node visual : node.children("visual")) read_visual(visual);
    for (const char* kind :
         {"sensor", "light", "plugin", "projector", "battery", "particle_emitter", "audio_source"})
      for ([[maybe_unused]] const pugi::xml_node each : node.children(kind)) ++left_out_[kind];
    return std::move(link_);
  }

 private:
  bool is_static() const {
    for (std::size_t at = scope_; at != 0; at = scopes_.all[at].parent)
      if (scopes_.all[at].fixed) return true;
    return false;
  }

  void warn_of_others(pugi::xml_node node) const {
    if (const pugi::xml_node decay = node.child("velocity_decay");
        files_.number(decay, "linear", 0) != 0 || files_.number(decay, "angular", 0) != 0)
      files_.warn({files_.where(decay),
                   "the velocity_decay of links is a simulator's numerical damping; it is left out",
                   "write a damping of the joints", "velocity_decay"});
    if (files_.flag(node, "kinematic", false))
      throw InputError(files_.where(node.child("kinematic")),
                       fmt::format("link '{}' is kinematic: forces do not move it, which cannot be expressed",
                                   printable(of_.name)));
  }

  /// In the link.
  RigidPose pose_of(pugi::xml_node element) const {
    const pugi::xml_node pose = element.child("pose");
    if (!pose) return {};
    check_sdf_spelling(files_, pose);
    const RigidPose own = files_.pose(pose);
    const char* attribute = pose.attribute("relative_to") ? "relative_to" : "frame";
    const std::string relative = pose.attribute(attribute).value();
    if (relative.empty() || relative == of_.name) return own;
    return inverse(scopes_.pose(scope_, named_)) *
           scopes_.pose(scope_, of_.base, relative, files_.where(pose, attribute)) * own;
  }

  void read_mass(pugi::xml_node node) {
    const pugi::xml_node inertial = files_.of(node).find(node, "inertial", sdf_title(node));
    if (!inertial) {
      link_.mass = {1, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
      if (!link_.fixed)
        files_.warn(
            {of_.where,
             fmt::format(
                 "link '{}' has no <inertial>: 1 kg and a moment of inertia of 1 kg m^2 about each axis, "
                 "as SDF has it",
                 printable(of_.name)),
             {},
             "no inertial"});
      return;
    }
    check_sdf_spelling(files_, inertial);
    if (const pugi::xml_node fluid = inertial.child("fluid_added_mass"))
      throw InputError(files_.where(fluid), "the added mass of a fluid cannot be expressed");
    const double mass = files_.number(inertial, "mass", 1);
    if (mass < 0)
      throw InputError(files_.where_text(inertial.child("mass")),
                       fmt::format("the mass of {} is negative", sdf_title(node)));
    if (files_.flag(inertial.attribute("auto"), inertial, false)) return read_collisions(node, inertial);
    const pugi::xml_node inertia = files_.of(node).find(inertial, "inertia", sdf_title(node));
    check_sdf_spelling(files_, inertia);
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        const std::string name = fmt::format("i{}{}", "xyz"[row], "xyz"[column]);
        matrix(row, column) = matrix(column, row) =
            files_.number(inertia, name.c_str(), row == column ? 1 : 0);
      }
    }
    if (mass == 0 && !inertia) matrix.setZero();
    const pugi::xml_node own = inertial.child("pose");
    if (own.attribute("relative_to").value()[0] != '\0')
      files_.warn({files_.where(own, "relative_to"),
                   fmt::format("the inertial of {} lies in the link's own frame; relative_to is passed over",
                               sdf_title(node)),
                   {},
                   "relative inertial"});
    const RigidPose pose = files_.pose(own);
    link_.mass = BodyMass{mass, Eigen::Vector3d::Zero(), matrix}.moved(pose);
  }

  /// Inertia that follows from the shapes of contacts.
  void read_collisions(pugi::xml_node node, pugi::xml_node inertial) {
    const double density = files_.number(inertial, "density", 1000);
    for (const pugi::xml_node collision : node.children("collision")) {
      const PlacedShape shape = read_shape(collision);
      BodyMass unit;
      if (const pugi::xml_node mesh = collision.child("geometry").child("mesh")) {
        unit = mesh_mass(mesh);
      } else if (shape.kind == SolidKind::none) {
        throw InputError(files_.where(collision),
                         fmt::format("the inertia of {} does not follow from this shape", sdf_title(node)),
                         "write its <mass> and <inertia> instead of auto");
      } else {
        std::array<double, 3> half = shape.sizes;
        if (shape.kind == SolidKind::box)
          for (double& size : half) size /= 2;
        if (shape.kind == SolidKind::cylinder || shape.kind == SolidKind::capsule) half[1] /= 2;
        unit = solid_of_unit_density(shape.kind, half);
      }
      link_.mass += unit.times(files_.number(collision, "density", density)).moved(shape.pose);
    }
    if (!(link_.mass.mass > 0))
      throw InputError(
          files_.where(inertial),
          fmt::format("the inertia of {} follows from its collisions, and it has none", sdf_title(node)));
    // A mass that is given scales what follows.
    if (inertial.child("mass"))
      link_.mass = link_.mass.times(files_.number(inertial, "mass", 1) / link_.mass.mass);
  }

  BodyMass mesh_mass(pugi::xml_node mesh) const {
    const pugi::xml_node uri = files_.of(mesh).require(mesh, "uri", "a mesh");
    TriangleMesh triangles;
    try {
      triangles = read_triangle_mesh(files_.file_of(uri));
    } catch (const InputError&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw InputError(files_.where_text(uri),
                       fmt::format("'{}' {}", printable(SdfFiles::text(uri)), error.what()),
                       "inertias follow from it");
    }
    stretch(triangles, files_.vector(mesh, "scale", Eigen::Vector3d::Ones()));
    const BodyMass out = mass_properties(triangles, MeshVolume::exact);
    if (!(out.mass > 0))
      throw InputError(files_.where_text(uri), fmt::format("'{}' encloses no volume, or is turned inside out",
                                                           printable(SdfFiles::text(uri))));
    return out;
  }

  /// Of a <visual> or <collision>.
  PlacedShape read_shape(pugi::xml_node owner) const {
    PlacedShape out;
    out.where = files_.where(owner);
    out.pose = pose_of(owner);
    const pugi::xml_node geometry = owner.child("geometry");
    check_sdf_spelling(files_, geometry);
    const auto positive = [&](pugi::xml_node shape, const char* name) {
      const double value = files_.number(shape, name, 1);
      if (!(value > 0))
        throw InputError(
            files_.where_text(shape.child(name)),
            fmt::format("expected a positive {} of the {}, found {}", name, shape.name(), value));
      return value;
    };
    const auto lengths = [&](pugi::xml_node shape, const char* name) {
      const Eigen::Vector3d size = files_.vector(shape, name, Eigen::Vector3d::Ones());
      if (!(size.minCoeff() > 0))
        throw InputError(files_.where_text(shape.child(name)),
                         fmt::format("expected positive sizes of the {}", shape.name()));
      return std::array<double, 3>{size.x(), size.y(), size.z()};
    };
    if (const pugi::xml_node box = geometry.child("box")) {
      out.kind = SolidKind::box;
      out.sizes = lengths(box, "size");
    } else if (const pugi::xml_node sphere = geometry.child("sphere")) {
      out.kind = SolidKind::sphere;
      out.sizes[0] = positive(sphere, "radius");
    } else if (const pugi::xml_node ellipsoid = geometry.child("ellipsoid")) {
      out.kind = SolidKind::ellipsoid;
      out.sizes = lengths(ellipsoid, "radii");
    } else {
      for (const auto& [name, kind] :
           {std::pair("cylinder", SolidKind::cylinder), {"capsule", SolidKind::capsule}}) {
        const pugi::xml_node shape = geometry.child(name);
        if (!shape) continue;
        out.kind = kind;
        out.sizes = {positive(shape, "radius"), positive(shape, "length"), 0};
      }
    }
    return out;
  }

  void read_visual(pugi::xml_node visual) {
    const XmlText& text = files_.of(visual);
    text.tolerate("it is not drawn", [&] {
      PlacedShape shape = read_shape(visual);
      const pugi::xml_node mesh = visual.child("geometry").child("mesh");
      if (mesh && !mesh.child("submesh")) {
        const auto file = files_.drawn_file(mesh.child("uri"));
        const Eigen::Vector3d scale = files_.vector(mesh, "scale", Eigen::Vector3d::Ones());
        if (file && scale.prod() != 0) {
          shape.kind = SolidKind::mesh;
          shape.file = file->string();
          shape.sizes = {scale.x(), scale.y(), scale.z()};
        }
      }
      if (shape.kind == SolidKind::none) {
        if (!visual.child("geometry").child("empty")) ++left_out_[mesh ? "mesh" : "shape"];
        return;
      }
      for (const char* kind : {"diffuse", "ambient"}) {
        const pugi::xml_node colour = visual.child("material").child(kind);
        if (!colour || shape.colour) continue;
        const std::vector<double> rgba = text.number_list(colour, "a colour", 3, 4);
        shape.colour = {std::clamp(rgba[0], 0.0, 1.0), std::clamp(rgba[1], 0.0, 1.0),
                        std::clamp(rgba[2], 0.0, 1.0)};
      }
      link_.shapes.push_back(shape);
    });
  }

  const SdfFiles& files_;
  SdfScopes& scopes_;
  std::size_t scope_, named_;
  SdfNamed of_;
  Counts& left_out_;
  SdfLink link_;
};

}  // namespace

SdfLink read_sdf_link(const SdfFiles& files, SdfScopes& scopes, std::size_t scope, std::size_t named,
                      Counts& left_out) {
  return SdfLinkReader(files, scopes, scope, named, left_out).read();
}

}  // namespace alembert
