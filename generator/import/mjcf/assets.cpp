#include "import/mjcf/assets.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <filesystem>
#include <stdexcept>

#include "import/common/convex_hull.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

/// Of a mesh without triangles, or of one whose inertia is asked for as that of its hull.
TriangleMesh hull(const MjcfElement& asset, const TriangleMesh& mesh) {
  std::optional<int> vertices;
  if (const double most = asset.number("maxhullvert", -1); most != -1) {
    if (!(most >= 4 && most <= 1e6))
      throw asset.error("maxhullvert", "expected a number of vertices, 4 or more, or -1 for all");
    vertices = static_cast<int>(most);
  }
  try {
    return convex_hull(mesh, vertices);
  } catch (const std::runtime_error& error) {
    throw InputError(asset.where(), fmt::format("{} {}", asset.what(), error.what()),
                     "inertias follow from it, since a body has no <inertial>");
  }
}

}  // namespace

MjcfAssets::MjcfAssets(const MjcfText& text, const MjcfDefaults& defaults, const MjcfCompiler& compiler)
    : compiler_(compiler) {
  for (const pugi::xml_node section : text.children(text.root(), "asset")) {
    for (const pugi::xml_node node : text.children(section)) {
      const MjcfElement asset = defaults.element(node);
      const std::string_view kind = node.name();
      if (kind == "material") {
        if (const auto colour = asset.colour()) colours_[asset.string("name")] = *colour;
      } else if (kind == "mesh") {
        std::string name = node.attribute("name").value();
        if (name.empty()) name = fs::path(asset.string("file")).stem().string();
        if (!meshes_.emplace(name, asset).second)
          throw InputError(asset.where(), fmt::format("a second mesh '{}'", printable(name)));
      }
    }
  }
}

std::optional<std::array<double, 3>> MjcfAssets::colour(const std::string& material) const {
  const auto found = colours_.find(material);
  return found == colours_.end() ? std::nullopt : std::optional(found->second);
}

TriangleMesh MjcfAssets::triangles(const MjcfElement& asset) const {
  TriangleMesh out;
  if (asset.has("vertex")) {
    const std::vector<double> vertices = asset.list("vertex", 12, 3000000);
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
      out.vertices.emplace_back(vertices[i], vertices[i + 1], vertices[i + 2]);
    const std::vector<double> faces = asset.list("face", 3, 3000000);
    for (std::size_t i = 0; i + 2 < faces.size(); i += 3) {
      std::array<std::size_t, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!(faces[i + k] >= 0 && faces[i + k] < static_cast<double>(out.vertices.size())))
          throw asset.error("face", fmt::format("{} has no vertex {}", asset.what(), faces[i + k]));
        triangle[k] = static_cast<std::size_t>(faces[i + k]);
      }
      out.triangles.push_back(triangle);
    }
  } else {
    const std::string file = asset.string("file");
    if (file.empty())
      throw InputError(asset.where(), fmt::format("{} has neither a file nor vertices", asset.what()));
    const fs::path path = path_of(asset);
    try {
      out = read_triangle_mesh(path);
    } catch (const std::runtime_error& error) {
      throw InputError(asset.where("file"), fmt::format("'{}' {}", printable(file), error.what()),
                       "inertias follow from it, since a body has no <inertial>");
    }
  }
  const Eigen::Vector3d origin = asset.vector("refpos", Eigen::Vector3d::Zero());
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  if (const std::vector<double> q = asset.list("refquat", 4, 4); !q.empty())
    turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
  for (Eigen::Vector3d& v : out.vertices) v = (turn.conjugate() * (v - origin)).eval();
  stretch(out, asset.vector("scale", Eigen::Vector3d::Ones()));
  return out.triangles.empty() ? hull(asset, out) : out;
}

fs::path MjcfAssets::path_of(const MjcfElement& asset) const {
  const fs::path file = asset.string("file"), name = compiler_.strip_path ? file.filename() : file;
  return asset.text().below((fs::path(compiler_.mesh_folder) / name).string(), asset.where("file"));
}

std::optional<DrawnMesh> MjcfAssets::drawn(const std::string& mesh) const {
  const auto found = meshes_.find(mesh);
  if (found == meshes_.end()) return std::nullopt;
  const MjcfElement& asset = found->second;
  if (!asset.has("file") || asset.has("refpos") || asset.has("refquat")) return std::nullopt;
  try {
    const fs::path path = path_of(asset);
    const Eigen::Vector3d scale = asset.vector("scale", Eigen::Vector3d::Ones());
    if (!fs::is_regular_file(path) || scale.prod() == 0) return std::nullopt;
    return DrawnMesh{path, {scale.x(), scale.y(), scale.z()}};
  } catch (const InputError&) {
    return std::nullopt;  // where an inertia follows from it, it is an error there
  }
}

const MjcfElement& MjcfAssets::asset_of(const MjcfElement& geom) const {
  const std::string name = geom.string("mesh");
  const auto found = meshes_.find(name);
  if (found != meshes_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [each, asset] : meshes_) known.push_back(each);
  throw geom.error("mesh",
                   fmt::format("there is no mesh '{}'{}", printable(name), did_you_mean(name, known)));
}

BodyMass MjcfAssets::mesh(const MjcfElement& geom, bool shell) const {
  const MjcfElement& asset = asset_of(geom);
  const std::pair key(geom.string("mesh"), shell);
  if (const auto known = masses_.find(key); known != masses_.end()) return known->second;
  MeshVolume how = MeshVolume::positive;
  bool convex = false;
  switch (asset.word("inertia", {"convex", "exact", "legacy", "shell"}, compiler_.exact_meshes ? 1 : 2)) {
    case 0:
      convex = true;
      [[fallthrough]];
    case 1:
      how = MeshVolume::exact;
      break;
    case 3:
      how = MeshVolume::shell;
      break;
    default:
      break;
  }
  TriangleMesh surface = triangles(asset);
  if (convex && !shell) surface = hull(asset, surface);
  const BodyMass out = mass_properties(surface, shell ? MeshVolume::shell : how);
  if (!(out.mass > 0))
    throw InputError(asset.where(),
                     fmt::format("{} encloses no volume, or is turned inside out", asset.what()));
  masses_.emplace(key, out);
  return out;
}

MeshBox MjcfAssets::box(const MjcfElement& geom, bool bounds) const {
  const BodyMass mass = mesh(geom, false);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(mass.inertia);
  Eigen::Matrix3d axes = principal.eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(1) *= -1;
  const Eigen::Vector3d moments = principal.eigenvalues().reverse();
  MeshBox out{mass.frame(Eigen::Quaterniond(axes)), {}, {moments.x(), moments.y(), moments.z()}};
  Eigen::Vector3d half = (1.5 / mass.mass * (moments.sum() - 2 * moments.array())).max(0).sqrt();
  if (bounds) {
    Eigen::AlignedBox3d held;
    for (const Eigen::Vector3d& v : triangles(asset_of(geom)).vertices)
      held.extend((axes.transpose() * (v - mass.centre)).eval());
    half = held.sizes() / 2;
    out.pose = out.pose * RigidPose{held.center()};
  }
  out.half = {half.x(), half.y(), half.z()};
  return out;
}

}  // namespace alembert
