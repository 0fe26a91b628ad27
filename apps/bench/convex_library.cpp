#include "convex_library.hpp"

#include <iterator>
#include <map>

namespace toccata::bench {
namespace {

using ConvexMaker = ConvexOffer (*)(const ConvexWork&);

const std::map<std::string, ConvexMaker>& convex_makers() {
  static const std::map<std::string, ConvexMaker> all{{"dops", toccata_dops},       {"fcl", fcl_convex},
                                                      {"bullet", bullet_convex},    {"ode", ode_convex},
                                                      {"tracked", toccata_tracked}, {"ways", toccata_ways}};
  return all;
}

void append(ConvexOffer more, ConvexOffer& offer) {
  std::move(more.libraries.begin(), more.libraries.end(), std::back_inserter(offer.libraries));
  std::move(more.unasked.begin(), more.unasked.end(), std::back_inserter(offer.unasked));
}

}  // namespace

std::vector<std::string> convex_pairs() {
  return {"hull",           "box",          "sphere",        "sphere-box",    "sphere-triangle",
          "sphere-capsule", "capsule",      "capsule-box",   "cylinder-box",  "cone-box",
          "ellipsoid",      "sphere-6-dop", "sphere-14-dop", "sphere-18-dop", "sphere-26-dop"};
}

bool has_quadric(const std::string& pair) {
  return pair == "cylinder-box" || pair == "cone-box" || pair == "ellipsoid";
}

std::vector<std::string> convex_peers() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : convex_makers()) names.push_back(name);
  return names;
}

ConvexOffer convex_libraries(const std::vector<std::string>& peers, const ConvexWork& work) {
  ConvexOffer offer = toccata_convex(work);
  for (const std::string& name : peers) append(convex_makers().at(name)(work), offer);
  return offer;
}

}  // namespace toccata::bench
