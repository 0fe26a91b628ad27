#pragma once

#include <string>

#include "arguments.hpp"
#include "toccata/reports/scene_question.hpp"
#include "view.hpp"

namespace toccata::command {

/// What shall be written of a crowd: a page, a picture of it, a GLB file, some of these or none.
class CrowdView {
 public:
  /// `question` is about a crowd. Throws Error, before long work, where what is asked for cannot be written or does not
  /// go together.
  CrowdView(const CrowdArguments& arguments, SceneQuestion question);

  /// Runs the crowd once more, frame by frame as it was measured, and writes what it was. Gives a line for each file.
  [[nodiscard]] std::string write() const;

 private:
  SceneQuestion question_;
  ViewTarget target_;
  bool is_tracked_;  ///< the page shows a grid's cells in place of the method's
};

/// "100 boxes", "1 body that flies".
std::string crowd_words(const CrowdQuestion& question);
std::string crowd_words(const CrowdWorldQuestion& question);

}  // namespace toccata::command
