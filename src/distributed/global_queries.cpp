#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <tuple>
#include <type_traits>

#include <fmt/format.h>

#include "core/require_length.hpp"
#include "distributed/distributed_state.hpp"
#include "math/constants.hpp"
#include "query/keep_least.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

Body as_body(const SceneInstance& shape) { return {.model = shape.model, .pose = shape.pose, .solid = shape.solid}; }

Aabb box_of(const SceneInstance& shape) {
  return body_box(as_body(shape), shape.pose, [] { return std::string("the shape"); });
}

/// Around the box and where it comes to be, rounded outward.
Aabb box_on_the_way(const Aabb& box, const Vec3& motion) {
  Aabb way = box;
  for (int axis = 0; axis < 3; ++axis) {
    way.lower[axis] = std::min(box.lower[axis], std::nextafter(box.lower[axis] + motion[axis], -infinity));
    way.upper[axis] = std::max(box.upper[axis], std::nextafter(box.upper[axis] + motion[axis], infinity));
  }
  return way;
}

/// No point of one is nearer to one of the other than this.
double least_gap(const Aabb& a, const Aabb& b) {
  std::array<double, 3> gap{};
  for (int axis = 0; axis < 3; ++axis)
    gap[static_cast<std::size_t>(axis)] = std::max({0., a.lower[axis] - b.upper[axis], b.lower[axis] - a.upper[axis]});
  return std::hypot(gap[0], gap[1], gap[2]) * (1 - 0x1p-30);
}

struct NearestBodies {
  SceneInstance shape;
  std::uint64_t count = 0;
  double max_distance = infinity;
};

using NearBodies = std::vector<GlobalAnswer<Distance>>;

/// Ascending, and no more than wanted.
void keep_nearest(NearBodies& nearest, const GlobalAnswer<Distance>& other, std::size_t count) {
  const auto key = [](const GlobalAnswer<Distance>& one) { return std::tie(one.upper, one.body); };
  nearest.insert(std::ranges::upper_bound(nearest, key(other), {}, key), other);
  if (nearest.size() > count) nearest.pop_back();
}

/// How far off another may be that is among them.
double farthest_of_interest(const NearBodies& nearest, std::size_t count, double max_distance) {
  return nearest.size() < count ? max_distance : std::min(max_distance, nearest.back().upper);
}

/// What is still to be asked, with that answer.
template <class Question, class Answer>
const Question& narrowed(const Question& question, const Answer&) {
  return question;
}
NearestBodies narrowed(NearestBodies question, const NearBodies& nearest) {
  question.max_distance = farthest_of_interest(nearest, question.count, question.max_distance);
  return question;
}

template <class Found>
using FirstOf = std::optional<GlobalAnswer<Found>>;

/// The first of two answers, by (upper, id).
template <class Found>
void keep_first_of(FirstOf<Found>& first, const FirstOf<Found>& other) {
  const auto rank = [](const GlobalAnswer<Found>& answer) { return std::tie(answer.upper, answer.body); };
  if (other) keep_least(first, *other, rank);
}

void merge_ids(std::vector<GlobalId>& ids, const std::vector<GlobalId>& others) {
  ids.insert(ids.end(), others.begin(), others.end());
  std::sort(ids.begin(), ids.end());
}

void put_question(MessageWriter& letter, const Ray& ray) { letter.put(ray); }
void put_question(MessageWriter& letter, const SceneInstance& shape) {
  put_shape(letter, shape.model.shape());
  letter.put(shape.pose);
  letter.put(shape.solid);
}
void put_question(MessageWriter& letter, const NearestBodies& question) {
  put_question(letter, question.shape);
  letter.put(question.count);
  letter.put(question.max_distance);
}
void put_question(MessageWriter& letter, const MovingShape& moving) {
  put_question(letter, moving.shape);
  letter.put(moving.motion);
}

template <class Question>
Question get_question(MessageReader& reader) {
  if constexpr (std::is_same_v<Question, Ray>) {
    return reader.get<Ray>();
  } else if constexpr (std::is_same_v<Question, MovingShape>) {
    SceneInstance shape = get_question<SceneInstance>(reader);
    return {std::move(shape), reader.get<Vec3>()};
  } else if constexpr (std::is_same_v<Question, NearestBodies>) {
    SceneInstance shape = get_question<SceneInstance>(reader);
    const auto count = reader.get<std::uint64_t>();
    return {std::move(shape), count, reader.get<double>()};
  } else {
    SceneInstance shape{Model(get_shape(reader))};
    shape.pose = reader.get<Pose>();
    shape.solid = reader.get<Solid>();
    return shape;
  }
}

template <class Found>
void put_answer(MessageWriter& letter, const FirstOf<Found>& answer) {
  letter.put(answer.has_value());
  if (answer) letter.put(*answer);
}
void put_answer(MessageWriter& letter, const std::vector<GlobalId>& ids) {
  letter.put_all(std::span<const GlobalId>(ids));
}

