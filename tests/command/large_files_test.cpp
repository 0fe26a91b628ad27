#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "support/command.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using test::run_command;
using test::TemporaryFolder;

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(TreeCacheOption, KeepsTreesAndAnswersTheSame) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"check", "gen:torus-knot", "gen:noise-sphere", "--faces", "--json"};
  std::vector<std::string> cached = words;
  cached.insert(cached.end(), {"--cache", "trees"});
  const auto plain = run_command(words, folder.path()), first = run_command(cached, folder.path());
  ASSERT_EQ(plain.exit_code, 1) << plain.err;
  EXPECT_EQ(first.exit_code, 1) << first.err;
  EXPECT_EQ(first.out, plain.out);
  EXPECT_EQ(first.err, plain.err);
  ASSERT_EQ(files_in(folder.path() / "trees"), 2U);
  const auto second = run_command(cached, folder.path());
  EXPECT_EQ(second.out, plain.out);
  EXPECT_EQ(second.err, plain.err);

  const fs::path damaged = fs::directory_iterator(folder.path() / "trees")->path();
  std::fstream(damaged, std::ios::binary | std::ios::in | std::ios::out).seekp(2000).put('x').put('y');
  const auto third = run_command(cached, folder.path());
  EXPECT_EQ(third.exit_code, 1);
  EXPECT_TRUE(says(third.err, damaged.filename().string() + ": the tree file is damaged")) << third.err;
  EXPECT_TRUE(says(third.err, "the tree is built anew")) << third.err;
  EXPECT_EQ(run_command(cached, folder.path()).err, plain.err) << "it was not mended";
}

TEST(TreeCacheOption, WithoutAFolderTheAnswerComesWithAWarning) {
  const TemporaryFolder folder;
  folder.write("trees", "a file");
  const auto run =
      run_command({"nearest", "gen:torus-knot", "--point", "0", "0", "0", "--cache", "trees"}, folder.path());
  EXPECT_TRUE(says(run.err, "toccata: warning: trees were not kept: trees")) << run.err;
  EXPECT_FALSE(run.out.empty());
  EXPECT_NE(run.exit_code, 2);
}

/// A file of eight terabytes, of which nothing is written.
TEST(LargeFiles, WhatCannotBeReadIsToldBeforeItIsTried) {
  const TemporaryFolder folder;
  folder.write("huge.obj", "v 0 0 0\n");
  std::error_code code;
  fs::resize_file(folder.path() / "huge.obj", 8'000'000'000'000, code);
  if (code) GTEST_SKIP() << "no file can be as large here: " << code.message();
  const auto run = run_command({"check", "huge.obj", "gen:box"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(says(run.err, "takes some 2.4e+04 GB of memory, and this run has ")) << run.err;
}

TEST(LargeFiles, ATerminalShowsHowFarReadingIs) {
  std::vector<std::string> words = {"check", "--threads", "1"};
  for (const char* seed : {"1", "2", "3", "4"})
    words.push_back(std::string("gen:noise-sphere?subdivisions=8&seed=") + seed);
  const std::string seen = test::seen_on_terminal(words, " s");
  EXPECT_TRUE(says(seen, "MB read") || says(seen, "building trees")) << seen;
}

TEST(LargeFiles, HelpTellsOfTheCache) {
  for (const char* subcommand : {"check", "distance", "nearest", "ray", "faces", "sweep", "view", "inspect"})
    EXPECT_TRUE(says(run_command({subcommand, "--help"}).out, "--cache FOLDER")) << subcommand;
}

}  // namespace
}  // namespace toccata
