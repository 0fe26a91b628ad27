// `toccata view` and `check --html`: a page is written whole, or a clear error tells why not.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/page.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using test::text_of;

TEST(ViewCommand, WritesOnePageAndSaysSo) {
  const TemporaryFolder folder;
  const auto result = run_command({"view", "gen:box", "gen:icosphere", "-o", "page.html"}, folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("page.html: 2 objects and 1 pair"), std::string::npos) << result.out;
  const std::string page = text_of(folder.path() / "page.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(test::page_text(folder.path() / "page.html").find("\"verb\":\"lies inside\""), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(ViewCommand, CheckWritesItBesideItsAnswer) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"check", "gen:box", "gen:box", "--json"};
  const auto plain = run_command(words, folder.path());
  std::vector<std::string> with_page = words;
  with_page.insert(with_page.end(), {"--html", "report.html"});
  const auto both = run_command(with_page, folder.path());
  EXPECT_EQ(both.exit_code, 1) << both.err;
  EXPECT_EQ(both.out, plain.out);
  EXPECT_NE(test::page_text(folder.path() / "report.html").find("\"face_pairs\":"), std::string::npos);
}

TEST(ViewCommand, TheSamePageForAnyThreads) {
  const TemporaryFolder folder;
  const auto page = [&](const std::string& threads) {
    EXPECT_EQ(
        run_command({"view", "gen:torus", "gen:torus-knot", "--penetration", "--threads", threads, "-o", "page.html"},
                    folder.path())
            .exit_code,
        0);
    return text_of(folder.path() / "page.html");
  };
  EXPECT_EQ(page("1"), page("3"));
}

