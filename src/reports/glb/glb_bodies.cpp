#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>

#include "query/scenes/task_reporter.hpp"
#include "query/volume/overlap_bodies.hpp"
#include "query/workspace_pool.hpp"
#include "reports/glb/glb_scene.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace io {
namespace {

const GlbPaint body_paint{"overlap bodies", 0xd55e00};

/// A body as a GLB file has it.
struct RoundedBody {
  GlbFrame frame;
  std::vector<GlbPart> pieces;
  double volume = 0;    ///< of what is written
  double rounding = 0;  ///< the farthest that a coordinate was moved
};

std::vector<Vec3> corners_of(const TriangleMesh& mesh) {
  std::vector<Vec3> corners;
  for (const auto& t : mesh.triangles())
    for (const Index corner : t) corners.push_back(mesh.vertices()[corner]);
  return corners;
}

/// Seen from the origin of the frame.
Vec3 back_from(const GlbFrame& frame, const std::array<float, 3>& counted) {
  const auto coordinate = [&](std::size_t axis) {
    return std::ldexp(static_cast<double>(counted[axis]), frame.exponent);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// Triangles whose corners the floats make one are left out: what is around them stays closed.
GlbPart rounded_piece(std::span<const Vec3> corners, RoundedBody& body) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::array<std::array<float, 3>, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = body.frame.counted(corners[i + k]);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    const std::array<Vec3, 3> back{back_from(body.frame, t[0]), back_from(body.frame, t[1]),
                                   back_from(body.frame, t[2])};
    body.volume += dot(back[0], cross(back[1], back[2])) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      kept.push_back(corners[i + k]);
      const Vec3 off = corners[i + k] - (body.frame.origin + back[k]);
      body.rounding = std::max({body.rounding, std::abs(off.x), std::abs(off.y), std::abs(off.z)});
    }
  }
  return joined_part(kept, body.frame);
}

RoundedBody rounded_body(const OverlapBodies& bodies) {
  std::vector<Vec3> all;
  for (const TriangleMesh& piece : bodies.pieces) {
    const std::vector<Vec3> corners = corners_of(piece);
    all.insert(all.end(), corners.begin(), corners.end());
  }
  RoundedBody body;
  body.frame = GlbFrame::around(all);
  for (const TriangleMesh& piece : bodies.pieces) {
    GlbPart part = rounded_piece(corners_of(piece), body);
    if (!part.corners.empty()) body.pieces.push_back(std::move(part));
  }
  return body;
}

/// What is written of a pair: a body, or why there is none.
struct PairBody {
  RoundedBody body;
  OverlapVolume volume;         ///< of all that the two have in common
  bool are_within = false;      ///< the pieces are polyhedra within what is common
  bool pieces_overlap = false;  ///< or may
  std::string missing;
  bool was_stopped = false;
};

PairBody body_of(std::span<const SceneInstance> models, const ReportedPair& pair, Workspace& workspace) {
  const SceneInstance &a = models[pair.a], &b = models[pair.b];
  PairBody result;
  const OverlapBodies bodies = overlap_bodies(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace);
  result.missing = bodies.missing;
  if (!result.missing.empty()) return result;
  result.body = rounded_body(bodies);
  if (!(result.body.volume > 0)) {
    result.missing = "it is thinner than the floats of a GLB file tell apart";
    return result;
  }
  result.volume = bodies.volume;
  result.are_within = bodies.are_within;
  result.pieces_overlap = bodies.may_overlap;
  return result;
}

PairBody stopped_body() {
  PairBody none;
  none.missing = "the check was stopped before it was made";
  none.was_stopped = true;
  return none;
}

/// The places of the pairs that have a common inside, or may.
std::vector<std::size_t> overlapping_pairs(const CheckReport& report) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < report.pairs.size(); ++i)
    if (const RelationKind kind = report.pairs[i].relation.kind;
        kind == RelationKind::overlapping || kind == RelationKind::crossing)
      places.push_back(i);
  return places;
}

