#pragma once

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "toccata/generate/meshes.hpp"

namespace toccata {

/// Tells the objects of all files apart by their names.
class FreeNames {
 public:
  /// `name`; or, where an object of another file has it, the file's path; or with a number behind, whichever is free
  /// first. It is taken then.
  std::string take(const std::string& name, const std::string& file, bool file_is_new) {
    std::string free = free_one(name, file, file_is_new);
    taken_.insert(free);
    return free;
  }

 private:
  std::string free_one(const std::string& name, const std::string& file, bool file_is_new) {
    if (!taken_.contains(name)) return name;
    std::string longer = file + ":" + name;
    if (file_is_new && !is_generator_specification(file) && !taken_.contains(longer)) return longer;
    for (int& number = next_number_.try_emplace(name, 2).first->second;; ++number) {
      std::string numbered = fmt::format("{} #{}", name, number);
      if (!taken_.contains(numbered)) return numbered;
    }
  }

  std::set<std::string> taken_;
  std::map<std::string, int> next_number_;  ///< of each name; those below are taken, and stay so
};

}  // namespace toccata