void put_answer(MessageWriter& letter, const NearBodies& nearest) {
  letter.put_all(std::span<const GlobalAnswer<Distance>>(nearest));
}

template <class Found>
void get_answer(MessageReader& reader, FirstOf<Found>& answer) {
  if (reader.get<bool>()) answer = reader.get<GlobalAnswer<Found>>();
}
void get_answer(MessageReader& reader, std::vector<GlobalId>& ids) { ids = reader.get_all<GlobalId>(); }
void get_answer(MessageReader& reader, NearBodies& nearest) { nearest = reader.get_all<GlobalAnswer<Distance>>(); }

template <class Question>
constexpr const char* noun_of = std::is_same_v<Question, Ray> ? "ray" : "shape";

}  // namespace

template <class Answer, class Question, class MayKnow, class AnswerOne, class Merge>
std::vector<Answer> DistributedWorld::State::ask_ranks(std::span<const Question> questions, const MayKnow& may_know,
                                                       const AnswerOne& answer, const Merge& merge) {
  ranks_.all_do([&] {
    require_whole();
    queries_.update();
    return false;
  });
  const std::vector<Aabb> boxes = boxes_of_ranks();
  std::vector<Answer> answers(questions.size());
  Letters letters;
  ranks_.all_do([&] {
    for (std::size_t i = 0; i < questions.size(); ++i) try {
        answers[i] = answer(questions[i]);
        for (int to = 0; to < ranks_.count(); ++to) {
          const Aabb& box = boxes[static_cast<std::size_t>(to)];
          if (to == ranks_.rank() || is_empty(box) || !may_know(questions[i], box, answers[i])) continue;
          letters[to].put(std::uint64_t{i});
          put_question(letters[to], narrowed(questions[i], answers[i]));
        }
      } catch (const Error& error) {
        throw Error(fmt::format("{} {}: {}", noun_of<Question>, i, error.what()));
      }
    return false;
  });
  const std::vector<Received> asked = ranks_.exchange(letters);
  Letters replies;
  ranks_.all_do([&] {
    for (const Received& received : asked)
      for (MessageReader reader(received.bytes); !reader.is_at_end();) {
        const auto number = reader.get<std::uint64_t>();
        replies[received.from].put(number);
        try {
          put_answer(replies[received.from], answer(get_question<Question>(reader)));
        } catch (const Error& error) {
          throw Error(fmt::format("{} {} of rank {}: {}", noun_of<Question>, number, received.from, error.what()));
        }
      }
    return false;
  });
  for (const Received& received : ranks_.exchange(replies))
    for (MessageReader reader(received.bytes); !reader.is_at_end();) {
      const auto number = reader.get<std::uint64_t>();
      Answer other{};
      get_answer(reader, other);
      merge(answers[number], other);
    }
  return answers;
}

std::vector<Aabb> DistributedWorld::State::boxes_of_ranks() {
  if (!box_of_here_) {
    box_of_here_ = Aabb{};
    for (const auto& [id, local] : local_)
      if (copy(local).lives_here) box_of_here_ = merge(*box_of_here_, world_.box(local));
  }
  const Aabb& own = *box_of_here_;
  std::vector<double> ends(6 * static_cast<std::size_t>(ranks_.count()), infinity);
  for (int axis = 0; axis < 3; ++axis) {
    double* end = &ends[6 * static_cast<std::size_t>(ranks_.rank()) + 2 * static_cast<std::size_t>(axis)];
    end[0] = own.lower[axis];
    end[1] = -own.upper[axis];
  }
  ranks_.find_least(ends);
  std::vector<Aabb> boxes(static_cast<std::size_t>(ranks_.count()));
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    for (int axis = 0; axis < 3; ++axis) {
      boxes[rank].lower[axis] = ends[6 * rank + 2 * static_cast<std::size_t>(axis)];
      boxes[rank].upper[axis] = -ends[6 * rank + 2 * static_cast<std::size_t>(axis) + 1];
    }
  return boxes;
}

template <class Found, class Ask>
std::optional<GlobalAnswer<Found>> DistributedWorld::State::first_here(const Ask& ask) const {
  FirstOf<Found> first;
  BodyFilter filter;
  // The World has told the one of least index; one of lesser id may be as near.
  filter.accepts = [&](BodyId local) { return copy(local).lives_here && (!first || copy(local).id < first->body); };
  for (;;) {
    const std::optional<BodyAnswer<Found>> found = ask(filter, first ? first->upper : infinity);
    if (!found) return first;
    const FirstOf<Found> other = GlobalAnswer<Found>{static_cast<const Found&>(*found), copy(found->body).id};
    const bool is_first = !first || found->upper <= first->upper;
    keep_first_of(first, other);
    if (!is_first) return first;
  }
}

