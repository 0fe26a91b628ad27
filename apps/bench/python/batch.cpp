// What C++ takes for what measure_python.py asks in Python: `batch MESH.obj POSES COUNT` reads COUNT · 12 doubles (R
// row by row, then t) and prints processor seconds of the batch on one thread, how many of the poses meet, and
// processor seconds of one distance of a box and a sphere.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <vector>

#include <toccata/io/model_file.hpp>
#include <toccata/query/batch.hpp>
#include <toccata/query/distance.hpp>

using namespace toccata;

namespace {

std::vector<PairQuery> read_queries(const char* path, std::size_t count) {
  std::vector<PairQuery> queries(count);
  std::FILE* file = std::fopen(path, "rb");
  if (file == nullptr) std::exit(2);
  for (PairQuery& query : queries) {
    double numbers[12];
    if (std::fread(numbers, sizeof(double), 12, file) != 12) std::exit(2);
    for (int i = 0; i < 3; ++i) query.pose_b.linear[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    query.pose_b.offset = {numbers[9], numbers[10], numbers[11]};
  }
  std::fclose(file);
  return queries;
}

double seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Asked again and again, with the memory kept, as a program would.
double seconds_of_a_call() {
  const Model box = Box({1, 1, 0.5}), ball = Sphere(0.25);
  const PairQuery query{.pose_b = Pose::translation(0.25, 0, 3)};
  Workspace workspace;
  double best = 1e300, sum = 0;
  constexpr int times = 100'000;
  for (int round = 0; round < 5; ++round) {
    const double begin = seconds();
    for (int i = 0; i < times; ++i) sum += distance(box, ball, query, workspace).upper;
    best = std::min(best, seconds() - begin);
  }
  if (sum == 0) std::exit(2);
  return best / times;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const Model mesh = load_model(words[1]);
  const std::vector<PairQuery> queries = read_queries(words[2], std::strtoull(words[3], nullptr, 10));
  const double begin = seconds();
  const auto found = overlap_each({mesh, mesh, queries}, {.threads = 1});
  const double of_batch = seconds() - begin;
  std::printf("%.9g %ld %.9g\n", of_batch, std::accumulate(found.begin(), found.end(), 0L), seconds_of_a_call());
}
