// Runs compilers and their tools (see the header).
#include "commands/compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "support/error.hpp"

namespace alembert {
namespace {

/// Words at blanks; what stands between two quotes, ' or ", is of one word.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  char quote = 0;
  bool inside = false;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\n';
    if (quote == 0 && blank) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// The first line of an error, or of anything.
std::string_view first_error(std::string_view said) {
  std::string_view rest = said;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (line.find("error") != std::string_view::npos) return line;
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  }
  return said.substr(0, said.find('\n'));
}

}  // namespace

Compiler::Compiler(std::string origin, const std::string& words, std::string language, std::string advice)
    : origin_(std::move(origin)),
      text_(words),
      language_(std::move(language)),
      advice_(std::move(advice)),
      words_(words_of(words)) {
  if (words_.empty() || words_.front().empty()) fail("names no compiler");
}

void Compiler::fail(const std::string& message) const {
  throw InputError({std::make_shared<const SourceText>(SourceText{origin_, text_}), 1, 1}, message, advice_);
}

std::vector<std::string> Compiler::command(std::span<const std::string> own) const {
  std::vector<std::string> words = words_;
  // `ccache g++ -O3`: the flags begin where a word is one.
  const auto flags = std::ranges::find_if(words, [](const std::string& w) { return w.starts_with('-'); });
  words.insert(flags, own.begin(), own.end());
  return words;
}

std::string Compiler::run(const WorkFolder& folder, std::span<const std::string> own,
                          std::span<const std::string> arguments) const {
  std::vector<std::string> words = command(own);
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ProgramRun done = folder.run(words);
  if (done.exit_code != 0)
    fail(fmt::format("cannot compile {}: {}", language_,
                     printable(done.errors.empty() ? fmt::format("it ended with {}", done.exit_code)
                                                   : first_error(done.errors),
                               200)));
  return done.out;
}

std::optional<std::string> Compiler::run_tool(const WorkFolder& folder, std::string_view tool,
                                              std::span<const std::string> arguments) const {
  std::vector<std::string> command = words_;
  command.push_back(fmt::format("-print-prog-name={}", tool));
  std::string name = folder.run(command).out;
  name.erase(name.find_last_not_of('\n') + 1);
  if (name.empty()) return std::nullopt;
  command.assign(1, name);
  command.insert(command.end(), arguments.begin(), arguments.end());
  ProgramRun done = folder.run(command);
  if (done.exit_code != 0) return std::nullopt;
  return std::move(done.out);
}

std::optional<std::vector<CodeSymbol>> code_symbols(const Compiler& compiler, const WorkFolder& folder,
                                                    const std::string& object) {
  const std::optional<std::string> listed =
      compiler.run_tool(folder, "nm", std::vector<std::string>{"-S", "-C", "--defined-only", object});
  if (!listed) return std::nullopt;
  std::vector<CodeSymbol> symbols;
  std::istringstream lines(*listed);
  std::string address, size, type;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    CodeSymbol symbol;
    // Symbols without a size have a column less.
    if (!(words >> address >> size >> type) || size.size() != address.size() || type.size() != 1 ||
        std::string_view("tTwW").find(type) == std::string_view::npos)
      continue;
    std::getline(words >> std::ws, symbol.name);
    symbol.bytes = std::stoul(size, nullptr, 16);
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}

}  // namespace alembert
