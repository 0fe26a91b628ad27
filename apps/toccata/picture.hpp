#pragma once

#include <string>

namespace toccata::command {

/// A picture of a page, drawn by Chromium without a window.
struct PictureTarget {
  std::string path;  ///< a PNG; it is complete or not there
  std::string look;  ///< the end of a link to the page, "finding=0&theme=dark"; what is left open is light, no panels
  int width = 1200;
  int height = 800;
};

/// Throws Error when no Chromium is installed, or the file cannot be written (require_output): before long work.
void require_picture(const PictureTarget& target);

/// Throws Error as require_picture does, and when Chromium draws nothing within two minutes. Interrupted, it ends
/// Chromium and leaves nothing behind.
void write_picture(const std::string& page, const PictureTarget& target);

/// "1200x800" as width and height. Throws Error for what is none, and for sizes out of 16 to 8192.
void set_size(PictureTarget& target, const std::string& text);

}  // namespace toccata::command
