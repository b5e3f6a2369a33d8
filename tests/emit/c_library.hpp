// Generated C99, compiled, loaded into the test and called by numbers of functions. In: files and a compiler.
// Out: what the functions give.
#pragma once

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "emit/argument_lists.hpp"
#include "emit/emit.hpp"
#include "functions/function_table.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"
#include "pipeline.hpp"

namespace sample {

/// A folder that is removed at the end.
struct Folder {
  std::string path = (std::filesystem::temp_directory_path() / "alembert_c99_XXXXXX").string();
  Folder() {
    if (::mkdtemp(path.data()) == nullptr) throw std::runtime_error("no folder " + path);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

/// Writes files into a folder.
inline void put(std::span<const alembert::EmittedFile> files, const std::string& folder) {
  for (const alembert::EmittedFile& file : files) {
    const std::filesystem::path path = std::filesystem::path(folder) / file.path;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << file.text;
  }
}

/// A description compiled to programs of all functions that give anything for it.
inline alembert::CompiledMechanism all_functions(const std::string& path,
                                                 alembert::CompileOptions options = {}) {
  for (const alembert::OutputFunction& row : alembert::kOutputFunctions) options.functions.emplace_back(row);
  options.inapplicable = alembert::Inapplicable::leave_out;
  return alembert::compile_mechanism(alembert::read_source(path), options);
}
inline std::vector<alembert::Program> programs_of(const alembert::CompiledMechanism& compiled) {
  std::vector<alembert::Program> programs;
  for (const alembert::CompiledFunction& function : compiled.functions) programs.push_back(function.program);
  return programs;
}

/// C that calls a function by its place in a list: call(i, arguments, t, parameters, wrenches, results).
inline std::string caller(const std::string& name, const std::vector<std::string>& functions,
                          const std::string& number) {
  std::string text = fmt::format(
      "#include <{0}/{0}.h>\n"
      "int call(int f, const {1}* const* a, {1} t, const {1}* p, const {1}* w, {1}* const* r);\n"
      "int call(int f, const {1}* const* a, {1} t, const {1}* p, const {1}* w, {1}* const* r) {{\n"
      "  switch (f) {{\n",
      name, number);
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const auto& signature = *alembert::find_function(functions[f]);
    text += fmt::format("    case {}: return {}_{}(", f, name, functions[f]);
    for (std::size_t i = 0; i < signature.arguments.size(); ++i) text += fmt::format("a[{}], ", i);
    if (signature.takes_inputs) text += "t, p, w, ";
    for (std::size_t i = 0; i < signature.results.size(); ++i)
      text += fmt::format("{}r[{}]", i == 0 ? "" : ", ", i);
    text += ");\n";
  }
  return text + "  }\n  (void)t, (void)p, (void)w;\n  return -1;\n}\n";
}

/// A folder with generated C and its caller, compiled to a library.
template <class Real>
class CLibrary {
 public:
  /// \param compiler  shell words
  CLibrary(const std::string& folder, const std::string& name, const std::string& compiler)
      : CLibrary(folder, compiler,
                 fmt::format("-std=c99 -Wstrict-prototypes -Wmissing-prototypes '-I{0}/include' "
                             "'{0}/src/{1}.c' '{0}/caller.c'",
                             folder, name),
                 0) {}
  /// Of sources that `words` name, by what they say besides warnings and optimisation.
  CLibrary(const std::string& folder, const std::string& compiler, const std::string& words, int) {
    const std::string library = fmt::format("{}/lib_{}.so", folder, std::hash<std::string>()(compiler));
    const std::string command = fmt::format(
        "{} -Wall -Wextra -pedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow "
        "-Werror -O0 -ffp-contract=off -shared -fPIC {} -o '{}' -lm",
        compiler, words, library);
    if (std::system(command.c_str()) != 0) {
      ADD_FAILURE() << "does not compile: " << command;
      return;
    }
    handle_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) {
      ADD_FAILURE() << ::dlerror();
      return;
    }
    call_ = reinterpret_cast<Call>(::dlsym(handle_, "call"));
  }
  ~CLibrary() {
    if (handle_ != nullptr) ::dlclose(handle_);
  }
  CLibrary(const CLibrary&) = delete;
  CLibrary& operator=(const CLibrary&) = delete;

  bool loaded() const { return call_ != nullptr; }
  int operator()(std::size_t function, const std::vector<const Real*>& arguments, Real t,
                 const Real* parameters, const Real* wrenches, const std::vector<Real*>& results) const {
    return call_(static_cast<int>(function), arguments.data(), t, parameters, wrenches, results.data());
  }

 private:
  using Call = int (*)(int, const Real* const*, Real, const Real*, const Real*, Real* const*);
  void* handle_ = nullptr;
  Call call_ = nullptr;
};

}  // namespace sample
