#include "query/contacts/cut_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// Less than that share of a length is rounding, and of an area of no account.
constexpr double least_share_of_size = 0x1p-36, least_share_of_area = 0x1p-48;

double squared_size(const Vec3& v) { return dot(v, v); }

/// Whether a point lies over a convex polygon in its plane, seen against the normal.
bool is_over(const Vec3& p, std::span<const Vec3> outline, const Vec3& normal) {
  bool is_left = false, is_right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3& from = outline[i];
    const double side = dot(normal, cross(outline[(i + 1) % outline.size()] - from, p - from));
    is_left = is_left || side > 0;
    is_right = is_right || side < 0;
  }
  return !is_left || !is_right;
}

/// A polygon and what may cut it.
struct UncutPart {
  std::vector<Vec3> points;
  std::vector<int> corners;
  std::vector<ContactSegment> segments;
  std::vector<const FaceOnTriangle*> faces;
  std::vector<ContactSegment> beside;  ///< segments that are near, and do not cut it
};

/// A line in the triangle's plane: the points of height 0.
struct CutLine {
  Vec3 through;
  Vec3 across;

  [[nodiscard]] double height(const Vec3& p) const { return dot(across, p - through); }
};

struct HeightsOfPart {
  double low = 0;
  double high = 0;
  [[nodiscard]] double slack() const { return least_share_of_size * (high - low); }
};

HeightsOfPart heights_over(const CutLine& line, std::span<const Vec3> points) {
  HeightsOfPart heights{line.height(points[0]), line.height(points[0])};
  for (const Vec3& p : points) {
    heights.low = std::min(heights.low, line.height(p));
    heights.high = std::max(heights.high, line.height(p));
  }
  return heights;
}

struct TwoParts {
  UncutPart below;
  UncutPart above;
};

void cut_outline(const UncutPart& whole, const CutLine& line, TwoParts& parts) {
  const auto put = [](UncutPart& part, const Vec3& p, int corner) {
    part.points.push_back(p);
    part.corners.push_back(corner);
  };
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    const std::size_t j = (i + 1) % whole.points.size();
    const double here = line.height(whole.points[i]), next = line.height(whole.points[j]);
    if (here <= 0) put(parts.below, whole.points[i], whole.corners[i]);
    if (here >= 0) put(parts.above, whole.points[i], whole.corners[i]);
    if (!(here < 0 && next > 0) && !(here > 0 && next < 0)) continue;
    const Vec3 at = whole.points[i] + (here / (here - next)) * (whole.points[j] - whole.points[i]);
    put(parts.below, at, -1);
    put(parts.above, at, -1);
  }
}

/// What lies along the line cuts neither.
void share_segment(const ContactSegment& segment, const CutLine& line, double slack, TwoParts& parts) {
  const double from = line.height(segment.from), to = line.height(segment.to);
  const bool goes_below = std::min(from, to)<-slack, goes_above = std::max(from, to)> slack;
  if (goes_below && goes_above) {
    const Vec3 at = segment.from + (from / (from - to)) * (segment.to - segment.from);
    const ContactSegment first{segment.from, at, segment.contact}, second{at, segment.to, segment.contact};
    parts.below.segments.push_back(from < 0 ? first : second);
    parts.above.segments.push_back(from < 0 ? second : first);
    return;
  }
  if (goes_below || !goes_above) (goes_below ? parts.below.segments : parts.below.beside).push_back(segment);
  if (goes_above || !goes_below) (goes_above ? parts.above.segments : parts.above.beside).push_back(segment);
}

TwoParts cut_along(const UncutPart& whole, const CutLine& line, double slack) {
  TwoParts parts;
  cut_outline(whole, line, parts);
  parts.below.beside = parts.above.beside = whole.beside;
  for (const ContactSegment& segment : whole.segments) share_segment(segment, line, slack, parts);
  for (const FaceOnTriangle* face : whole.faces) {
    const HeightsOfPart heights = heights_over(line, face->outline);
    if (heights.low < -slack) parts.below.faces.push_back(face);
    if (heights.high > slack) parts.above.faces.push_back(face);
  }
  for (UncutPart* part : {&parts.below, &parts.above})
    if (part->segments.empty() && part->beside.empty()) part->beside = whole.segments;
  return parts;
}

