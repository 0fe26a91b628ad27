#pragma once

// Many machines: a World over the ranks of an MPI communicator, in a library of its own (docs/guide/distributed.md).

#include "toccata/distributed/distributed_world.hpp"
