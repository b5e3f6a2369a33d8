#include "import/urdf/mesh_files.hpp"

#include "import/common/mesh_names.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

/// A name, and the folder that it must not leave.
struct Candidate {
  fs::path file, within;
};

/// The folders above the robot's file, nearest first; none of one from standard input.
std::vector<fs::path> folders_above(const std::string& robot) {
  std::vector<fs::path> out;
  if (robot == "<stdin>") return out;
  for (fs::path at = fs::weakly_canonical(fs::absolute(robot)).parent_path();; at = at.parent_path()) {
    out.push_back(at);
    if (at == at.parent_path()) return out;
  }
}

std::vector<Candidate> in_package(const std::string& rest, const std::vector<fs::path>& above,
                                  const std::vector<std::string>& folders) {
  const std::size_t slash = rest.find('/');
  if (slash == std::string::npos || slash == 0) return {};
  const fs::path package = rest.substr(0, slash), file = rest.substr(slash + 1);
  std::vector<Candidate> out;
  const auto add = [&](const fs::path& folder) { out.push_back({folder / file, folder}); };
  for (const fs::path& folder : above)
    if (folder.filename() == package) add(folder);
  for (const std::string& each : folders) {
    const fs::path folder = fs::weakly_canonical(fs::absolute(each));
    if (folder.filename() == package) add(folder);
    add(fs::weakly_canonical(folder / package));  // which may be a link
  }
  return out;
}

}  // namespace

std::optional<fs::path> find_urdf_mesh(const std::string& name, const std::string& robot,
                                       const std::vector<std::string>& folders) {
  const std::vector<fs::path> above = folders_above(robot);
  std::vector<Candidate> candidates;
  const std::size_t colon = name.find("://");
  const std::string scheme = colon == std::string::npos ? "" : name.substr(0, colon);
  const std::string rest = colon == std::string::npos ? name : name.substr(colon + 3);
  if (scheme == "package" || scheme == "model") {
    candidates = in_package(rest, above, folders);
  } else if (scheme.empty() || scheme == "file") {
    // The package that the robot is of, too: its folder has a package.xml.
    for (const fs::path& folder : above)
      if (folder == above.front() || fs::exists(folder / "package.xml"))
        candidates.push_back({above.front() / rest, folder});
    for (const std::string& each : folders) {
      const fs::path folder = fs::weakly_canonical(fs::absolute(each));
      candidates.push_back({folder / rest, folder});
    }
  }
  for (const Candidate& candidate : candidates) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(candidate.file, error);
    if (!error && lies_below(file, candidate.within) && fs::is_regular_file(file, error)) return file;
  }
  return std::nullopt;
}

}  // namespace alembert
