// Descriptions that scripts write: the committed ones are what the scripts write now, and chains of any
// length load and obey their laws.
#include <gmock/gmock.h>

#include "paper/tree_motion.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

/// Standard output of a script in mechanisms/paper.
CommandResult script(const TemporaryFolder& folder, const std::string& arguments) {
  return run_command(folder, ALEMBERT_PYTHON " " ALEMBERT_SOURCE_DIR "/mechanisms/paper/" + arguments, "",
                     60);
}

TEST(Scripts, WriteTheCommittedDescriptions) {
  const TemporaryFolder folder;
  for (const auto& [arguments, name] : std::vector<std::pair<std::string, std::string>>{
           {"tong.py", "tong"},
           {"torus_chain.py 6", "torus_chain_6"},
           {"torus_chain.py 14", "torus_chain_14"},
           {"torus_chain.py 14 --linked", "torus_chain_linked_14"}}) {
    const CommandResult result = script(folder, arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, read_text(paper_file(name))) << arguments;
  }
}

TEST(Scripts, RefuseNumbersThatMakeNoChain) {
  const TemporaryFolder folder;
  for (const char* arguments :
       {"torus_chain.py 7", "torus_chain.py 0", "revolute_chain.py 0", "tong.py 0", "torus_chain.py x"}) {
    const CommandResult result = script(folder, arguments);
    EXPECT_NE(result.exit_code, 0) << arguments;
    EXPECT_NE(result.err, "") << arguments;
    EXPECT_EQ(result.out, "") << arguments;
  }
}

void expect_laws(const TemporaryFolder& folder, const std::string& arguments, const std::string& head) {
  const CommandResult written = script(folder, arguments);
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const CommandResult checked = run_for_a_minute(folder, "check -", written.out);
  ASSERT_EQ(checked.exit_code, 0) << arguments << "\n" << checked.err;
  EXPECT_THAT(checked.out, HasSubstr(head)) << arguments;
  EXPECT_THAT(checked.out, HasSubstr("Q = M qdd + c")) << arguments;
}

TEST(Scripts, ToriFrom6To46Coordinates) {
  const TemporaryFolder folder;
  for (const int n : {6, 10, 18, 46})
    expect_laws(folder, "torus_chain.py " + std::to_string(n), std::to_string(n) + " coordinates");
  expect_laws(folder, "torus_chain.py --linked 18", "18 coordinates");
}

TEST(Scripts, RevoluteChainsFrom2To40Links) {
  const TemporaryFolder folder;
  for (const int n : {2, 3, 6, 12, 40}) {
    expect_laws(folder, "revolute_chain.py " + std::to_string(n), std::to_string(n) + " coordinates");
  }
  // Each chain begins like the next longer one.
  const std::string longer = script(folder, "revolute_chain.py 12").out,
                    shorter = script(folder, "revolute_chain.py 11").out;
  const std::string body =
      shorter.substr(shorter.find("bodies:"), shorter.find("link11") - shorter.find("bodies:"));
  EXPECT_THAT(longer, HasSubstr(body));
}

TEST(Scripts, TongsOfAnyLengthHaveThreeCoordinates) {
  const TemporaryFolder folder;
  for (const int n : {1, 2, 30}) expect_laws(folder, "tong.py " + std::to_string(n), "3 coordinates");
}

}  // namespace
}  // namespace alembert::test
