// Surfaces by assimp, from memory, so that no file but the one that was named is opened.
#include "meshes/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace alembert {
namespace {

constexpr std::uintmax_t kMaximumFile = std::uintmax_t{256} << 20;
constexpr float kCrease = 40;  // degrees

std::string bytes_of(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) throw std::runtime_error("cannot be read: " + code.message());
  if (size > kMaximumFile) throw std::runtime_error("has more than 256 MiB");
  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw std::runtime_error("cannot be read");
  return bytes;
}

/// MuJoCo's own binary meshes as an OBJ, which assimp reads: four counts, of vertices, normals, texture coordinates and
/// triangles, then these, as 32-bit numbers, the lowest byte first.
std::string obj_of_msh(const std::string& bytes) {
  constexpr std::size_t kHeader = 16;
  const auto word = [&](std::size_t at) {
    std::uint32_t out = 0;
    for (unsigned b = 0; b < 4; ++b)
      out |= std::uint32_t{static_cast<unsigned char>(bytes[at + b])} << (8 * b);
    return out;
  };
  const auto fail = [] {
    throw std::runtime_error("is no mesh of MuJoCo's: its size is not what it counts");
  };
  if (bytes.size() < kHeader) fail();
  const std::uint64_t vertices = word(0), normals = word(4), coordinates = word(8), triangles = word(12);
  if (bytes.size() != kHeader + 12 * (vertices + normals) + 8 * coordinates + 12 * triangles) fail();
  std::string out;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::size_t at = kHeader + 12 * v;
    out += fmt::format("v {} {} {}\n", std::bit_cast<float>(word(at)), std::bit_cast<float>(word(at + 4)),
                       std::bit_cast<float>(word(at + 8)));
  }
  const std::size_t first = kHeader + 12 * (vertices + normals) + 8 * coordinates;
  for (std::size_t t = 0; t < triangles; ++t) {
    out += 'f';
    for (unsigned corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = word(first + 12 * t + 4 * corner);
      if (vertex >= vertices) throw std::runtime_error("has a triangle of vertices that it has not");
      out += fmt::format(" {}", vertex + 1);
    }
    out += '\n';
  }
  return out;
}

Eigen::Vector3d vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

Eigen::Affine3d affine(const aiMatrix4x4& m) {
  Eigen::Affine3d out;
  out.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return out;
}

/// Splits faces of four corners along the shorter diagonal, as MuJoCo does: where they are not flat, volumes depend on
/// it.
void split_quadrilaterals(aiMesh& mesh) {
  const auto is_one = [](const aiFace& face) { return face.mNumIndices == 4; };
  const std::span<aiFace> old(mesh.mFaces, mesh.mNumFaces);
  const auto count = static_cast<unsigned>(std::ranges::count_if(old, is_one));
  if (count == 0) return;
  auto* const faces = new aiFace[mesh.mNumFaces + count];
  aiFace* next = faces;
  for (const aiFace& face : old) {
    if (!is_one(face)) {
      *next++ = face;
      continue;
    }
    const unsigned* const at = face.mIndices;
    const auto diagonal = [&](unsigned i, unsigned k) {
      return (mesh.mVertices[at[k]] - mesh.mVertices[at[i]]).SquareLength();
    };
    const unsigned turn = diagonal(0, 2) < diagonal(1, 3) ? 0 : 1;
    for (const unsigned half : {1U, 2U}) {
      next->mNumIndices = 3;
      next->mIndices = new unsigned[3]{at[turn], at[half + turn], at[(half + 1 + turn) % 4]};
      ++next;
    }
  }
  delete[] mesh.mFaces;
  mesh.mFaces = faces;
  mesh.mNumFaces += count;
  mesh.mPrimitiveTypes |= aiPrimitiveType_TRIANGLE;
  // What is no polygon must not be called one.
  if (std::ranges::all_of(std::span(mesh.mFaces, mesh.mNumFaces),
                          [](const aiFace& face) { return face.mNumIndices <= 3; }))
    mesh.mPrimitiveTypes &= ~static_cast<unsigned>(aiPrimitiveType_POLYGON);
}

