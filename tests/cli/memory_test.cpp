// `report --memory`: what C99 of a mechanism takes on a machine.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

nlohmann::json functions_of(const std::string& options) {
  const TemporaryFolder folder;
  const CommandResult report =
      alembert(folder, "report " + mechanism_file("double_pendulum") +
                           " --functions coordinate_rates,forward_dynamics --json " + options);
  EXPECT_EQ(report.exit_code, 0) << report.err;
  return report.exit_code == 0 ? nlohmann::json::parse(report.out)["functions"] : nlohmann::json();
}

TEST(Memory, LongerFunctionsTakeMore) {
  for (const char* options : {"--memory double", "--memory float"}) {
    const nlohmann::json functions = functions_of(options);
    const auto &rates = functions["coordinate_rates"], &dynamics = functions["forward_dynamics"];
    EXPECT_GT(rates["code_bytes"], 10) << options;
    EXPECT_GT(dynamics["code_bytes"], 3 * rates["code_bytes"].get<int>()) << options;
    EXPECT_GT(dynamics["stack_bytes"], rates["stack_bytes"]) << options;
    EXPECT_LT(dynamics["stack_bytes"], 4096) << options;
  }
  EXPECT_FALSE(functions_of("")["forward_dynamics"].contains("code_bytes"));
}

TEST(Memory, FlagsAreThoseOfTheCompiler) {
  const int optimised = functions_of("--memory double")["forward_dynamics"]["code_bytes"];
  const int plain = functions_of("--memory double --compiler 'cc -O0'")["forward_dynamics"]["code_bytes"];
  EXPECT_GT(plain, optimised);
}

TEST(Memory, IsATable) {
  const TemporaryFolder folder;
  const CommandResult report = alembert(folder, "report " + mechanism_file("pendulum") + " --memory float");
  EXPECT_EQ(report.exit_code, 0);
  EXPECT_THAT(report.out, HasSubstr("C99 for float, compiled by `cc -O2`: bytes of code, of stack"));
}

TEST(Memory, ACompilerThatFailsIsAnError) {
  const TemporaryFolder folder;
  const std::string start = "report " + mechanism_file("pendulum");
  const CommandResult missing = alembert(folder, start + " --memory double --compiler no_such_compiler");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, HasSubstr("--compiler:1:1: error: cannot compile C99"));
  EXPECT_THAT(missing.err, HasSubstr("no_such_compiler"));
  const CommandResult silent = alembert(folder, start + " --memory double --compiler true");
  EXPECT_EQ(silent.exit_code, 1);
  EXPECT_EQ(alembert(folder, start + " --memory half").exit_code, 1);
  EXPECT_EQ(alembert(folder, start + " --compiler cc").exit_code, 1);
}

}  // namespace
}  // namespace alembert::test
