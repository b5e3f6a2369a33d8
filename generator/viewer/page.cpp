// Puts a scene into the page that was bundled when alembert was built.
#include "viewer/page.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "support/error.hpp"

namespace alembert {

namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string words(std::span<const std::uint32_t> values) {
  std::string bytes;
  for (const std::uint32_t value : values) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
  }
  return base64(bytes);
}

std::string float_words(std::span<const float> values) {
  std::vector<std::uint32_t> bits;
  for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return words(bits);
}

std::string float_words(std::span<const double> values) {
  std::vector<float> narrow;
  for (const double value : values) narrow.push_back(static_cast<float>(value));
  return float_words(narrow);
}

Json mesh_json(const Mesh& mesh) {
  std::vector<float> positions, normals;
  for (const Eigen::Vector3f& x : mesh.positions) positions.insert(positions.end(), x.begin(), x.end());
  for (const Eigen::Vector3f& x : mesh.normals) normals.insert(normals.end(), x.begin(), x.end());
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  return {{"closed", mesh.closed},
          {"positions", float_words(positions)},
          {"normals", float_words(normals)},
          {"indices", words(indices)}};
}

Json vector_json(const Eigen::Vector3d& x) {
  return {x[0], x[1], x[2]};
}

Json rotation_json(const Eigen::Isometry3d& placement) {
  const Eigen::Quaterniond r = Eigen::Quaterniond(placement.linear()).normalized();
  return {r.x(), r.y(), r.z(), r.w()};
}

Json parts_json(std::span<const ScenePart> parts) {
  Json out = Json::array();
  for (const ScenePart& part : parts) {
    out.push_back({{"mesh", part.mesh},
                   {"origin", vector_json(part.placement.translation())},
                   {"rotation", rotation_json(part.placement)},
                   {"color", part.color}});
  }
  return out;
}

Json series_json(std::span<const Series> all) {
  Json out = Json::array();
  for (const Series& series : all) {
    Json one = {{"name", series.name}, {"unit", series.unit}, {"values", float_words(series.values)}};
    // JSON has no infinity: a limit that is none is null.
    if (series.limits) one["limits"] = {Json(series.limits->first), Json(series.limits->second)};
    out.push_back(std::move(one));
  }
  return out;
}

std::string points_words(std::span<const Eigen::Vector3d> points) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& x : points) numbers.insert(numbers.end(), x.begin(), x.end());
  return float_words(numbers);
}

Json body_json(const SceneBody& body) {
  std::vector<double> rotations;
  for (const Eigen::Quaterniond& r : body.rotations)
    rotations.insert(rotations.end(), {r.x(), r.y(), r.z(), r.w()});
  return {{"name", body.name},
          {"mass", body.mass},
          {"center", vector_json(body.center_of_mass)},
          {"parts", parts_json(body.parts)},
          {"origins", points_words(body.origins)},
          {"rotations", float_words(rotations)}};
}

/// Adds what there is: pages of mechanisms without forces say nothing of them.
void add_acting(Json& json, const Acting& acting) {
  const auto add_series = [&](const char* key, std::span<const Series> all) {
    if (!all.empty()) json[key] = series_json(all);
  };
  add_series("forces", acting.forces);
  add_series("inputs", acting.inputs);
  add_series("states", acting.states);
  add_series("outputs", acting.outputs);
  for (const SceneLine& line : acting.lines) {
    Json points = Json::array();
    for (const std::vector<Eigen::Vector3d>& point : line.points) points.push_back(points_words(point));
    json["lines"].push_back({{"force", line.force}, {"points", std::move(points)}});
  }
  for (const SceneContact& contact : acting.contacts)
    json["contacts"].push_back({{"force", contact.force}, {"points", points_words(contact.points)}});
}

Json live_json(const LiveMechanism& live) {
  Json sliders = Json::array();
  for (const Slider& slider : live.sliders)
    sliders.push_back({{"name", slider.name},
                       {"place", slider.place},
                       {"low", slider.low},
                       {"high", slider.high},
                       {"input", slider.input}});
  return {{"module", live.module},
          {"t", live.t},
          {"q", live.q},
          {"qd", live.qd},
          {"parameters", live.parameters},
          {"sliders", std::move(sliders)}};
}

Json box_json(const Eigen::AlignedBox3d& box) {
  return {{"min", vector_json(box.min())}, {"max", vector_json(box.max())}};
}

void replace(std::string& text, std::string_view slot, std::string_view value) {
  const std::size_t at = text.find(slot);
  if (at == std::string::npos) throw InternalError("the page has no slot " + std::string(slot));
  text.replace(at, slot.size(), value);
}

/// By how much the total energy, the last series, leaves its first value.
double energy_change(std::span<const Series> energies) {
  double change = 0;
  if (energies.empty()) return change;
  for (const double value : energies.back().values)
    change = std::max(change, std::abs(value - energies.back().values.front()));
  return change;
}

}  // namespace

std::string scene_json(const Scene& scene) {
  Json json{{"title", scene.title}, {"meshes", Json::array()}, {"mechanisms", Json::array()}};
  for (const Mesh& mesh : scene.meshes) json["meshes"].push_back(mesh_json(mesh));
  for (const SceneMechanism& mechanism : scene.mechanisms) {
    Json bodies = Json::array();
    for (const SceneBody& body : mechanism.bodies) bodies.push_back(body_json(body));
    Json one{{"name", mechanism.name},
             {"description", mechanism.description},
             {"origin", vector_json(mechanism.placement.translation())},
             {"rotation", rotation_json(mechanism.placement)},
             {"bounds", box_json(bounds(scene, mechanism))},
             {"first_bounds", box_json(bounds(scene, mechanism, 1))},
             {"times", float_words(mechanism.times)},
             {"bodies", std::move(bodies)},
             {"scenery", parts_json(mechanism.scenery)},
             {"coordinates", series_json(mechanism.coordinates)},
             {"energies", series_json(mechanism.energies)},
             {"energy_change", energy_change(mechanism.energies)}};
    add_acting(one, mechanism.acting);
    if (mechanism.live) one["live"] = live_json(*mechanism.live);
    json["mechanisms"].push_back(std::move(one));
  }
  std::string out;
  for (const char c : json.dump(-1, ' ', true)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string html_page(const Scene& scene) {
  std::string page = page_template();
  if (page.empty()) throw InternalError("there is no page to put the scene into");
  // The scene stands behind the title in the page, so that no title can pass for its slot.
  replace(page, "@scene@", scene_json(scene));
  replace(page, "@title@", html_escaped(scene.title));
  return page;
}

}  // namespace alembert
