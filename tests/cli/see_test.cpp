// `simulate --html --glb --scene`: what is written, and what is said where nothing can be.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The JSON chunk of a .glb file.
nlohmann::json glb_json(const std::string& bytes) {
  EXPECT_THAT(bytes, StartsWith("glTF"));
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(i)));
  };
  return nlohmann::json::parse(bytes.substr(20, byte(12) | byte(13) << 8 | byte(14) << 16));
}

/// Frames in the first animation of a scene.
std::size_t frames(const nlohmann::json& glb) {
  const std::size_t times = glb["animations"].at(0)["samplers"].at(0)["input"];
  return glb["accessors"].at(times)["count"];
}

TEST(See, WritesASceneAndNoTableUnlessAsked) {
  const TemporaryFolder folder;
  const std::string glb = folder / "out.glb";
  const CommandResult result = alembert(
      folder, "simulate " + mechanism_file("double_pendulum") + " --duration 1 --q 1,0.5 --glb " + glb);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const nlohmann::json scene = glb_json(read_text(glb));
  EXPECT_EQ(frames(scene), 60u);  // each 17 ms, and the end
  std::vector<std::string> names;
  for (const nlohmann::json& node : scene["nodes"]) names.push_back(node["name"]);
  EXPECT_THAT(names, testing::IsSupersetOf({"double_pendulum", "upper", "lower"}));
}

TEST(See, RowsAndFramesEachHaveTheirRate) {
  const TemporaryFolder folder;
  const std::string common = "simulate " + mechanism_file("double_pendulum") + " --duration 0.1 --q 1,0.5 ";
  const std::string csv = folder / "out.csv", glb = folder / "out.glb";
  ASSERT_EQ(alembert(folder, common + "--every 7 --csv " + csv).exit_code, 0);
  const std::string alone = read_text(csv);
  const CommandResult both = alembert(folder, common + "--every 7 --fps 100 --csv " + csv + " --glb " + glb);
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(read_text(csv), alone);
  EXPECT_EQ(frames(glb_json(read_text(glb))), 11u);
}

TEST(See, KeepsWhatThereIsOfAMotionThatStops) {
  const TemporaryFolder folder;
  const std::string glb = folder / "out.glb";
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file("tori_mated") + " --duration 3 --glb " + glb);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("is singular just before t = 1.4"));
  EXPECT_GT(frames(glb_json(read_text(glb))), 50u);
}

TEST(See, ShowsSeveralMechanisms) {
  const TemporaryFolder folder;
  const std::string glb = folder / "out.glb";
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file("pendulum") + " --duration 0.1 --q 1 --scene " +
                           mechanism_file("cart_pole") + "," + mechanism_file("pendulum") + " --glb " + glb);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json shown = glb_json(read_text(glb));
  ASSERT_EQ(shown["animations"].size(), 3u);
  EXPECT_EQ(shown["animations"][0]["name"], "pendulum");
  EXPECT_EQ(shown["animations"][1]["name"], "cart_pole");
  EXPECT_EQ(shown["animations"][2]["name"], "pendulum 2");
}

TEST(See, WritesThePageOrSaysWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string html = folder / "out.html";
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file("pendulum") + " --duration 0.1 --html " + html);
  if (result.exit_code == 0) {
    EXPECT_THAT(read_text(html), StartsWith("<!doctype html>"));
    EXPECT_THAT(read_text(html), HasSubstr("<title>pendulum</title>"));
    EXPECT_EQ(
        std::distance(std::filesystem::directory_iterator(std::filesystem::path(html).parent_path()), {}), 4)
        << "out.html, and what the test itself wrote";
  } else {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("built without its page, which needs npm"));
    EXPECT_THAT(result.err, HasSubstr("-DALEMBERT_BUILD_VIEWER=ON"));
    EXPECT_FALSE(std::filesystem::exists(html));
  }
}

TEST(See, RefusesWhatMakesNoSense) {
  const TemporaryFolder folder;
  const std::string pendulum = "simulate " + mechanism_file("pendulum");
  const auto error = [&](const std::string& options) {
    const CommandResult result = alembert(folder, pendulum + options);
    EXPECT_EQ(result.exit_code, 1) << options;
    return result.err;
  };
  EXPECT_THAT(error(" --scene " + mechanism_file("cart_pole")), HasSubstr("--scene needs --html or --glb"));
  EXPECT_THAT(error(" --fps 0 --glb " + (folder / "a.glb")), HasSubstr("--fps"));
  EXPECT_THAT(error(" --duration 1e5 --fps 1000 --glb " + (folder / "a.glb")),
              HasSubstr("frames are too many to be seen"));
  EXPECT_THAT(error(" --duration 0.1 --glb /proc/none/a.glb"), HasSubstr("/proc/none"));
  EXPECT_THAT(error(" --html " + (folder / "a") + " --glb " + (folder / "./a")),
              HasSubstr("--html and --glb are the same file"));
  EXPECT_THAT(error(" --csv " + (folder / "a") + " --glb " + (folder / "a")),
              HasSubstr("--csv and --glb are the same file"));
  const std::string copy = folder.write("copy.yaml", read_text(mechanism_file("pendulum")));
  EXPECT_THAT(alembert(folder, "simulate " + copy + " --csv " + copy).err,
              HasSubstr("the description and --csv are the same file"));
  EXPECT_EQ(read_text(copy), read_text(mechanism_file("pendulum")));
}

}  // namespace
}  // namespace alembert::test
