// What a user of the library writes first; built in each way the library can be used. Exit status 0 when it is right.
#include <toccata/toccata.hpp>

#include <cstdio>

namespace {

toccata::Model tetrahedron() {
  return toccata::Model(toccata::TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
}

}  // namespace

int main() {
  const toccata::Model a = tetrahedron();
  const toccata::Model b = tetrahedron();
  const bool near = toccata::overlap(a, b, {.pose_b = toccata::Pose::translation(0.25, 0, 0)});
  const bool far = toccata::overlap(a, b, {.pose_b = toccata::Pose::translation(2, 0, 0)});
  std::printf("toccata %s: near %d, far %d\n", toccata::version, near, far);
  return near && !far ? 0 : 1;
}
