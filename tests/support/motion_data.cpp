#include "support/motion_data.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "oracle/rational.hpp"

namespace toccata::test {
namespace {

/// numerator / denominator, which is a double.
double quotient(const std::string& numerator, const std::string& denominator) {
  const oracle::Rational exact{oracle::Integer(numerator), oracle::Integer(denominator)};
  const double value = exact.to_double();
  if (oracle::exact(value) != exact) throw std::runtime_error(numerator + "/" + denominator + " is no double");
  return value;
}

struct Row {
  Vec3 position;
  bool is_hit = false;
};

Row row_of(const std::string& line) {
  std::array<std::string, 7> field;
  std::istringstream in(line);
  for (std::string& f : field)
    if (!std::getline(in, f, ',')) throw std::runtime_error("seven numbers are wanted: " + line);
  return {{quotient(field[0], field[1]), quotient(field[2], field[3]), quotient(field[4], field[5])},
          field[6].front() == '1'};
}

std::vector<Row> rows_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(row_of(line));
  if (rows.size() % 8 != 0) throw std::runtime_error(file.string() + ": eight rows a question are wanted");
  return rows;
}

template <class Pair>
std::vector<MotionQuery<Pair>> queries(const std::filesystem::path& data, const char* file,
                                       Pair (*pair_of)(const std::array<MovingPoint, 4>&)) {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(data / "ccd"))
    if (std::filesystem::exists(entry.path() / file)) scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  std::vector<MotionQuery<Pair>> found;
  for (const std::filesystem::path& scene : scenes) {
    const std::vector<Row> rows = rows_of(scene / file);
    for (std::size_t i = 0; i < rows.size(); i += 8) {
      std::array<MovingPoint, 4> points;
      for (std::size_t k = 0; k < 4; ++k) points[k] = {rows[i + k].position, rows[i + k + 4].position};
      found.push_back({scene.filename().string() + " " + std::to_string(i / 8), pair_of(points), rows[i].is_hit});
    }
  }
  return found;
}

}  // namespace

std::vector<MotionQuery<VertexFace>> vertex_face_queries(const std::filesystem::path& data) {
  return queries<VertexFace>(data, "vertex-face.csv", [](const std::array<MovingPoint, 4>& p) {
    return VertexFace{p[0], {p[1], p[2], p[3]}};
  });
}

std::vector<MotionQuery<EdgeEdge>> edge_edge_queries(const std::filesystem::path& data) {
  return queries<EdgeEdge>(data, "edge-edge.csv", [](const std::array<MovingPoint, 4>& p) {
    return EdgeEdge{{p[0], p[1]}, {p[2], p[3]}};
  });
}

}  // namespace toccata::test
