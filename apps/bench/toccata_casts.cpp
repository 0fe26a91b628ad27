#include <fmt/format.h>

#include <iterator>
#include <map>

#include "casts.hpp"
#include "toccata/core/version.hpp"

namespace toccata::bench {
namespace {

using CastMaker = CastOffer (*)(const CastWork&);

const std::map<std::string, CastMaker>& cast_makers() {
  static const std::map<std::string, CastMaker> all{{"bullet", bullet_casts}, {"fcl", fcl_casts}, {"ode", ode_casts}};
  return all;
}

CastAnswer answer_of(const std::optional<Cast>& cast) {
  if (!cast) return {false, 0, 0, true};
  return {true, cast->lower, cast->upper, cast->status == Status::exact};
}

enum class CastPosing { for_each_question, before };

template <class Moving, class Standing>
class ToccataCasts : public CastLibrary {
 public:
  explicit ToccataCasts(CastPosing posing) : posing_(posing) {}

  Description description() const override {
    return {"toccata", posing_ == CastPosing::before ? "posed before" : "posed for each question", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const CastWork& work) override {
    work_ = &work;
    for (const CastPair& pair : work.pairs) {
      moving_.push_back(std::get<Moving>(pair.moving));
      standing_.push_back(std::get<Standing>(pair.standing));
    }
    if (posing_ == CastPosing::for_each_question) return;
    for (const CastQuestion& question : work.questions) {
      posed_moving_.emplace_back(moving_[question.pair], question.start);
      posed_standing_.emplace_back(standing_[question.pair], question.standing);
    }
  }

  void answer(std::size_t first, std::span<CastAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const CastQuestion& question = work_->questions[first + i];
      answers[i] = answer_of(posing_ == CastPosing::before
                                 ? of_posed(first + i, question)
                                 : cast_given(moving_[question.pair], standing_[question.pair], question));
    }
  }

 private:
  std::optional<Cast> of_posed(std::size_t number, const CastQuestion& question) const {
    if constexpr (std::is_same_v<Moving, Point>)
      return cast_ray(question.start.offset, question.motion, posed_standing_[number]);
    else
      return cast_shape(posed_moving_[number], question.motion, posed_standing_[number]);
  }

  CastPosing posing_;
  const CastWork* work_ = nullptr;
  std::vector<Moving> moving_;
  std::vector<Standing> standing_;
  std::vector<PosedAs<Moving>> posed_moving_;
  std::vector<PosedAs<Standing>> posed_standing_;
};

}  // namespace

std::vector<std::string> cast_pairs() {
  return {"ray-cylinder", "ray-cone", "ray-ellipsoid", "cylinder-box", "cone-box", "ellipsoid"};
}

std::vector<std::string> cast_peers() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : cast_makers()) names.push_back(name);
  return names;
}

CastOffer toccata_casts(const CastWork& work) {
  return with_cast_types(work.pair, []<class Moving, class Standing>() {
    CastOffer offer;
    for (const CastPosing posing : {CastPosing::for_each_question, CastPosing::before})
      offer.libraries.push_back(std::make_unique<ToccataCasts<Moving, Standing>>(posing));
    return offer;
  });
}

CastOffer cast_libraries(const std::vector<std::string>& peers, const CastWork& work) {
  CastOffer offer = toccata_casts(work);
  for (const std::string& name : peers) {
    CastOffer more = cast_makers().at(name)(work);
    std::move(more.libraries.begin(), more.libraries.end(), std::back_inserter(offer.libraries));
    std::move(more.unasked.begin(), more.unasked.end(), std::back_inserter(offer.unasked));
  }
  return offer;
}

}  // namespace toccata::bench