std::size_t add_body(GlbScene& glb, const ReportedPair& pair, const PairBody& made) {
  const std::string name = glb.name_of(pair.a) + " × " + glb.name_of(pair.b);
  Json extras = {{"a", glb.name_of(pair.a)}, {"b", glb.name_of(pair.b)}};
  if (pair.tolerance != ToleranceVerdict::none) extras["tolerance"] = name_of(pair.tolerance);
  if (!made.missing.empty()) {
    extras["left_out"] = made.missing;
    return glb.add_node(name, {}, {}, {{"extras", std::move(extras)}});
  }
  extras["volume"] = {{"lower", made.volume.lower}, {"upper", made.volume.upper}};
  extras["mesh_volume"] = made.body.volume;
  extras["rounding"] = made.body.rounding;
  if (made.are_within) extras["within"] = true;
  if (made.pieces_overlap) extras["pieces_may_overlap"] = true;
  Json parts = Json::array();
  for (const GlbPart& piece : made.body.pieces) parts.push_back(glb.part(piece, GlbMode::triangles, body_paint));
  const std::size_t mesh = glb.add_mesh(name, std::move(parts));
  return glb.add_node(name, {}, made.body.frame, {{"extras", std::move(extras)}, {"mesh", mesh}});
}

/// Where the bodies are.
DisplayFrame place_of(const CheckReport& report, std::span<const std::size_t> places) {
  Aabb all;
  for (const std::size_t place : places)
    if (const Aabb& box = report.pairs[place].place; is_finite(box.lower) && is_finite(box.upper))
      all = merge(all, box);
  return DisplayFrame::around(all);
}

/// Fills a file with bodies as they are made, on many threads, in the order of the pairs: what is made before its turn
/// waits, and nothing is kept longer.
class BodiesInTurn {
 public:
  BodiesInTurn(const CheckReport& report, std::span<const std::size_t> places, GlbScene& glb)
      : report_(report), places_(places), glb_(glb), waiting_(places.size()) {}

  void add(std::size_t i, PairBody body) {
    const std::lock_guard lock(mutex_);
    waiting_[i] = std::make_unique<PairBody>(std::move(body));
    for (; next_ < waiting_.size() && waiting_[next_]; ++next_) {
      write(places_[next_], *waiting_[next_]);
      waiting_[next_].reset();
    }
  }

  /// Once all are there.
  OverlapBodiesGlb done(const ViewOptions& view, const std::string& unit) {
    glb_.add_group("overlap bodies", with_body_);
    glb_.add_group("without a body", without_);
    if (report_.unfinished > 0) glb_.add_stopped(report_.unfinished);
    auto [writer, root] = std::move(glb_).take(view, unit);
    result_.bodies = with_body_.size();
    result_.write = [file = std::make_shared<const GlbWriter>(std::move(writer)),
                     top = root](const std::filesystem::path& path) {
      require_output(path, OutputKind::glb);
      file->write(top, path);
    };
    return std::move(result_);
  }

 private:
  void write(std::size_t place, const PairBody& body) {
    const std::size_t node = add_body(glb_, report_.pairs[place], body);
    (body.missing.empty() ? with_body_ : without_).push_back(node);
    if (!body.missing.empty()) result_.left_out.emplace_back(place, body.missing);
    result_.stopped += body.was_stopped ? 1 : 0;
  }

  const CheckReport& report_;
  std::span<const std::size_t> places_;
  GlbScene& glb_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PairBody>> waiting_;
  std::size_t next_ = 0;
  std::vector<std::size_t> with_body_, without_;
  OverlapBodiesGlb result_;
};

void make_bodies(std::span<const SceneInstance> models, const CheckReport& report, std::span<const std::size_t> places,
                 const AskOptions& options, BodiesInTurn& bodies) {
  WorkspacePool workspaces;
  TaskReporter reporter(options.progress, places.size());
  // One after the other is begun, whichever thread is free, so that few wait for their turn.
  std::atomic<std::size_t> begun = 0;
  const auto make_next = [&] {
    const std::size_t i = begun++;
    if (i >= places.size()) return;
    const bool is_stopped = options.stop && options.stop();
    bodies.add(i, is_stopped ? stopped_body() : workspaces.with([&](Workspace& workspace) {
      return body_of(models, report.pairs[places[i]], workspace);
    }));
    reporter.finished_one();
  };
  parallel_for(places.size(), options.threads, [&](std::size_t) {
    try {
      make_next();
    } catch (...) {
      begun = places.size();  // nothing more
      throw;
    }
  });
}

}  // namespace
}  // namespace io

OverlapBodiesGlb overlap_bodies_glb(const Scene& scene, std::span<const SceneInstance> models,
                                    const CheckReport& report, const ViewOptions& view, const AskOptions& options,
                                    const std::filesystem::path& beside) {
  const std::vector<std::size_t> places = io::overlapping_pairs(report);
  io::GlbScene glb(models, io::place_of(report, places), beside.empty() ? io::GlbWriter{} : io::GlbWriter(beside));
  io::BodiesInTurn bodies(report, places, glb);
  io::make_bodies(models, report, places, options, bodies);
  return bodies.done(view, scene.unit);
}

}  // namespace toccata