/// Lines are none. Points are vertices without triangles, which nobody draws.
bool is_surface(const aiMesh& mesh, MeshNormals normals) {
  return (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0 ||
         (mesh.mPrimitiveTypes == aiPrimitiveType_POINT && normals == MeshNormals::none);
}

/// None if the file has none; what assimp makes up for that has its own name.
std::optional<std::array<double, 3>> color_of(const aiScene& scene, const aiMesh& mesh) {
  if (mesh.mMaterialIndex >= scene.mNumMaterials) return std::nullopt;
  const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
      std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME)
    return std::nullopt;
  aiColor3D color;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != aiReturn_SUCCESS) return std::nullopt;
  const auto within = [](float x) {
    return std::isfinite(x) ? std::clamp(static_cast<double>(x), 0.0, 1.0) : 0.5;
  };
  return std::array{within(color.r), within(color.g), within(color.b)};
}

MeshSurface surface_of(const aiScene& scene, const aiMesh& mesh, const Eigen::Affine3d& place,
                       MeshNormals normals) {
  MeshSurface out;
  out.color = color_of(scene, mesh);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v)
    out.vertices.push_back(place * vector_of(mesh.mVertices[v]));
  if (normals == MeshNormals::smooth) {
    if (!mesh.HasNormals()) throw std::runtime_error("has no normals");
    const Eigen::Matrix3d turn = place.linear().inverse().transpose();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector3d normal = (turn * vector_of(mesh.mNormals[v])).normalized();
      out.normals.push_back(normal.allFinite() ? normal : Eigen::Vector3d::UnitZ());
    }
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    out.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  if (place.linear().determinant() < 0) turn_over(out.triangles);
  return out;
}

}  // namespace

std::vector<MeshSurface> read_mesh_file(const std::filesystem::path& file, MeshNormals normals) {
  std::string bytes = bytes_of(file);
  std::string kind = file.extension().string();
  if (!kind.empty()) kind.erase(0, 1);
  std::ranges::transform(kind, kind.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == "msh") {
    bytes = obj_of_msh(bytes);
    kind = "obj";
  }
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  unsigned steps = aiProcess_Triangulate;  // what has more than four corners
  if (normals == MeshNormals::smooth) {
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCrease);
    // Vertices are one that differ in what is not drawn. Normals of files are often those of flat triangles; to drop them
    // is safe, where aiProcess_ForceGenNormals of assimp 5.2 frees those of degenerate meshes twice.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TEXCOORDS |
                                                            aiComponent_COLORS |
                                                            aiComponent_TANGENTS_AND_BITANGENTS |
                                                            aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS);
    steps |= aiProcess_RemoveComponent | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices;
  }
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, kind.c_str());
  if (scene != nullptr) {
    for (const std::span<aiMesh*> meshes(scene->mMeshes, scene->mNumMeshes); aiMesh* const mesh : meshes)
      split_quadrilaterals(*mesh);
    scene = importer.ApplyPostProcessing(steps);
  }
  if (scene == nullptr || scene->mNumMeshes == 0 || scene->mRootNode == nullptr)
    throw std::runtime_error(std::string("is no mesh that can be read: ") + importer.GetErrorString());
  std::vector<MeshSurface> out;
  std::vector<std::pair<const aiNode*, Eigen::Affine3d>> open{
      {scene->mRootNode, affine(scene->mRootNode->mTransformation)}};
  while (!open.empty()) {
    const auto [node, place] = open.back();
    open.pop_back();
    for (unsigned m = 0; m < node->mNumMeshes; ++m)
      if (node->mMeshes[m] < scene->mNumMeshes && is_surface(*scene->mMeshes[node->mMeshes[m]], normals))
        out.push_back(surface_of(*scene, *scene->mMeshes[node->mMeshes[m]], place, normals));
    // The first child is the next one.
    for (unsigned c = node->mNumChildren; c-- > 0;)
      open.emplace_back(node->mChildren[c], place * affine(node->mChildren[c]->mTransformation));
  }
  return out;
}

}  // namespace alembert
