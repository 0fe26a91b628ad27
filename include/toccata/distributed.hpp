#pragma once

// Many machines: a World and a check over the ranks of an MPI communicator, in a library of its own
// (docs/guide/distributed.md).

#include "toccata/distributed/distributed_scene.hpp"
#include "toccata/distributed/distributed_world.hpp"
