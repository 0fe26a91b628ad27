#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "toccata/query/pair_query.hpp"

namespace toccata {

/// As many workspaces as threads ask at one time, each used again by whoever comes next.
class WorkspacePool {
 public:
  /// Calls `use(workspace)` and returns what it returns.
  template <class Use>
  auto with(const Use& use) {
    const Lease lease(*this);
    return use(*lease.workspace);
  }

 private:
  struct Lease {
    explicit Lease(WorkspacePool& from) : pool(from) {
      const std::lock_guard lock(pool.mutex_);
      if (pool.free_.empty()) {
        pool.free_.reserve(++pool.made_);  // giving back never allocates
        pool.free_.push_back(std::make_unique<Workspace>());
      }
      workspace = std::move(pool.free_.back());
      pool.free_.pop_back();
    }
    ~Lease() {
      const std::lock_guard lock(pool.mutex_);
      pool.free_.push_back(std::move(workspace));
    }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    WorkspacePool& pool;
    std::unique_ptr<Workspace> workspace;
  };

  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> free_;
  std::size_t made_ = 0;
};

}  // namespace toccata