std::vector<std::optional<GlobalAnswer<RayHit>>> DistributedWorld::State::cast_ray_each(std::span<const Ray> rays) {
  using Answer = FirstOf<RayHit>;
  return ask_ranks<Answer>(
      rays,
      [](const Ray& ray, const Aabb& box, const Answer&) {
        return overlap(box, box_on_the_way({ray.origin, ray.origin}, ray.motion));
      },
      [&](const Ray& ray) {
        return first_here<RayHit>([&](const BodyFilter& filter, double) { return queries_.cast_ray(ray, filter); });
      },
      keep_first_of<RayHit>);
}

std::vector<std::optional<GlobalAnswer<ShapeHit>>> DistributedWorld::State::cast_shape_each(
    std::span<const MovingShape> moving) {
  using Answer = FirstOf<ShapeHit>;
  return ask_ranks<Answer>(
      moving,
      [](const MovingShape& one, const Aabb& box, const Answer&) {
        return overlap(box, box_on_the_way(box_of(one.shape), one.motion));
      },
      [&](const MovingShape& one) {
        return first_here<ShapeHit>([&](const BodyFilter& filter, double) { return queries_.cast_shape(one, filter); });
      },
      keep_first_of<ShapeHit>);
}

std::vector<std::vector<GlobalId>> DistributedWorld::State::within_each(std::span<const SceneInstance> shapes,
                                                                        double max_distance) {
  BodyFilter of_here;
  of_here.accepts = [&](BodyId local) { return copy(local).lives_here; };
  return ask_ranks<std::vector<GlobalId>>(
      shapes,
      [&](const SceneInstance& shape, const Aabb& box, const std::vector<GlobalId>&) {
        return least_gap(box_of(shape), box) <= max_distance;
      },
      [&](const SceneInstance& shape) {
        std::vector<GlobalId> ids;
        for (const BodyId local : queries_.within(shape, max_distance, of_here)) ids.push_back(copy(local).id);
        std::sort(ids.begin(), ids.end());
        return ids;
      },
      merge_ids);
}

std::vector<std::optional<GlobalAnswer<Distance>>> DistributedWorld::State::nearest_each(
    std::span<const SceneInstance> shapes, double max_distance) {
  using Answer = FirstOf<Distance>;
  return ask_ranks<Answer>(
      shapes,
      [&](const SceneInstance& shape, const Aabb& box, const Answer& known) {
        const double limit = known ? std::min(max_distance, known->upper) : max_distance;
        return least_gap(box_of(shape), box) <= limit;
      },
      [&](const SceneInstance& shape) {
        return first_here<Distance>([&](const BodyFilter& filter, double upper) {
          return queries_.nearest(shape, std::min(upper, max_distance), filter);
        });
      },
      keep_first_of<Distance>);
}

std::vector<GlobalAnswer<Distance>> DistributedWorld::State::nearest_here(const SceneInstance& shape, std::size_t count,
                                                                          double max_distance) const {
  NearBodies nearest;
  const Aabb box = box_of(shape);
  if (count == 0 || is_empty(box)) return nearest;
  Workspace workspace;
  queries_.boxes().visit_nearest(box, max_distance, [&](Index object) {
    const double limit = farthest_of_interest(nearest, count, max_distance);
    const std::optional<BodyId> local = world_.body_at(object);
    if (!local || !copy(*local).lives_here) return limit;
    const GlobalId id = copy(*local).id;
    const Body& body = world_.body(*local);
    workspace.scratch().convex = {};  // it was another pair's
    try {
      const PairQuery query{shape.pose, body.pose, shape.solid, body.solid};
      if (const auto found = distance_within(shape.model, body.model, limit, query, workspace))
        keep_nearest(nearest, {*found, id}, count);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", name_of_body(id), error.what()));
    }
    return farthest_of_interest(nearest, count, max_distance);
  });
  return nearest;
}

std::vector<std::vector<GlobalAnswer<Distance>>> DistributedWorld::State::nearest_bodies_each(
    std::span<const SceneInstance> shapes, std::size_t k, double max_distance) {
  std::vector<NearestBodies> questions;
  for (const SceneInstance& shape : shapes) questions.push_back({shape, k, max_distance});
  return ask_ranks<NearBodies>(
      std::span<const NearestBodies>(questions),
      [](const NearestBodies& one, const Aabb& box, const NearBodies& known) {
        return one.count > 0 &&
               least_gap(box_of(one.shape), box) <= farthest_of_interest(known, one.count, one.max_distance);
      },
      [&](const NearestBodies& one) {
        require_length(one.max_distance, "the greatest distance");
        return nearest_here(one.shape, one.count, one.max_distance);
      },
      [&](NearBodies& nearest, const NearBodies& others) {
        for (const GlobalAnswer<Distance>& other : others) keep_nearest(nearest, other, k);
      });
}

}  // namespace toccata
