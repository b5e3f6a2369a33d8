// Compiles C99 and reads what the compiler and its tools say of it, see the header.
#include "commands/memory.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>

#include "emit/emit.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

/// A folder of its own, removed at the end.
class WorkFolder {
 public:
  WorkFolder() : path_((std::filesystem::temp_directory_path() / "alembert_memory_XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), "no folder " + path_);
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  std::string operator/(std::string_view name) const { return fmt::format("{}/{}", path_, name); }

 private:
  std::string path_;
};

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What a compiler and the tools beside it say of one source file.
class CompilerRun {
 public:
  explicit CompilerRun(const std::string& words) : words_(words) {}

  [[noreturn]] void fail(const std::string& message) const {
    const SourceLocation here{std::make_shared<const SourceText>(SourceText{"--compiler", words_}), 1, 1};
    throw InputError(here, message);
  }
  /// Standard output of a command.
  std::string run(const std::string& command) const {
    const std::string out = folder_ / "out", errors = folder_ / "errors";
    if (std::system(fmt::format("{} > '{}' 2> '{}'", command, out, errors).c_str()) != 0) {
      const std::string said = text_of(errors);
      fail(fmt::format("cannot compile C99: {}", printable(said.substr(0, said.find('\n')))));
    }
    return text_of(out);
  }
  /// Output of a tool of the compiler's, such as nm.
  std::string run_tool(const std::string& tool, const std::string& arguments) const {
    std::string name = run(fmt::format("{} -print-prog-name={}", words_, tool));
    name.erase(name.find_last_not_of('\n') + 1);
    return run(fmt::format("'{}' {}", name, arguments));
  }
  void write(const EmittedFile& file) const {
    const std::filesystem::path path = folder_ / file.path;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << file.text;
  }
  const WorkFolder& folder() const { return folder_; }
  const std::string& words() const { return words_; }

 private:
  std::string words_;
  WorkFolder folder_;
};

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
  const CompilerRun run(compiler);
  EmitOptions options;
  options.language = Language::c;
  options.scalars = {scalar};
  std::vector<Program> programs;
  for (const CompiledFunction& function : compiled.functions) programs.push_back(function.program);
  for (const EmittedFile& file : emit_mechanism(*compiled.mechanism, programs, options)) run.write(file);
  const std::string object = run.folder() / "code.o";
  run.run(fmt::format("{} -std=c99 -fstack-usage -I'{}' -c '{}' -o '{}'", run.words(),
                      run.folder() / "include", run.folder() / ("src/" + compiled.mechanism->name + ".c"),
                      object));

  MechanismMemory memory;
  const std::size_t count = compiled.functions.size();
  memory.functions.resize(count);
  bool block = false;
  std::istringstream symbols(run.run_tool("nm", "-S --defined-only '" + object + "'"));
  std::string address, size, type, name;
  for (std::string line; std::getline(symbols, line);) {
    std::istringstream words(line);
    if (!(words >> address >> size >> type >> name) || (type != "T" && type != "t")) continue;
    const std::size_t f = function_of(name, compiled, block);
    (f < count ? memory.functions[f].code : memory.shared_code) += std::stoul(size, nullptr, 16);
  }
  std::istringstream sections(run.run_tool("size", "-A '" + object + "'"));
  for (std::string line; std::getline(sections, line);) {
    std::istringstream words(line);
    if (words >> name >> size && name.starts_with(".rodata")) memory.constants += std::stoul(size);
  }

  // A line a function: place:name, bytes, static.
  std::vector<std::size_t> own(count), blocks(count);
  std::size_t helpers = 0, lines = 0;
  std::istringstream stacks(text_of(run.folder() / "code.su"));
  for (std::string line; std::getline(stacks, line); ++lines) {
    std::istringstream words(line.substr(line.rfind(':', line.find('\t')) + 1));
    std::size_t bytes = 0;
    if (!(words >> name >> bytes)) run.fail("says nothing of the stack that functions take");
    const std::size_t f = function_of(name, compiled, block);
    std::size_t& most = f == count ? helpers : block ? blocks[f] : own[f];
    most = std::max(most, bytes);
  }
  if (lines < count) run.fail("says nothing of the stack that functions take");
  for (std::size_t f = 0; f < count; ++f) memory.functions[f].stack = own[f] + blocks[f] + helpers;
  return memory;
}

}  // namespace alembert
