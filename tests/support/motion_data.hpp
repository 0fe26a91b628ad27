#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/motion/time_of_impact.hpp"

namespace toccata::test {

/// A question of the public data set, with what is true of it.
template <class Pair>
struct MotionQuery {
  std::string name;  ///< scene and number
  Pair pair;
  bool is_hit = false;
};

/// numerator / denominator, which is a double.
inline double exact_quotient(const std::string& numerator, const std::string& denominator) {
  const oracle::Rational exact{oracle::Integer(numerator), oracle::Integer(denominator)};
  const double value = exact.to_double();
  if (oracle::exact(value) != exact) throw std::runtime_error(numerator + "/" + denominator + " is no double");
  return value;
}

/// A point at one time.
struct MotionRow {
  Vec3 position;
  bool is_hit = false;
};

inline MotionRow motion_row(const std::string& line) {
  std::array<std::string, 7> field;
  std::istringstream in(line);
  for (std::string& f : field)
    if (!std::getline(in, f, ',')) throw std::runtime_error("seven numbers are wanted: " + line);
  return {{exact_quotient(field[0], field[1]), exact_quotient(field[2], field[3]), exact_quotient(field[4], field[5])},
          field[6].front() == '1'};
}

inline std::vector<MotionRow> motion_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<MotionRow> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(motion_row(line));
  if (rows.size() % 8 != 0) throw std::runtime_error(file.string() + ": eight rows a question are wanted");
  return rows;
}

template <class Pair>
[[nodiscard]] std::vector<MotionQuery<Pair>> motion_queries(const std::filesystem::path& data, const char* file,
                                                            Pair (*pair_of)(const std::array<MovingPoint, 4>&)) {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(data / "ccd"))
    if (std::filesystem::exists(entry.path() / file)) scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  std::vector<MotionQuery<Pair>> found;
  for (const std::filesystem::path& scene : scenes) {
    const std::vector<MotionRow> rows = motion_rows(scene / file);
    for (std::size_t i = 0; i < rows.size(); i += 8) {
      std::array<MovingPoint, 4> points;
      for (std::size_t k = 0; k < 4; ++k) points[k] = {rows[i + k].position, rows[i + k + 4].position};
      found.push_back({scene.filename().string() + " " + std::to_string(i / 8), pair_of(points), rows[i].is_hit});
    }
  }
  return found;
}

/// All questions in data_folder()/ccd, in the order of scenes and rows (shared data, `ccd`). Throws
/// std::runtime_error where a row is not as described, or a coordinate no double.
inline std::vector<MotionQuery<VertexFace>> vertex_face_queries(const std::filesystem::path& data) {
  return motion_queries<VertexFace>(data, "vertex-face.csv", [](const std::array<MovingPoint, 4>& p) {
    return VertexFace{p[0], {p[1], p[2], p[3]}};
  });
}

inline std::vector<MotionQuery<EdgeEdge>> edge_edge_queries(const std::filesystem::path& data) {
  return motion_queries<EdgeEdge>(data, "edge-edge.csv", [](const std::array<MovingPoint, 4>& p) {
    return EdgeEdge{{p[0], p[1]}, {p[2], p[3]}};
  });
}

}  // namespace toccata::test
