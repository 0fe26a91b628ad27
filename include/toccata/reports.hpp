#pragma once

// What the command writes and reads besides shapes and scenes: reports, pages, pictures, cases and trees.

#include "toccata/reports/case_file.hpp"
#include "toccata/reports/crowd_report.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/reports/plot.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/reports/scene_question.hpp"
