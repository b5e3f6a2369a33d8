#include "import/common/mesh_names.hpp"

#include <algorithm>

namespace alembert {

namespace fs = std::filesystem;

bool lies_below(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

std::string described_mesh_name(const fs::path& file, const std::string& folder) {
  if (folder.empty()) return file.generic_string();
  const fs::path from = fs::weakly_canonical(fs::absolute(folder));
  return fs::weakly_canonical(fs::absolute(file)).lexically_proximate(from).generic_string();
}

}  // namespace alembert
