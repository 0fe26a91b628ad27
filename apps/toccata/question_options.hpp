#pragma once

#include "options.hpp"

// A subcommand each, with its options.
namespace toccata::command {

void add_check(CLI::App& app, Options& options);
void add_view(CLI::App& app, Options& options);
void add_distance(CLI::App& app, Options& options);
void add_ray(CLI::App& app, Options& options);
void add_faces(CLI::App& app, Options& options);
void add_nearest(CLI::App& app, Options& options);

}  // namespace toccata::command
