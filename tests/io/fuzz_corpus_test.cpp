#include <gtest/gtest.h>

#include <filesystem>

#include "fuzz/reader_property.hpp"
#include "io/formats/file_bytes.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using fuzz::check_reader;

const fs::path fuzz_corpus = TOCCATA_FUZZ_CORPUS;

Scene parse_gltf(std::span<const char> bytes, std::string_view name) {
  return io::parse_gltf({bytes, std::string(name), "no/such/folder"});
}

Scene parse_scene(std::span<const char> bytes, std::string_view name) {
  return io::parse_scene_file({bytes, std::string(name), "no/such/folder"});
}

template <typename Parse>
void replay(const char* format, Parse parse) {
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(fuzz_corpus / format)) {
    const io::FileBytes bytes = io::read_file(entry.path());
    EXPECT_NO_THROW(check_reader(parse, bytes.span())) << entry.path();
    EXPECT_NO_THROW(check_reader(fuzz::parse_any, bytes.span())) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST(FuzzCorpus, EveryObjIsReadOrRefused) { replay("obj", io::parse_obj); }
TEST(FuzzCorpus, EveryStlIsReadOrRefused) { replay("stl", io::parse_stl); }
TEST(FuzzCorpus, EveryPlyIsReadOrRefused) { replay("ply", io::parse_ply); }
TEST(FuzzCorpus, EveryOffIsReadOrRefused) { replay("off", io::parse_off); }
TEST(FuzzCorpus, EveryGltfIsReadOrRefused) { replay("gltf", parse_gltf); }
TEST(FuzzCorpus, EveryPosesFileIsReadOrRefused) { replay("poses", io::parse_poses); }
TEST(FuzzCorpus, EverySceneIsReadOrRefused) { replay("scene", parse_scene); }

}  // namespace
}  // namespace toccata
