#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::command {

/// What is asked about the files of the arguments, which `input` was read from.
Asked asked_of(const CheckInput& input, const PosedArguments& arguments, const SceneQuestion& question);
Asked asked_of(std::vector<AskedFile> files, const PosedArguments& arguments, const SceneQuestion& question);

/// What a crowd is asked of.
CheckInput about_no_file();

/// What a report is about, read again: names of files begin beside the report, or where they began when it was asked.
/// Throws Error naming the file that is gone or holds something else now.
CheckInput read_again(const SavedReport& saved, const std::string& report, int threads);

}  // namespace toccata::command
