#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/sweep.hpp"

namespace toccata::test {

/// What one build of the library has answered in one family. A shard is one seed with a fixed number of cases.
struct EvidenceRun {
  std::string version;
  std::string commit;
  std::vector<std::uint64_t> shards{};  ///< ascending; stored as ranges
  std::uint64_t cases = 0;
  std::uint64_t wrong = 0;
  double seconds = 0;
  std::string first_failure{};
};

struct FamilyEvidence {
  std::vector<EvidenceRun> runs;

  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t cases_of(const std::string& commit) const;
  [[nodiscard]] std::uint64_t wrong() const;
  [[nodiscard]] double seconds() const;
  /// The least seed that no run has done.
  [[nodiscard]] std::uint64_t next_shard() const;
};

/// All that a sweep has shown so far: docs/evidence/<name>.json. Totals in the file are for the reader; what is read
/// back are the runs.
class Evidence {
 public:
  /// Empty when there is no such file; throws std::runtime_error when it is not one.
  static Evidence read(const std::filesystem::path& file, const std::string& name);

  /// The file is the old or the new one at every moment.
  void write(const std::filesystem::path& file) const;

  /// Adds a shard to the run of that version and commit.
  void add(const std::string& family, std::uint64_t shard, const SweepResult& result, double seconds,
           const std::string& version, const std::string& commit);

  [[nodiscard]] const FamilyEvidence& family(const std::string& name) const;

 private:
  std::string name_;
  std::map<std::string, FamilyEvidence> families_;
};

}  // namespace toccata::test
