// Writes .glb files: a JSON chunk that describes one binary chunk of meshes, times and poses (glTF 2.0).
#include "viewer/glb.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "viewer/moving_parts.hpp"

namespace alembert {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the format.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

void append_word(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * k) & 0xFF);
}
void append_float(std::string& bytes, float value) {
  append_word(bytes, std::bit_cast<std::uint32_t>(value));
}

/// Linear share of a colour component as screens have it.
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

Json floats(std::span<const float> values) {
  Json out = Json::array();
  for (const float value : values) out.push_back(static_cast<double>(value));
  return out;
}

class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {
    for (const SceneMechanism& mechanism : scene.mechanisms)
      forces_.push_back(moving_parts(scene_, mechanism));
    json_["asset"] = {{"version", "2.0"}, {"generator", "alembert"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"name", scene.title}, {"nodes", {0}}}});
    // About x by -90 degrees: z up becomes y up.
    json_["nodes"] = Json::array({{{"name", "z up"}, {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}}});
  }

  std::string write() {
    Json roots = Json::array();
    for (std::size_t i = 0; i < scene_.mechanisms.size(); ++i)
      roots.push_back(add(scene_.mechanisms[i], forces_[i]));
    if (!roots.empty()) node(0)["children"] = std::move(roots);
    if (!binary_.empty()) json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return file();
  }

 private:
  Json& node(std::size_t index) { return json_["nodes"][index]; }

  std::size_t add_node(const std::string& name) {
    json_["nodes"].push_back({{"name", name}});
    return json_["nodes"].size() - 1;
  }

  /// Accessor over floats, `width` of them an element.
  std::size_t add_floats(std::span<const float> values, std::size_t width, bool with_bounds, int target) {
    static constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", 4 * values.size()}};
    if (target != 0) view["target"] = target;
    json_["bufferViews"].push_back(std::move(view));
    for (const float value : values) append_float(binary_, value);
    Json accessor{{"bufferView", json_["bufferViews"].size() - 1},
                  {"componentType", kFloat},
                  {"count", values.size() / width},
                  {"type", kTypes[width]}};
    if (with_bounds) {
      std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
      std::vector<float> most = least;
      for (std::size_t i = 0; i < values.size(); ++i) {
        least[i % width] = std::min(least[i % width], values[i]);
        most[i % width] = std::max(most[i % width], values[i]);
      }
      accessor["min"] = floats(least);
      accessor["max"] = floats(most);
    }
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
  }

  std::size_t add_indices(const Mesh& mesh) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", binary_.size()},
                                    {"byteLength", 12 * mesh.triangles.size()},
                                    {"target", kElementArrayBuffer}});
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t index : triangle) append_word(binary_, index);
    }
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", kUnsignedInt},
                                  {"count", 3 * mesh.triangles.size()},
                                  {"type", "SCALAR"}});
    return json_["accessors"].size() - 1;
  }

  /// The numbers of a mesh, written once however often it is used.
  const Json& geometry(std::size_t index) {
    const auto found = geometries_.find(index);
    if (found != geometries_.end()) return found->second;
    const Mesh& mesh = scene_.meshes[index];
    std::vector<float> positions, normals;
    for (const Eigen::Vector3f& x : mesh.positions) positions.insert(positions.end(), x.begin(), x.end());
    for (const Eigen::Vector3f& x : mesh.normals) normals.insert(normals.end(), x.begin(), x.end());
    Json attributes;
    attributes["POSITION"] = add_floats(positions, 3, true, kArrayBuffer);
    attributes["NORMAL"] = add_floats(normals, 3, false, kArrayBuffer);
    Json primitive;
    primitive["attributes"] = std::move(attributes);
    primitive["indices"] = add_indices(mesh);
    return geometries_[index] = std::move(primitive);
  }

  std::size_t material(const Color& color, bool both_sides) {
    const auto key = std::pair(color, both_sides);
    const auto found = materials_.find(key);
    if (found != materials_.end()) return found->second;
    Json material{{"pbrMetallicRoughness",
                   {{"baseColorFactor", {linear(color[0]), linear(color[1]), linear(color[2]), 1}},
                    {"metallicFactor", 0.1},
                    {"roughnessFactor", 0.55}}}};
    if (both_sides) material["doubleSided"] = true;
    json_["materials"].push_back(std::move(material));
    return materials_[key] = json_["materials"].size() - 1;
  }

  /// glTF's meshes bear their material.
  std::size_t colored_mesh(std::size_t mesh, const Color& color) {
    const std::size_t material_index = material(color, !scene_.meshes[mesh].closed);
    const auto key = std::pair(mesh, material_index);
    const auto found = meshes_.find(key);
    if (found != meshes_.end()) return found->second;
    Json primitive = geometry(mesh);
    primitive["material"] = material_index;
    json_["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
    return meshes_[key] = json_["meshes"].size() - 1;
  }

  std::size_t add(const ScenePart& part, const std::string& name) {
    const std::size_t index = add_node(name);
    const std::size_t mesh = colored_mesh(part.mesh, part.color);
    node(index)["mesh"] = mesh;
    place(index, part.placement);
    return index;
  }

  void place(std::size_t index, const Eigen::Isometry3d& placement) {
    place(index, placement.translation(), Eigen::Quaterniond(placement.linear()).normalized());
  }
  void place(std::size_t index, const Eigen::Vector3d& origin, const Eigen::Quaterniond& rotation) {
    if (origin != Eigen::Vector3d::Zero()) node(index)["translation"] = {origin[0], origin[1], origin[2]};
    if (rotation.vec() != Eigen::Vector3d::Zero())
      node(index)["rotation"] = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  }

  /// Channels of an animation, over the frames that are kept.
  struct Animation {
    std::vector<std::size_t> frames;
    std::size_t times = 0;  ///< accessor
    bool moves = false;
    Json channels = Json::array(), samplers = Json::array();
  };

  void add_channel(Animation& animation, std::size_t node_index, const char* path, std::size_t output) {
    animation.channels.push_back(
        {{"sampler", animation.samplers.size()}, {"target", {{"node", node_index}, {"path", path}}}});
    animation.samplers.push_back(
        {{"input", animation.times}, {"interpolation", "LINEAR"}, {"output", output}});
  }
  std::size_t add_vectors(const Animation& animation, std::span<const Eigen::Vector3d> vectors) {
    std::vector<float> numbers;
    for (const std::size_t k : animation.frames) {
      const Eigen::Vector3f x = vectors[k].cast<float>();
      numbers.insert(numbers.end(), x.begin(), x.end());
    }
    return add_floats(numbers, 3, false, 0);
  }
  void animate(Animation& animation, std::size_t node_index, std::span<const Eigen::Vector3d> origins,
               std::span<const Eigen::Quaterniond> rotations) {
    if (!animation.moves) return;
    std::vector<float> turns;
    for (const std::size_t k : animation.frames) {
      const Eigen::Vector4f r = rotations[k].coeffs().cast<float>().normalized();
      turns.insert(turns.end(), r.begin(), r.end());
    }
    add_channel(animation, node_index, "translation", add_vectors(animation, origins));
    add_channel(animation, node_index, "rotation", add_floats(turns, 4, false, 0));
  }

  std::size_t add(const MovingPart& part, Animation& animation) {
    const std::size_t index = add({part.mesh, Eigen::Isometry3d::Identity(), part.color}, part.name);
    place(index, part.origins[0], part.rotations[0]);
    const Eigen::Vector3d& scale = part.scales[0];
    node(index)["scale"] = {scale[0], scale[1], scale[2]};
    animate(animation, index, part.origins, part.rotations);
    if (animation.moves) add_channel(animation, index, "scale", add_vectors(animation, part.scales));
    return index;
  }

  std::size_t add(const SceneMechanism& mechanism, std::span<const MovingPart> forces) {
    const std::size_t index = add_node(mechanism.name);
    place(index, mechanism.placement);
    Json children = Json::array();
    for (const ScenePart& part : mechanism.scenery) children.push_back(add(part, "world"));
    Animation animation;
    std::vector<float> kept;
    animation.frames = distinct_frames(mechanism.times, kept);
    animation.moves = animation.frames.size() > 1 && !(mechanism.bodies.empty() && forces.empty());
    if (animation.moves) animation.times = add_floats(kept, 1, true, 0);
    for (const SceneBody& body : mechanism.bodies) {
      const std::size_t body_index = add_node(body.name);
      children.push_back(body_index);
      if (!body.origins.empty()) place(body_index, body.origins[0], body.rotations[0]);
      Json parts = Json::array();
      for (const ScenePart& part : body.parts)
        parts.push_back(add(part, body.name + " shape " + std::to_string(parts.size() + 1)));
      if (!parts.empty()) node(body_index)["children"] = std::move(parts);
      animate(animation, body_index, body.origins, body.rotations);
    }
    for (const MovingPart& part : forces) children.push_back(add(part, animation));
    if (animation.moves) {
      Json json{{"name", mechanism.name}};
      json["channels"] = std::move(animation.channels);
      json["samplers"] = std::move(animation.samplers);
      json_["animations"].push_back(std::move(json));
    }
    if (!children.empty()) node(index)["children"] = std::move(children);
    return index;
  }

  /// Frames whose times, as the file holds them, increase.
  static std::vector<std::size_t> distinct_frames(std::span<const double> times, std::vector<float>& kept) {
    std::vector<std::size_t> frames;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const float time = static_cast<float>(times[k]);
      if (!kept.empty() && time <= kept.back()) continue;
      kept.push_back(time);
      frames.push_back(k);
    }
    return frames;
  }

  std::string file() const {
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string out;
    append_word(out, kMagic);
    append_word(out, kVersion);
    const std::size_t binary_chunk = binary_.empty() ? 0 : 8 + binary_.size();
    append_word(out, static_cast<std::uint32_t>(12 + 8 + text.size() + binary_chunk));
    append_word(out, static_cast<std::uint32_t>(text.size()));
    append_word(out, kJsonChunk);
    out += text;
    if (binary_.empty()) return out;
    append_word(out, static_cast<std::uint32_t>(binary_.size()));
    append_word(out, kBinaryChunk);
    return out + binary_;
  }

  Scene scene_;                                  ///< with the meshes of forces
  std::vector<std::vector<MovingPart>> forces_;  ///< of each mechanism
  Json json_;
  std::string binary_;  // only words of four bytes, so every view is aligned
  std::map<std::size_t, Json> geometries_;
  std::map<std::pair<Color, bool>, std::size_t> materials_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> meshes_;
};

}  // namespace

std::string glb_file(const Scene& scene) {
  return GlbWriter(scene).write();
}

}  // namespace alembert
