#include "commands/expand_xacro.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "commands/work_folder.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

/// Whether xacro has something to do: a file that it made may still declare its names.
bool needs_xacro(const SourceText& source) {
  if (source.name.ends_with(".xacro")) return true;
  const std::size_t robot = source.text.find("<robot");
  if (robot == std::string::npos) return false;
  const std::size_t end = source.text.find('>', robot);
  return source.text.substr(robot, end - robot).find("xmlns:xacro") != std::string::npos &&
         source.text.find("<xacro:", robot) != std::string::npos;
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
