#pragma once

namespace toccata {

/// How wide the interval of the time of a cast should be, of the whole way.
inline constexpr double time_width = 0x1p-42;

}  // namespace toccata
