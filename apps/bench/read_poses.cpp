#include "toccata/io/poses_file.hpp"

#include "poses.hpp"

namespace toccata::bench {

std::vector<PosePair> read_poses(const std::filesystem::path& file) {
  std::vector<PosePair> poses;
  for (const PairQuery& query : toccata::read_poses(file)) poses.push_back({query.pose_a, query.pose_b});
  return poses;
}

}  // namespace toccata::bench
