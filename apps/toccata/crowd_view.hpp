#pragma once

#include <optional>
#include <string>

#include "arguments.hpp"
#include "picture.hpp"
#include "toccata/io/crowd_report.hpp"

namespace toccata::command {

/// What shall be written of a crowd: a page, a picture of it, both or neither.
class CrowdView {
 public:
  /// Throws Error, before long work, where what is asked for cannot be written or does not go together.
  CrowdView(const CrowdArguments& arguments, CrowdQuestion question);

  /// Runs the crowd once more, frame by frame as it was measured, and writes what it was. Gives a line for each file.
  [[nodiscard]] std::string write() const;
  /// Writes this page, or its picture. Gives a line for each file, which says what it `holds`.
  [[nodiscard]] std::string write(const std::string& page, const std::string& holds) const;
  /// There is something to be written.
  [[nodiscard]] bool draws() const;

 private:
  CrowdArguments arguments_;
  CrowdQuestion question_;
  std::optional<PictureTarget> picture_;
};

}  // namespace toccata::command
