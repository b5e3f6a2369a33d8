// Compiles C99 and reads what the compiler and its tools say of it, see the header.
#include "commands/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "commands/common_options.hpp"
#include "commands/compiler.hpp"
#include "commands/work_folder.hpp"
#include "emit/emit.hpp"

namespace alembert {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The function that a symbol is of, or is a block of; functions.size() for helpers. Compilers call copies of
/// functions NAME.part.0 and the like.
std::size_t function_of(std::string_view symbol, const CompiledMechanism& compiled, bool& block) {
  symbol = symbol.substr(0, symbol.find('.'));
  for (std::size_t f = 0; f < compiled.functions.size(); ++f) {
    const std::string name =
        fmt::format("{}_{}", compiled.mechanism->name, to_string(compiled.functions[f].kind));
    block = symbol.starts_with(name + "_block");
    if (block || symbol == name) return f;
  }
  return compiled.functions.size();
}

}  // namespace

MechanismMemory measured_memory(const CompiledMechanism& compiled, const std::string& scalar,
                                const std::string& compiler) {
  const WorkFolder folder("memory");
  const Compiler cc("--compiler", compiler, "C99");
  EmitOptions options;
  options.language = Language::c;
  options.scalars = {scalar};
  for (const EmittedFile& file : emit_mechanism(*compiled.mechanism, programs_of(compiled), options))
    folder.write(file);
  const std::string object = folder / "code.o";
  const std::vector<std::string> arguments{"-std=c99",
                                           "-fstack-usage",
                                           "-I" + folder / "include",
                                           "-c",
                                           folder / ("src/" + compiled.mechanism->name + ".c"),
                                           "-o",
                                           object};
  cc.run(folder, {}, arguments);

  MechanismMemory memory;
  const std::size_t count = compiled.functions.size();
  memory.functions.resize(count);
  bool block = false;
  const std::optional<std::vector<CodeSymbol>> symbols = code_symbols(cc, folder, object);
  const std::optional<std::string> sections =
      cc.run_tool(folder, "size", std::vector<std::string>{"-A", object});
  if (!symbols || !sections) cc.fail("has no nm and size beside it, which tell the code that functions take");
  for (const CodeSymbol& symbol : *symbols) {
    const std::size_t f = function_of(symbol.name, compiled, block);
    (f < count ? memory.functions[f].code : memory.shared_code) += symbol.bytes;
  }
  std::string name, size;
  std::istringstream section_lines(*sections);
  for (std::string line; std::getline(section_lines, line);) {
    std::istringstream words(line);
    if (words >> name >> size && name.starts_with(".rodata")) memory.constants += std::stoul(size);
  }

  // A line a function: place:name, bytes, static.
  std::vector<std::size_t> own(count), blocks(count);
  std::size_t helpers = 0, lines = 0;
  std::istringstream stacks(text_of(folder / "code.su"));
  for (std::string line; std::getline(stacks, line); ++lines) {
    std::istringstream words(line.substr(line.rfind(':', line.find('\t')) + 1));
    std::size_t bytes = 0;
    if (!(words >> name >> bytes)) cc.fail("says nothing of the stack that functions take");
    const std::size_t f = function_of(name, compiled, block);
    std::size_t& most = f == count ? helpers : block ? blocks[f] : own[f];
    most = std::max(most, bytes);
  }
  if (lines < count) cc.fail("says nothing of the stack that functions take");
  for (std::size_t f = 0; f < count; ++f) memory.functions[f].stack = own[f] + blocks[f] + helpers;
  return memory;
}

}  // namespace alembert
