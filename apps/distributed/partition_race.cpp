#include "partition_race.hpp"

#include <mpi.h>
#ifdef TOCCATA_WITH_ZOLTAN
#include <zoltan.h>
#endif

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include "distributed/ranks.hpp"
#include "distributed/space_of_ranks.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The boxes that this rank gives, and where their middles are.
struct OwnBoxes {
  std::vector<Aabb> boxes;
  std::vector<Vec3> places;
};

OwnBoxes own_boxes(std::span<const Aabb> boxes, const Ranks& ranks) {
  OwnBoxes own;
  for (auto i = static_cast<std::size_t>(ranks.rank()); i < boxes.size();
       i += static_cast<std::size_t>(ranks.count())) {
    own.boxes.push_back(boxes[i]);
    own.places.push_back(place_of(boxes[i]));
  }
  return own;
}

class Stopwatch {
 public:
  /// The longest time of all ranks.
  double seconds(Ranks& ranks) const {
    const std::chrono::duration<double> own = std::chrono::steady_clock::now() - begin_;
    double longest = -own.count();
    ranks.find_least({&longest, 1});
    return -longest;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// `home(i)` is the part that box i of this rank is in, `parts(i)` all that it reaches.
PartitionQuality quality_of(const std::string& name, double seconds, const OwnBoxes& own, Ranks& ranks,
                            const std::function<int(std::size_t)>& home,
                            const std::function<std::vector<int>(std::size_t)>& parts) {
  const auto count = static_cast<std::size_t>(ranks.count());
  std::vector<std::uint64_t> numbers(2 * count);  // boxes, then ghosts
  for (std::size_t i = 0; i < own.boxes.size(); ++i) {
    const int at_home = home(i);
    ++numbers[static_cast<std::size_t>(at_home)];
    for (const int part : parts(i))
      if (part != at_home) ++numbers[count + static_cast<std::size_t>(part)];
  }
  ranks.add_up(numbers);
  const auto sum_and_most = [&](std::size_t first) {
    double sum = 0, most = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      sum += static_cast<double>(numbers[i]);
      most = std::max(most, static_cast<double>(numbers[i]));
    }
    return std::pair(sum, most);
  };
  const auto [boxes, fullest] = sum_and_most(0);
  const auto [ghosts, most_ghosts] = sum_and_most(count);
  const double average = std::max(boxes, 1.0) / static_cast<double>(count);
  return {name, seconds, fullest / average, ghosts / std::max(boxes, 1.0), most_ghosts / average};
}

PartitionQuality quality_of_planes(const OwnBoxes& own, Ranks& ranks) {
  const std::vector<std::uint64_t> costs(own.places.size(), 1);
  const Stopwatch watch;
  const SpaceOfRanks space = ranks.count() > 1 ? SpaceOfRanks(ranks, own.places, costs) : SpaceOfRanks(1);
  const double seconds = watch.seconds(ranks);
  return quality_of(
      "planes", seconds, own, ranks, [&](std::size_t i) { return space.part_of(own.places[i]); },
      [&](std::size_t i) {
        std::vector<int> parts;
        space.visit_parts_meeting(own.boxes[i], [&](int part) { parts.push_back(part); });
        return parts;
      });
}

#ifdef TOCCATA_WITH_ZOLTAN
int count_of(void* own, int* trouble) {
  *trouble = ZOLTAN_OK;
  return static_cast<int>(static_cast<const OwnBoxes*>(own)->places.size());
}
void list_of(void* own, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float*, int* trouble) {
  *trouble = ZOLTAN_OK;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  for (std::size_t i = 0; i < static_cast<const OwnBoxes*>(own)->places.size(); ++i) {
    local[i] = static_cast<ZOLTAN_ID_TYPE>(i);
    global[i] = static_cast<ZOLTAN_ID_TYPE>(i * static_cast<std::size_t>(ranks) + static_cast<std::size_t>(rank));
  }
}
int dimensions(void*, int* trouble) {
  *trouble = ZOLTAN_OK;
  return 3;
}
void places_of(void* own, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* places, int* trouble) {
  *trouble = ZOLTAN_OK;
  for (int i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis)
      places[3 * i + axis] = static_cast<const OwnBoxes*>(own)->places[local[i]][axis];
}

struct EndZoltan {
  void operator()(Zoltan_Struct* zoltan) const { Zoltan_Destroy(&zoltan); }
};

PartitionQuality quality_of_zoltan(OwnBoxes& own, Ranks& ranks, const std::string& name, const char* method) {
  const std::unique_ptr<Zoltan_Struct, EndZoltan> zoltan(Zoltan_Create(MPI_COMM_WORLD));
  for (const auto& [key, value] :
       {std::pair("DEBUG_LEVEL", "0"), std::pair("LB_METHOD", method), std::pair("KEEP_CUTS", "1"),
        std::pair("RETURN_LISTS", "NONE"), std::pair("IMBALANCE_TOL", "1.01")})
    Zoltan_Set_Param(zoltan.get(), key, value);
  Zoltan_Set_Num_Obj_Fn(zoltan.get(), count_of, &own);
  Zoltan_Set_Obj_List_Fn(zoltan.get(), list_of, &own);
  Zoltan_Set_Num_Geom_Fn(zoltan.get(), dimensions, &own);
  Zoltan_Set_Geom_Multi_Fn(zoltan.get(), places_of, &own);
  int changes = 0, of_global = 0, of_local = 0, come = 0, go = 0;
  ZOLTAN_ID_PTR come_global = nullptr, come_local = nullptr, go_global = nullptr, go_local = nullptr;
  int *come_from = nullptr, *come_to = nullptr, *go_from = nullptr, *go_to = nullptr;
  const Stopwatch watch;
  if (Zoltan_LB_Partition(zoltan.get(), &changes, &of_global, &of_local, &come, &come_global, &come_local, &come_from,
                          &come_to, &go, &go_global, &go_local, &go_from, &go_to) != ZOLTAN_OK)
    throw Error("Zoltan did not divide the boxes");
  const double seconds = watch.seconds(ranks);
  std::vector<int> procs(static_cast<std::size_t>(ranks.count())), parts(procs.size());
  return quality_of(
      name, seconds, own, ranks,
      [&](std::size_t i) {
        double place[3] = {own.places[i].x, own.places[i].y, own.places[i].z};
        int proc = 0, part = 0;
        Zoltan_LB_Point_PP_Assign(zoltan.get(), place, &proc, &part);
        return part;
      },
      [&](std::size_t i) {
        const auto& [low, high] = own.boxes[i];
        int proc_count = 0, part_count = 0;
        Zoltan_LB_Box_PP_Assign(zoltan.get(), low.x, low.y, low.z, high.x, high.y, high.z, procs.data(), &proc_count,
                                parts.data(), &part_count);
        return std::vector<int>(parts.begin(), parts.begin() + part_count);
      });
}
#endif

}  // namespace

std::vector<PartitionQuality> partition_qualities(std::span<const Aabb> boxes) {
  Ranks ranks(MPI_Comm_c2f(MPI_COMM_WORLD), 1800);
  OwnBoxes own = own_boxes(boxes, ranks);
  std::vector<PartitionQuality> qualities{quality_of_planes(own, ranks)};
#ifdef TOCCATA_WITH_ZOLTAN
  float version = 0;
  Zoltan_Initialize(0, nullptr, &version);
  qualities.push_back(quality_of_zoltan(own, ranks, "Zoltan RCB", "RCB"));
  qualities.push_back(quality_of_zoltan(own, ranks, "Hilbert curve", "HSFC"));
#endif
  return qualities;
}

}  // namespace toccata
