#pragma once

#include <string>
#include <vector>

#include "toccata/reports/report.hpp"

namespace toccata::command {

CheckReport demo_report(const std::vector<SceneInstance>& models, int threads);

/// The main job on every scene of the demo, for people: the scenes are made and checked now.
std::string demo_text(int threads);

}  // namespace toccata::command
