#pragma once

#include <string>

namespace toccata::command {

/// The README that `demo --write` puts beside the files, with commands to try.
std::string demo_readme();

}  // namespace toccata::command
