#pragma once

// The rational oracle: the truth page (docs/truth.md) as code. Every fast answer is compared with it.
#include "oracle/convex.hpp"
#include "oracle/meshes.hpp"
#include "oracle/rational.hpp"
#include "oracle/triangles.hpp"
