// C99 for float on a Cortex-M4F, compiled by arm-none-eabi-gcc and run by qemu, against the interpreter and against
// this machine. Prints code size and stack of each function.
#include <gtest/gtest.h>

#include <bit>
#include <cstdio>
#include <limits>
#include <map>
#include <sstream>

#include "emit/c_library.hpp"
#include "emit/c_state.hpp"

namespace sample {
namespace {

constexpr int kStates = 3;
constexpr const char* kArmCompiler =
    "arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -Wall -Wextra "
    "-pedantic -Werror -Wconversion -Wdouble-promotion -O2 -ffunction-sections";

/// What a command says; its exit code must be 0.
std::string said(const std::string& command) {
  std::string out;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(command);
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << out;
  return out;
}

std::string list(const std::vector<std::string>& items) {
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

/// states.h: places of arguments and results, and the states' numbers as bits.
std::string states_header(const std::vector<Program>& programs, const std::vector<CState<float>>& states) {
  std::vector<std::string> arguments, results, counts, rows;
  const std::vector<ArgumentKind> order{ArgumentKind::q,     ArgumentKind::qd, ArgumentKind::qdd,
                                        ArgumentKind::tau,   ArgumentKind::mu, ArgumentKind::parameter,
                                        ArgumentKind::wrench};
  std::map<ArgumentKind, std::size_t> places;
  std::size_t state_size = 0, largest = 0;
  for (const ArgumentKind kind : order) {
    places[kind] = state_size;
    state_size += states[0].array(kind).size();
  }
  for (const Program& program : programs) {
    std::vector<std::string> to_arguments, to_results;
    for (const ArgumentKind kind : alembert::find_function(program.function)->arguments)
      to_arguments.push_back(std::to_string(places[kind]));
    if (to_arguments.empty()) to_arguments.emplace_back("0");
    std::size_t size = 0;
    for (const alembert::OutputArray& output : program.outputs) {
      to_results.push_back(std::to_string(size));
      size += output.values.size();
    }
    arguments.push_back(list(to_arguments));
    results.push_back(list(to_results));
    counts.push_back(std::to_string(size));
    largest = std::max(largest, size);
  }
  for (const CState<float>& state : states) {
    std::vector<std::string> bits;
    const auto add = [&](float x) {
      bits.push_back(fmt::format("0x{:08x}u", std::bit_cast<std::uint32_t>(x)));
    };
    for (const ArgumentKind kind : order)
      for (const float x : state.array(kind)) add(x);
    add(state.t);
    rows.push_back(list(bits));
  }
  return fmt::format(
      "enum {{ STATES = {}, FUNCTIONS = {}, STATE = {}, RESULTS = {}, PARAMETERS = {}, WRENCHES = {}, TIME = "
      "{} }};\n"
      "static const int argument_places[FUNCTIONS][4] = {};\n"
      "static const int result_places[FUNCTIONS][6] = {};\n"
      "static const int result_counts[FUNCTIONS] = {};\n"
      "static const uint32_t states[STATES][STATE] = {};\n",
      states.size(), programs.size(), state_size + 1, largest, places[ArgumentKind::parameter],
      places[ArgumentKind::wrench], state_size, list(arguments), list(results), list(counts), list(rows));
}

/// Bytes of code of each function, with its blocks, by name; "" is all that they share.
std::map<std::string, std::size_t> code_sizes(const std::string& object, const std::string& mechanism,
                                              const std::vector<Program>& programs) {
  std::map<std::string, std::size_t> sizes;
  std::istringstream lines(said("arm-none-eabi-nm -S --defined-only '" + object + "'"));
  std::string address, size, type, symbol;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    if (!(words >> address >> size >> type >> symbol) || (type != "T" && type != "t")) continue;
    std::string owner;
    for (const Program& program : programs)
      if (symbol == mechanism + "_" + program.function ||
          symbol.starts_with(mechanism + "_" + program.function + "_block"))
        owner = program.function;
    sizes[owner] += std::stoul(size, nullptr, 16);
  }
  return sizes;
}

void check_on_cortex_m4(const std::string& path) {
  const alembert::CompiledMechanism compiled = all_functions(path);
  const Mechanism& mechanism = *compiled.mechanism;
  const std::vector<Program> programs = programs_of(compiled);
  alembert::EmitOptions options;
  options.language = alembert::Language::c;
  options.scalars = {"float"};
  std::vector<alembert::EmittedFile> files = alembert::emit_mechanism(mechanism, programs, options);
  std::vector<std::string> names;
  std::vector<CState<float>> states;
  for (const Program& program : programs) names.push_back(program.function);
  for (int seed = 0; seed < kStates; ++seed) states.emplace_back(mechanism, static_cast<std::uint64_t>(seed));
  files.push_back({"caller.c", caller(mechanism.name, names, "float")});
  files.push_back({"states.h", states_header(programs, states)});
  const Folder folder;
  put(files, folder.path);
  const CLibrary<float> here(folder.path, mechanism.name, ALEMBERT_HOST_C_COMPILER);
  ASSERT_TRUE(here.loaded());
  const std::string image = folder.path + "/image.elf", object = folder.path + "/functions.o";
  said(fmt::format("{0} -I'{1}/include' -c '{1}/src/{2}.c' -o '{3}'", kArmCompiler, folder.path,
                   mechanism.name, object));
  said(fmt::format(
      "{0} -nostartfiles -I'{1}' -I'{1}/include' -T '{2}/memory.ld' '{3}' '{1}/caller.c' '{2}/board.c' "
      "--specs=nosys.specs -lm -o '{4}' 2>&1",
      kArmCompiler, folder.path, ALEMBERT_SOURCE_DIR "/tests/emit/cortex_m4", object, image));
  ASSERT_FALSE(testing::Test::HasFailure());
  std::istringstream output(said(fmt::format(
      "timeout 60 qemu-system-arm -M mps2-an386 -cpu cortex-m4 -nographic -monitor none -serial none "
      "-semihosting-config enable=on,target=native -kernel '{}' 2>&1",
      image)));

  std::vector<std::size_t> stack(programs.size());
  double furthest = 0;
  for (const CState<float>& state : states) {
    for (std::size_t f = 0; f < programs.size(); ++f) {
      const Program& program = programs[f];
      std::string line;
      ASSERT_TRUE(std::getline(output, line)) << program.function;
      const std::size_t colon = line.find(':');
      ASSERT_NE(colon, std::string::npos) << line;
      stack[f] = std::max(stack[f], std::stoul(line.substr(0, colon), nullptr, 16));
      std::istringstream words(line.substr(colon + 1));
      std::vector<float> results;
      for (std::string word; words >> word;)
        results.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(std::stoul(word, nullptr, 16))));
      const std::vector<double> expected = state.interpreted(program);
      ASSERT_EQ(results.size(), expected.size()) << line;
      expect_near(program, results, expected, program.function + " on a Cortex-M4F");
      const CCall<float> host(here, f, program, state);
      expect_near(program, results, {host.results.begin(), host.results.end()},
                  program.function + " there and here");
      double largest = std::numeric_limits<double>::min();
      for (const double x : expected) largest = std::max(largest, std::abs(x));
      for (std::size_t i = 0; i < results.size(); ++i)
        furthest = std::max(furthest, std::abs(static_cast<double>(results[i]) - expected[i]) / largest);
    }
  }
  std::map<std::string, std::size_t> code = code_sizes(object, mechanism.name, programs);
  fmt::print("{} in float on a Cortex-M4F, -O2: bytes of code, of stack with calls into the C library\n",
             mechanism.name);
  for (std::size_t f = 0; f < programs.size(); ++f) {
    fmt::print("  {:<30} {:>7} {:>7}\n", programs[f].function, code[programs[f].function], stack[f]);
    EXPECT_GT(code[programs[f].function], 0u);
    EXPECT_LT(stack[f], 65536u);
  }
  fmt::print("  shared {} bytes; furthest from the interpreter {:.1e} of the largest entry\n", code[""],
             furthest);
}

TEST(CortexM4, Pendulum) {
  check_on_cortex_m4(ALEMBERT_SOURCE_DIR "/mechanisms/pendulum.yaml");
}
TEST(CortexM4, Puma560) {
  check_on_cortex_m4(ALEMBERT_SOURCE_DIR "/mechanisms/puma560.yaml");
}

}  // namespace
}  // namespace sample
