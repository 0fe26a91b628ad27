#include "toccata/math/pose.hpp"

int main() { return toccata::is_finite(toccata::Pose{}) ? 0 : 2; }
