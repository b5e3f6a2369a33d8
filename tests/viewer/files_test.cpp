// The bytes of .glb files and the scene in pages: read back and compared with the scene.
#include <gmock/gmock.h>

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "viewer/glb.hpp"
#include "viewer/page.hpp"
#include "viewer/small_scene.hpp"

namespace alembert::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kHangingPendulum = R"(alembert: 1
name: pendulum
description: "Ends: </script><script>alert(1)</script> @scene@ @title@ <b>&amp;"
coordinates: [q]
bodies:
  - name: bob
    transform:
      - rotate: {axis: y, angle: q}
      - translate: [0, 0, -0.5]
    mass: 2
    inertia: {xx: 0.01, yy: 0.02, zz: 0.02}
)";

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t k = 0; k < 4; ++k)
    out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + k))) << (8 * k);
  return out;
}

/// The two chunks of a .glb file.
struct Glb {
  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2u);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::size_t size = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = Json::parse(bytes.substr(20, size));
    EXPECT_EQ(word(bytes, 20 + size), bytes.size() - 28 - size);
    EXPECT_EQ(bytes.substr(24 + size, 4), std::string("BIN\0", 4));
    binary = bytes.substr(28 + size);
  }
  std::vector<float> floats(std::size_t accessor) const {
    const Json& a = json["accessors"][accessor];
    const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    std::vector<float> out;
    for (std::size_t i = 0; i < view["byteLength"].get<std::size_t>(); i += 4)
      out.push_back(std::bit_cast<float>(word(binary, view["byteOffset"].get<std::size_t>() + i)));
    return out;
  }
  Json json;
  std::string binary;
};

TEST(Glb, HoldsPosesAsAnAnimation) {
  std::vector<double> angles;
  for (int k = 0; k < 100; ++k) angles.push_back(0.2 * k);
  const SmallScene small(kHangingPendulum, angles);
  const SceneBody& bob = small.scene.mechanisms.at(0).bodies.at(0);
  const Glb glb(glb_file(small.scene));
  const Json& animation = glb.json["animations"].at(0);
  int checked = 0;
  for (const Json& channel : animation["channels"]) {
    const Json& node = glb.json["nodes"][channel["target"]["node"].get<std::size_t>()];
    EXPECT_EQ(node["name"], "bob");
    const Json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
    EXPECT_EQ(sampler["interpolation"], "LINEAR");
    const std::vector<float> times = glb.floats(sampler["input"]);
    const std::vector<float> values = glb.floats(sampler["output"]);
    ASSERT_EQ(times.size(), angles.size());
    const bool rotation = channel["target"]["path"] == "rotation";
    ASSERT_EQ(values.size(), angles.size() * (rotation ? 4 : 3));
    for (std::size_t k = 0; k < angles.size(); ++k) {
      EXPECT_FLOAT_EQ(times[k], 0.1F * static_cast<float>(k));
      for (std::size_t i = 0; i < (rotation ? 4u : 3u); ++i) {
        const Eigen::Index a = static_cast<Eigen::Index>(i);
        const double expected = rotation ? bob.rotations[k].coeffs()[a] : bob.origins[k][a];
        EXPECT_NEAR(static_cast<double>(values[(rotation ? 4 : 3) * k + i]), expected, 1e-6);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 700);
}

TEST(Glb, HoldsTheMeshesOnce) {
  SmallScene small(kHangingPendulum, {0.1, 0.2});
  small.add(kHangingPendulum, {0.1, 0.2});
  const Glb glb(glb_file(small.scene));
  EXPECT_EQ(glb.json["meshes"].size(), small.scene.mechanisms[0].bodies[0].parts.size());
  std::size_t parts = 0;
  for (const Json& node : glb.json["nodes"]) parts += node.contains("mesh") ? 1 : 0;
  EXPECT_EQ(parts, 2 * glb.json["meshes"].size());
}

TEST(Glb, OfAMomentHasNoAnimation) {
  const SmallScene small(kHangingPendulum, {0.3});
  const Glb glb(glb_file(small.scene));
  EXPECT_FALSE(glb.json.contains("animations"));
  const Json& bob = glb.json["nodes"].at(2);
  EXPECT_EQ(bob["name"], "bob");
  EXPECT_NEAR(bob["translation"][0].get<double>(), -0.5 * std::sin(0.3), 1e-12);
}

std::vector<float> floats_of_base64(const std::string& text) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  std::vector<float> out;
  for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) out.push_back(std::bit_cast<float>(word(bytes, i)));
  return out;
}

