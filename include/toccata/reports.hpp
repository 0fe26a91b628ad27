#pragma once

// What the command writes and reads besides shapes and scenes: reports, pages, pictures, cases and trees.

#include "toccata/io/case_file.hpp"
#include "toccata/io/crowd_report.hpp"
#include "toccata/io/output_file.hpp"
#include "toccata/io/pages.hpp"
#include "toccata/io/plot.hpp"
#include "toccata/io/report.hpp"
#include "toccata/io/scene_question.hpp"
