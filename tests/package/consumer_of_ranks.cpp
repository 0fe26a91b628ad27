// What a user of the library over ranks writes first. Exit status 0 when it is right.
#include <mpi.h>

#include <cstdio>
#include <toccata/distributed.hpp>

namespace {

/// Each rank gives a sphere that touches that of the next.
int pairs_of_a_row() {
  toccata::DistributedWorld world(toccata::MpiCommunicator{MPI_Comm_c2f(MPI_COMM_WORLD)});
  const auto rank = static_cast<toccata::GlobalId>(world.rank());
  const toccata::GlobalBody own{rank, {toccata::Sphere(0.5), toccata::Pose::translation(world.rank(), 0, 0)}};
  world.add({&own, 1});
  int told = static_cast<int>(world.step().begin.size()), all = 0;
  MPI_Allreduce(&told, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int pairs = pairs_of_a_row();
  MPI_Finalize();
  std::printf("%d ranks, %d pairs\n", ranks, pairs);
  return pairs == ranks - 1 ? 0 : 1;
}