class TriangleCut {
 public:
  TriangleCut(const Triangle& triangle, const Vec3& twice)
      : normal_(unit_or_zero(twice)), least_(least_share_of_area * largest_magnitude(twice)) {
    axes_[0] = unit_or_zero(triangle[1] - triangle[0]);
    axes_[1] = cross(normal_, axes_[0]);
  }

  [[nodiscard]] std::vector<TrianglePart> parts_of(UncutPart whole) {
    waiting_.push_back(std::move(whole));
    while (!waiting_.empty()) {
      UncutPart part = std::move(waiting_.back());
      waiting_.pop_back();
      if (!(largest_magnitude(twice_area_of(part.points)) > least_)) continue;
      if (!cut_by_half(part) && !cut_by_segment(part)) add(part);
    }
    return std::move(parts_);
  }

 private:
  /// While there are many segments.
  [[nodiscard]] bool cut_by_half(const UncutPart& part) {
    constexpr std::size_t few = 8;
    if (part.segments.size() <= few) return false;
    for (const Vec3& across : axes_) {
      std::vector<double> heights;
      for (const ContactSegment& segment : part.segments) heights.push_back(dot(across, segment.from + segment.to) / 2);
      const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
      std::nth_element(heights.begin(), middle, heights.end());
      const CutLine line{*middle * across, across};
      const HeightsOfPart over = heights_over(line, part.points);
      if (over.low >= -over.slack() || over.high <= over.slack()) continue;
      TwoParts parts = cut_along(part, line, over.slack());
      const std::size_t most = part.segments.size() * 3 / 4;
      if (parts.below.segments.size() > most || parts.above.segments.size() > most) continue;
      wait(std::move(parts));
      return true;
    }
    return false;
  }

  [[nodiscard]] bool cut_by_segment(UncutPart& part) {
    while (!part.segments.empty()) {
      const ContactSegment pivot = part.segments.back();
      part.segments.pop_back();
      part.beside.push_back(pivot);
      const Vec3 across = unit_or_zero(cross(normal_, pivot.to - pivot.from));
      const CutLine line{pivot.from, across};
      const HeightsOfPart over = heights_over(line, part.points);
      if (over.low >= -over.slack() || over.high <= over.slack()) continue;  // along its border
      wait(cut_along(part, line, over.slack()));
      return true;
    }
    return false;
  }

  void wait(TwoParts parts) {
    waiting_.push_back(std::move(parts.below));
    waiting_.push_back(std::move(parts.above));
  }

  void add(UncutPart& part) {
    const Vec3 middle = middle_of(part.points);
    const auto away = [&](const ContactSegment& s) { return squared_size(0.5 * s.from + 0.5 * s.to - middle); };
    const auto nearest =
        std::min_element(part.beside.begin(), part.beside.end(),
                         [&](const ContactSegment& s, const ContactSegment& t) { return away(s) < away(t); });
    const auto face = std::find_if(part.faces.begin(), part.faces.end(),
                                   [&](const FaceOnTriangle* one) { return is_over(middle, one->outline, normal_); });
    parts_.push_back({std::move(part.points), std::move(part.corners), nearest->contact,
                      face == part.faces.end() ? nullptr : *face});
  }

  Vec3 normal_;
  std::array<Vec3, 2> axes_;
  double least_;
  std::vector<UncutPart> waiting_;
  std::vector<TrianglePart> parts_;
};

}  // namespace

Vec3 twice_area_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (std::size_t i = 2; i < points.size(); ++i) sum = sum + cross(points[i - 1] - points[0], points[i] - points[0]);
  return sum;
}

Vec3 middle_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + (1.0 / static_cast<double>(points.size())) * p;
  return sum;
}

std::vector<TrianglePart> cut_triangle(const Triangle& triangle, std::vector<ContactSegment> segments,
                                       std::span<const FaceOnTriangle> faces) {
  const Vec3 twice = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  UncutPart whole{{triangle[0], triangle[1], triangle[2]}, {0, 1, 2}, std::move(segments), {}, {}};
  for (const FaceOnTriangle& face : faces) whole.faces.push_back(&face);
  return TriangleCut(triangle, twice).parts_of(std::move(whole));
}

}  // namespace toccata
