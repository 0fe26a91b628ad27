#pragma once

#include <vector>

#include "arguments.hpp"
#include "load.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::command {

/// Everything that is checked, ready for questions.
struct CheckInput {
  LoadedScene loaded;
  std::vector<Posed> models;  ///< of the scene's objects, in their order
};

/// Reads the files and applies what the options say about poses and solids.
CheckInput read_check_input(const CheckArguments& arguments);

/// An open mesh among solids contains nothing: whoever did not know that it is open should. Adds a warning then.
void warn_of_open_meshes(CheckInput& input);

}  // namespace toccata::command
