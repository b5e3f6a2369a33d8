#include "commands/expand_xacro.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <pugixml.hpp>
#include <string_view>

#include "commands/work_folder.hpp"
#include "import/common/xml_text.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

/// Whether xacro has something to do: a file that it made may still declare its names and have them in comments.
bool needs_xacro(const SourceText& source) {
  if (source.name.ends_with(".xacro")) return true;
  if (source.text.find("<xacro:") == std::string::npos) return false;
  pugi::xml_document document;
  // What is wrong with the text, its reader says.
  document.load_buffer(source.text.data(), source.text.size());
  const pugi::xml_node root = document.document_element();
  return std::string_view(root.name()) == "robot" && root.attribute("xmlns:xacro") &&
         root.find_node(
             [](pugi::xml_node node) { return std::string_view(node.name()).starts_with(kXacroPrefix); });
}

}  // namespace

std::shared_ptr<const SourceText> read_expanded(const std::string& path) {
  std::shared_ptr<const SourceText> source = read_source(path);
  if (!needs_xacro(*source)) return source;
  const SourceLocation start{source, 1, 1};
  if (path == "-")
    throw InputError(start, "xacro needs a file, beside which it finds what it includes", kExpandXacro);
  const WorkFolder folder("xacro");
  // An absolute path is no option, whatever the file is called.
  const ProgramRun run = folder.run({"xacro", std::filesystem::absolute(path).string()});
  if (run.exit_code == 127)
    throw InputError(start, "this needs the program xacro, which is not on PATH", kExpandXacro);
  if (run.exit_code != 0)
    throw InputError(start, fmt::format("xacro failed with exit code {}", run.exit_code), run.errors);
  tell(run.errors);
  return std::make_shared<const SourceText>(SourceText{source->name + ", expanded by xacro", run.out});
}

}  // namespace alembert