TEST(Page, HoldsTheScene) {
  // 1, 2, 3, ... frames: every length of base64's last group.
  for (const std::size_t count : {1u, 2u, 3u, 4u}) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < count; ++k) angles.push_back(0.3 * static_cast<double>(k));
    const SmallScene small(kHangingPendulum, angles);
    const Json json = Json::parse(scene_json(small.scene));
    const Json& mechanism = json["mechanisms"].at(0);
    EXPECT_EQ(mechanism["description"], small.scene.mechanisms[0].description);
    const std::vector<float> q = floats_of_base64(mechanism["coordinates"].at(0)["values"]);
    ASSERT_EQ(q.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_FLOAT_EQ(q[k], static_cast<float>(angles[k]));
    const std::vector<float> origins = floats_of_base64(mechanism["bodies"].at(0)["origins"]);
    ASSERT_EQ(origins.size(), 3 * count);
    EXPECT_EQ(floats_of_base64(json["meshes"].at(0)["positions"]).size(),
              3 * small.scene.meshes[0].positions.size());
  }
}

TEST(Page, HasUnitsAndLimitsOfCoordinates) {
  const SmallScene small(R"(alembert: 1
name: units
parameters: {r: 0.3}
coordinates: [{name: turn, limits: [-1, 2]}, slide, slanted, geared, roll, {name: place, limits: [-3, 3]}, along]
bodies:
  - {name: a, transform: [{joint: {type: revolute, axis: z, coordinates: [turn]}}], mass: 1}
  - {name: b, transform: [{joint: {type: prismatic, axis: x, coordinates: [slide]}}], mass: 1}
  - {name: c, transform: [{joint: {type: prismatic, axis: [1, 2, 2], coordinates: [slanted]}}], mass: 1}
  - {name: d, transform: [{translate: [r*geared, 0, 0]}], mass: 1}
  - {name: e, transform: [{translate: [r*roll, 0, 0]}, {rotate: {axis: y, angle: roll}}], mass: 1}
  - {name: f, transform: [{translate: [cos(place), sin(place), 0]}], mass: 1}
  - {name: g, transform: [{translate: [along, along^2, 0]}], mass: 1}
)",
                         {0.1, 0.2});
  const Json json = Json::parse(scene_json(small.scene));
  const Json& coordinates = json["mechanisms"].at(0)["coordinates"];
  std::vector<std::string> units;
  for (const Json& series : coordinates) units.push_back(series["unit"]);
  EXPECT_THAT(units, testing::ElementsAre("rad", "m", "m", "", "rad", "rad", ""));
  EXPECT_EQ(coordinates[0]["limits"], Json({-1.0, 2.0}));
  EXPECT_EQ(coordinates[5]["limits"], Json({-3.0, 3.0}));
  EXPECT_FALSE(coordinates[1].contains("limits"));
  EXPECT_EQ(json["mechanisms"].at(0)["energies"].at(2)["unit"], "J");
}

/// A line of three points and a contact, over four frames.
Acting some_acting(const std::string& name) {
  Acting acting;
  acting.forces = {{name, {0, -5, 10, 2.5}, "N", {}}, {"touch" + name, {0, 8, 1, 0}, "N", {}}};
  acting.inputs = {{"in" + name, {1, 2, 3, 4}, "", {{0, 5}}}};
  acting.outputs = {{"out" + name, {4, 3, 2, 1}, "m", {}}};
  SceneLine line{0, {}};
  SceneContact contact{1, {}};
  for (int i = 0; i < 3; ++i) {
    line.points.emplace_back();
    for (int k = 0; k < 4; ++k) line.points.back().emplace_back(0.1 * k, 1.0 * i, -0.2 * k * i);
  }
  for (int k = 0; k < 4; ++k) contact.points.emplace_back(0, 0.1 * k, 2);
  acting.lines.push_back(line);
  acting.contacts.push_back(contact);
  return acting;
}

