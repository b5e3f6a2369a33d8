// Hulls by qhull, with the options that MuJoCo gives it: they decide which vertices a hull has where some nearly lie in one
// plane.
#include "import/common/convex_hull.hpp"

#include <fmt/format.h>
#include <libqhull_r/qhull_ra.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace alembert {
namespace {

/// A run of qhull. Its messages go to a temporary file, not to the command's stderr.
class Qhull {
 public:
  Qhull() {
    if (!messages_)
      throw std::runtime_error("has a hull that cannot be built: no temporary file can be opened");
    qh_zero(&state_, messages_.get());
  }
  ~Qhull() {
    qh_freeqhull(&state_, qh_ALL);
    int blocks = 0, bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// The points are kept by reference.
  void run(std::vector<double>& points, std::string command) {
    const int error = qh_new_qhull(&state_, 3, static_cast<int>(points.size() / 3), points.data(), False,
                                   command.data(), nullptr, messages_.get());
    if (error == qh_ERRnone) return;
    if (error == qh_ERRsingular || error == qh_ERRinput)
      throw std::runtime_error("has no hull: its vertices are fewer than four, or lie in one plane");
    throw std::runtime_error(fmt::format("has a hull that cannot be built: error {} of qhull", error));
  }

  TriangleMesh triangles() const {
    const qhT* const qh = &state_;  // the name that qhull's macros look for
    TriangleMesh out;
    const facetT* facet = nullptr;
    FORALLfacets {
      std::array<std::size_t, 3> triangle;
      std::size_t corners = 0;
      for (void** each = &facet->vertices->e[0].p; *each != nullptr && corners < 3; ++each) {
        const auto* const vertex = static_cast<const vertexT*>(*each);
        triangle[corners++] = static_cast<std::size_t>(vertex->point - qh->first_point) / 3;
      }
      if (facet->toporient) std::swap(triangle[0], triangle[1]);
      out.triangles.push_back(triangle);
    }
    return out;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> messages_{std::tmpfile()};
  qhT state_;
};

}  // namespace

TriangleMesh convex_hull(const TriangleMesh& mesh, std::optional<int> vertices) {
  std::vector<double> points;
  for (const Eigen::Vector3d& v : mesh.vertices) points.insert(points.end(), {v.x(), v.y(), v.z()});
  // Qt: facets of more corners become triangles. TA: so many vertices more than the first four, Q9: the farthest next.
  std::string command = "qhull Qt";
  if (vertices) command += fmt::format(" Q9 TA{}", *vertices - 4);
  Qhull qhull;
  qhull.run(points, command);
  TriangleMesh out = qhull.triangles();
  out.vertices = mesh.vertices;
  return out;
}

}  // namespace alembert
