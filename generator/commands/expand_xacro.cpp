#include "commands/expand_xacro.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "commands/work_folder.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

std::string without_comments(std::string_view text) {
  std::string out;
  while (true) {
    const std::size_t begin = text.find("<!--");
    out += text.substr(0, begin);
    if (begin == std::string_view::npos) return out;
    const std::size_t end = text.find("-->", begin + 4);
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + 3);
  }
}

/// Whether xacro has something to do: a file that it made may still declare its names and have them in comments.
bool needs_xacro(const SourceText& source) {
  if (source.name.ends_with(".xacro")) return true;
  if (source.text.find("<xacro:") == std::string::npos) return false;
  const std::string text = without_comments(source.text);
  const std::size_t robot = text.find("<robot");
  if (robot == std::string::npos) return false;
  const std::size_t end = text.find('>', robot);
  return text.substr(robot, end - robot).find("xmlns:xacro") != std::string::npos &&
         text.find("<xacro:", robot) != std::string::npos;
}

}  // namespace

std::shared_ptr<const SourceText> read_expanded(const std::string& path) {
  std::shared_ptr<const SourceText> source = read_source(path);
  if (!needs_xacro(*source)) return source;
  const SourceLocation start{source, 1, 1};
  constexpr const char* kExpand = "expand it first: xacro FILE > robot.urdf";
  if (path == "-")
    throw InputError(start, "xacro needs a file, beside which it finds what it includes", kExpand);
  const WorkFolder folder("xacro");
  // An absolute path is no option, whatever the file is called.
  const ProgramRun run = folder.run({"xacro", std::filesystem::absolute(path).string()});
  if (run.exit_code == 127)
    throw InputError(start, "this needs the program xacro, which is not on PATH", kExpand);
  if (run.exit_code != 0)
    throw InputError(start, fmt::format("xacro failed with exit code {}", run.exit_code), run.errors);
  tell(run.errors);
  return std::make_shared<const SourceText>(SourceText{source->name + ", expanded by xacro", run.out});
}

}  // namespace alembert