TEST(Page, HoldsWhatActs) {
  const Acting acting = some_acting("pull");
  const SmallScene small(kHangingPendulum, {0.1, 0.2, 0.3, 0.4}, acting);
  const Json mechanism = Json::parse(scene_json(small.scene))["mechanisms"].at(0);
  const auto expect_points = [](const std::vector<float>& numbers,
                                const std::vector<Eigen::Vector3d>& points) {
    ASSERT_EQ(numbers.size(), 3 * points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_FLOAT_EQ(numbers[i], static_cast<float>(points[i / 3][static_cast<Eigen::Index>(i % 3)]));
  };
  EXPECT_EQ(floats_of_base64(mechanism["forces"].at(0)["values"]), (std::vector<float>{0, -5, 10, 2.5}));
  EXPECT_EQ(mechanism["inputs"].at(0)["limits"], Json({0.0, 5.0}));
  EXPECT_EQ(mechanism["outputs"].at(0)["unit"], "m");
  EXPECT_EQ(mechanism["lines"].at(0)["force"], 0);
  ASSERT_EQ(mechanism["lines"].at(0)["points"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    expect_points(floats_of_base64(mechanism["lines"].at(0)["points"].at(i)), acting.lines[0].points[i]);
  EXPECT_EQ(mechanism["contacts"].at(0)["force"], 1);
  expect_points(floats_of_base64(mechanism["contacts"].at(0)["points"]), acting.contacts[0].points);
  const Json without = Json::parse(scene_json(SmallScene(kHangingPendulum, {0.1}).scene))["mechanisms"].at(0);
  for (const char* key : {"forces", "inputs", "outputs", "lines", "contacts"})
    EXPECT_FALSE(without.contains(key)) << key;
}

TEST(Glb, HoldsForcesAsTubesAndBalls) {
  const Acting acting = some_acting("pull");
  const SmallScene small(kHangingPendulum, {0.1, 0.2, 0.3, 0.4}, acting);
  const Glb glb(glb_file(small.scene));
  const Json& animation = glb.json["animations"].at(0);
  std::vector<std::vector<float>> tube_scales;
  std::vector<float> ball_scale, tube_places;
  for (const Json& channel : animation["channels"]) {
    const std::string name = glb.json["nodes"][channel["target"]["node"].get<std::size_t>()]["name"];
    const std::string path = channel["target"]["path"];
    const std::vector<float> values =
        glb.floats(animation["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    if (name == "pull" && path == "scale") tube_scales.push_back(values);
    if (name == "pull" && path == "translation" && tube_places.empty()) tube_places = values;
    if (name == "touchpull" && path == "scale") ball_scale = values;
  }
  ASSERT_EQ(tube_scales.size(), 2u);
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double length = (acting.lines[0].points[i + 1][k] - acting.lines[0].points[i][k]).norm();
      EXPECT_FLOAT_EQ(tube_scales[i].at(3 * k + 2), static_cast<float>(length));
    }
    const Eigen::Vector3d middle = (acting.lines[0].points[0][k] + acting.lines[0].points[1][k]) / 2;
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_NEAR(static_cast<double>(tube_places.at(3 * k + a)), middle[static_cast<Eigen::Index>(a)], 1e-6);
  }
  // No pull, 5 N the other way, 10 N, 2.5 N.
  const std::vector<float>& radii = tube_scales[0];
  EXPECT_TRUE(radii[0] < radii[9] && radii[9] < radii[3] && radii[3] < radii[6]);
  EXPECT_LT(ball_scale.at(0), 1e-4F);
  EXPECT_GT(ball_scale.at(3), 2 * ball_scale.at(6) / 3);
  EXPECT_GT(ball_scale.at(6), 1e3F * ball_scale.at(9));
}

TEST(Page, HoldsWhatMovesByItself) {
  SmallScene small(kHangingPendulum, {0.1, 0.2});
  EXPECT_FALSE(Json::parse(scene_json(small.scene))["mechanisms"].at(0).contains("live"));
  LiveMechanism live;
  live.module = "export { q };";
  live.q = {0.1};
  live.parameters = {0.1 + 0.2};
  live.sliders = {{"length", 0, 0.2, 3, false}};
  small.scene.mechanisms[0].live = live;
  const Json mechanism = Json::parse(scene_json(small.scene))["mechanisms"].at(0);
  EXPECT_EQ(mechanism["live"]["module"], live.module);
  EXPECT_EQ(mechanism["live"]["parameters"].at(0), 0.1 + 0.2) << "to the last digit";
  EXPECT_EQ(mechanism["live"]["sliders"].at(0)["low"], 0.2);
  EXPECT_GT(mechanism["bodies"].at(0)["mass"], 0);
}

TEST(Page, LetsNoTextEndItsElement) {
  const std::string evil = "</script><script>alert(1)</script>";
  SmallScene small(kHangingPendulum, {0.1, 0.2, 0.3, 0.4}, some_acting(evil));
  LiveMechanism& live = small.scene.mechanisms[0].live.emplace();
  live.module = evil;
  live.sliders = {{evil, 0, 0, 1, true}};
  EXPECT_EQ(Json::parse(scene_json(small.scene))["mechanisms"].at(0)["outputs"].at(0)["name"], "out" + evil);
  EXPECT_EQ(scene_json(small.scene).find('<'), std::string::npos);
  EXPECT_EQ(html_escaped("</title><b a=\"x\">&"), "&lt;/title&gt;&lt;b a=&quot;x&quot;&gt;&amp;");
  if (page_template().empty()) GTEST_SKIP() << "built without the page";
  const std::string page = html_page(small.scene), empty = page_template();
  const auto count = [](const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count(page, "<script"), count(empty, "<script"));
  EXPECT_EQ(count(page, "</script"), count(empty, "</script"));
  EXPECT_THAT(page, testing::HasSubstr("<title>pendulum</title>"));
}

}  // namespace
}  // namespace alembert::test
