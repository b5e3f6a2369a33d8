// Curves with straight parts and Frenet frames: the message names the body, the coordinate and the cure.
#include <gmock/gmock.h>

#include "paper/tree_motion.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

/// The train on the figure of eight, with Frenet frames instead of the reference.
std::string with_frenet_frames(const std::string& initial) {
  std::string text = read_text(paper_file("train_reference"));
  const auto replace = [&](const std::string& from, const std::string& to) {
    std::size_t found = text.find(from);
    EXPECT_NE(found, std::string::npos) << from;
    for (; found != std::string::npos; found = text.find(from, found + to.size()))
      text.replace(found, from.size(), to);
  };
  replace("frame: {reference: [0, 0, 1]}", "frame: frenet");
  replace("{name: s, initial: 0.9}", "{name: s, initial: " + initial + "}");
  return text;
}

TEST(Frenet, AtTheInitialState) {
  const TemporaryFolder folder;
  for (const char* command : {"check", "simulate", "report"}) {
    const CommandResult result =
        alembert(folder, std::string(command) + " " + folder.write("eight.yaml", with_frenet_frames("0")));
    EXPECT_EQ(result.exit_code, 1) << command;
    EXPECT_THAT(result.err, HasSubstr("eight.yaml:")) << command;
    EXPECT_THAT(result.err, HasSubstr("Frenet")) << command;
    EXPECT_THAT(result.err, HasSubstr("'car1'")) << command;
    EXPECT_THAT(result.err, HasSubstr("'s'")) << command;
    EXPECT_THAT(result.err, HasSubstr("frame: {reference: [x, y, z]}")) << command;
  }
}

TEST(Frenet, AlongTheWay) {
  const TemporaryFolder folder;
  const std::string csv = folder / "out.csv";
  const CommandResult result =
      run_for_a_minute(folder, "simulate --step 0.01 --every 1 --duration 30 --csv " + csv + " " +
                                   folder.write("eight.yaml", with_frenet_frames("0.9")));
  EXPECT_EQ(result.exit_code, 1);
  for (const char* part :
       {"eight.yaml:", "Frenet", "body 'car1'", "t = 6.7", "s = 3.14", "frame: {reference: [x, y, z]}"})
    EXPECT_THAT(result.err, HasSubstr(part));
  // What was there before is kept: the first car comes down to the straight part below the bridge.
  const std::string rows = read_text(csv);
  const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
  EXPECT_NEAR(std::stod(last), 6.77, 0.02);
  EXPECT_NEAR(std::stod(last.substr(last.find(',') + 1)), M_PI, 0.02);
}

TEST(Frenet, AReferenceCuresIt) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "simulate --duration 2 --step 0.01 --q 0,0,0,0,0 --qd 1,0,0,0,0 " +
                           paper_file("train_reference"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace alembert::test
