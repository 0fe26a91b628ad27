#include <fmt/format.h>

#include <optional>

#include "self.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata::bench {
namespace {

/// With the tree made before, or for every question, as CGAL makes its boxes.
class ToccataSelf : public SelfLibrary {
 public:
  explicit ToccataSelf(bool builds) : builds_(builds) {}

  Description description() const override {
    return {"toccata", builds_ ? "tree and search" : "search", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  bool prepare(const TriangleMesh& mesh) override {
    mesh_ = std::make_shared<const TriangleMesh>(mesh);
    model_.emplace(mesh_);
    return true;
  }
  TrianglePairs pairs() override {
    const Model model = builds_ ? Model(mesh_) : *model_;
    TrianglePairs pairs;
    for (const Contact& contact : self_contacts(model, {}, workspace_))
      pairs.emplace_back(contact.element_a, contact.element_b);
    return pairs;
  }

 private:
  bool builds_;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::optional<Model> model_;
  Workspace workspace_;
};

}  // namespace

SelfLibraries toccata_self_libraries() {
  SelfLibraries libraries;
  libraries.push_back(std::make_unique<ToccataSelf>(true));
  libraries.push_back(std::make_unique<ToccataSelf>(false));
  return libraries;
}

}  // namespace toccata::bench
