// A compiler that the user names, and the tools beside it. In: words such as `g++ -O3 -march=native`. Out: what
// they print; errors that show the words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands/work_folder.hpp"

namespace alembert {

class Compiler {
 public:
  /// \param origin    where the words come from, for errors: `--compiler`
  /// \param words     program and flags with blanks between them; quotes keep blanks together
  /// \param language  what is compiled, for errors
  /// \param advice    what errors end with
  Compiler(std::string origin, const std::string& words, std::string language, std::string advice = "");

  /// Program and flags as they are run: `own` flags stand before the user's, which so prevail.
  std::vector<std::string> command(std::span<const std::string> own) const;

  /// Standard output of command(own) with `arguments` behind it. InputError with what the compiler said if it fails.
  std::string run(const WorkFolder& folder, std::span<const std::string> own,
                  std::span<const std::string> arguments) const;

  /// Standard output of a tool of the compiler's, such as nm; nothing if there is none or it fails.
  std::optional<std::string> run_tool(const WorkFolder& folder, std::string_view tool,
                                      std::span<const std::string> arguments) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string origin_, text_, language_, advice_;
  std::vector<std::string> words_;
};

/// A symbol of an object file that is code.
struct CodeSymbol {
  std::string name;  ///< as in the source where it is of C++
  std::size_t bytes = 0;
};

/// The code in an object file by `nm`; nothing if that cannot be had.
std::optional<std::vector<CodeSymbol>> code_symbols(const Compiler& compiler, const WorkFolder& folder,
                                                    const std::string& object);

}  // namespace alembert
