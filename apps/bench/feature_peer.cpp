#include "feature_peer.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "programs.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

namespace fs = std::filesystem;

std::string line_of(const char* kind, std::initializer_list<MovingPoint> points) {
  std::string line = kind;
  const auto add = [&](const Vec3& p) { line += fmt::format(" {:a} {:a} {:a}", p.x, p.y, p.z); };
  for (const MovingPoint& p : points) add(p.start);
  for (const MovingPoint& p : points) add(p.end);
  return line + "\n";
}

void write_questions(const fs::path& file, const std::vector<VertexFace>& vertex_faces,
                     const std::vector<EdgeEdge>& edge_edges) {
  std::ofstream out(file);
  for (const VertexFace& q : vertex_faces) out << line_of("vertex-face", {q.vertex, q.face[0], q.face[1], q.face[2]});
  for (const EdgeEdge& q : edge_edges) out << line_of("edge-edge", {q.a[0], q.a[1], q.b[0], q.b[1]});
}

FeaturePeer peer_of(const fs::path& file) {
  const nlohmann::json json = nlohmann::json::parse(std::ifstream(file));
  FeaturePeer peer{json.at("version"), {}, {}};
  for (const auto& method : json.at("methods")) {
    peer.methods.push_back({method.at("name"), method.at("floor_ns"), {}});
    for (const auto& answer : method.at("answers"))
      peer.methods.back().answers.push_back({answer.at("hit"), answer.at("ns")});
  }
  return peer;
}

/// A folder of its own, which ends with it.
class FolderForAWhile {
 public:
  FolderForAWhile() {
    std::string pattern = (fs::temp_directory_path() / "toccata-bench-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern + ": could not be made");
    path_ = pattern;
  }
  FolderForAWhile(const FolderForAWhile&) = delete;
  FolderForAWhile& operator=(const FolderForAWhile&) = delete;
  ~FolderForAWhile() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

FeaturePeer ask_ipctk(const std::vector<VertexFace>& vertex_faces, const std::vector<EdgeEdge>& edge_edges,
                      int rounds) {
  const char* given = std::getenv("TOCCATA_PYTHON");
  const std::string python = given == nullptr ? "python3" : given;
  if (run_program({python, "-c", "import importlib.util as u; exit(u.find_spec('ipctk') is None)"}).exit_code != 0)
    return {
        {}, fmt::format("{} has no package ipctk: install it there, or name another with TOCCATA_PYTHON", python), {}};
  const FolderForAWhile folder;
  const fs::path questions = folder.path() / "questions.txt", answers = folder.path() / "answers.json";
  write_questions(questions, vertex_faces, edge_edges);
  const ProcessRun run = run_program({python, TOCCATA_BENCH_SCRIPTS "/ipctk_features.py", questions.string(),
                                      answers.string(), std::to_string(rounds)});
  if (run.exit_code != 0) return {{}, fmt::format("{} could not ask ipctk (exit code {})", python, run.exit_code), {}};
  return peer_of(answers);
}

}  // namespace toccata::bench