TEST(ViewCommand, DrawsWhatThePageShows) {
  const TemporaryFolder folder;
  const auto result = run_command(
      {"view", "gen:torus", "gen:torus-knot", "--png", "torus.png", "--size", "320x200", "--look", "finding=0"},
      folder.path());
  if (result.err.find("no Chromium was found") != std::string::npos) GTEST_SKIP() << "no Chromium is installed";
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(text_of(folder.path() / "torus.png").starts_with("\x89PNG\r\n"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

/// A page of somebody else is one, too.
TEST(ViewCommand, ReplacesOnlyWhatItWrote) {
  const TemporaryFolder folder;
  folder.write("theirs.html", "<!doctype html>\n<p>theirs</p>");
  folder.write("empty.html", "");
  const auto exit_code_for = [&](const std::string& file) {
    return run_command({"view", "gen:box", "-o", file}, folder.path()).exit_code;
  };
  EXPECT_EQ(exit_code_for("theirs.html"), 2);
  EXPECT_EQ(text_of(folder.path() / "theirs.html"), "<!doctype html>\n<p>theirs</p>");
  EXPECT_EQ(exit_code_for("empty.html"), 0);
  EXPECT_EQ(exit_code_for("empty.html"), 0);
}

TEST(ViewCommand, CheckWritesAGlbFileBesideItsAnswer) {
  const TemporaryFolder folder;
  const auto result =
      run_command({"check", "gen:box", "gen:icosphere", "--penetration", "--glb", "both.glb"}, folder.path());
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_TRUE(text_of(folder.path() / "both.glb").starts_with("glTF"));
  const auto view = run_command({"view", "gen:torus", "--hierarchy", "obb", "--glb", "tree.glb"}, folder.path());
  EXPECT_EQ(view.exit_code, 0) << view.err;
  EXPECT_NE(view.out.find("tree.glb: 1 object, "), std::string::npos) << view.out;
  const auto read = run_command({"inspect", "tree.glb"}, folder.path());
  EXPECT_NE(read.out.find("level 3"), std::string::npos) << read.out << read.err;
}

/// In the page and in the GLB file, of a scene, of a report and of a case.
TEST(ViewCommand, DrawsPartitionsAndVoronoiRegions) {
  const TemporaryFolder folder;
  folder.write("report.json", run_command({"distance", "gen:box", "gen:box", "--json"}, folder.path()).out);
  ASSERT_EQ(run_command({"inspect", "gen:box", "--save-case", "case.json"}, folder.path()).exit_code, 0);
  for (const std::string file : {"gen:box", "report.json", "case.json"}) {
    const auto drawn = run_command(
        {"view", file, "--partition", "octree", "--voronoi", "-o", "page.html", "--glb", "page.glb"}, folder.path());
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    const std::string page = test::page_text(folder.path() / "page.html"), glb = text_of(folder.path() / "page.glb");
    for (const char* name : {"box: cells of the octree", "box: Voronoi regions"})
      EXPECT_NE(page.find(name), std::string::npos) << file << ": " << name;
    for (const char* name : {"cells of the octree over box", "Voronoi regions of box", "nearest to an edge"})
      EXPECT_NE(glb.find(name), std::string::npos) << file << ": " << name;
  }
}

/// Long work is not begun for a file that cannot be written.
TEST(ViewCommand, RefusesAtOnceWhatCannotBeWritten) {
  const TemporaryFolder folder;
  for (const char* option : {"--html", "--glb"}) {
    const auto result = run_command({"check", "nothing.obj", option, "nowhere/file"}, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("nowhere/file: the file cannot be written"), std::string::npos) << result.err;
  }
}

TEST(ViewCommand, TroubleWritesNothing) {
  const TemporaryFolder folder;
  folder.write("notes.txt", "mine");
  folder.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    const auto result = run_command(words, folder.path());
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  refused({"view", "gen:box"}, "no page was named: say where it shall be written with -o FILE.html");
  refused({"view", "-o", "page.html"}, "no file was named");
  refused({"view", "broken.obj", "-o", "page.html"}, "broken.obj:2");
  refused({"view", "gen:box", "-o", "notes.txt"},
          "notes.txt: the file exists and is not a page of Toccata; choose another name, or delete it");
  refused({"view", "gen:box", "-o", "nowhere/page.html"}, "nowhere/page.html");
  refused({"view", "gen:box", "--hierarchy", "ob", "-o", "page.html"}, "there is no volume 'ob'; did you mean 'obb'?");
  refused({"view", "gen:box", "-o", "page.html", "--size", "9x9"}, "--size and --look are of a picture");
  refused({"view", "gen:box", "--png", "a.png", "--size", "9x900"}, "'9x900' is no size");
  refused({"view", "gen:box", "--png", "a.png", "--look", "findign=0"},
          "'findign' is nothing that a link can say; did you mean 'finding'?");
  refused({"view", "gen:box", "--png", "a.png", "--look", "theme=dark&finding=0&theme=light"}, "'theme' is said twice");
  refused({"view", "gen:box", "--png", "notes.txt"}, "notes.txt: the file exists and is not a picture of Toccata");
  refused({"check", "gen:box", "gen:box", "--html", "notes.txt"}, "is not a page of Toccata");
  refused({"check", "gen:box", "--self", "--html", "notes.txt"}, "is not a page of Toccata");
  refused({"view", "gen:box", "--glb", "notes.txt"}, "is not a GLB file of Toccata");
  refused({"view", "gen:box", "-o", "page.html", "--hierarchy", ""}, "a volume must be named");
  refused({"view", "gen:torus", "-o", "page.html", "--voronoi"}, "has no Voronoi regions to draw");
  refused({"view", "gen:box", "-o", "page.html", "--partition", "octre"}, "did you mean 'octree'?");
  refused({"view", "gen:box", "-o", ""}, "a file must be named");
  refused({"view", "gen:box", "-o", "a.html", "--glb", "./a.html"},
          "--glb would write ./a.html, which is that of -o or --html too: give them different names");
  refused({"view", "broken.obj", "-o", "broken.obj"}, "which is a file that is read too");
  EXPECT_EQ(text_of(folder.path() / "notes.txt"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "page.html"));
}

}  // namespace
}  // namespace toccata
