#include "toccata/query/pair_query.hpp"

#include "query/search_scratch.hpp"

namespace toccata {

Workspace::Workspace() : scratch_(std::make_unique<SearchScratch>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

const WalkCounts& Workspace::counts() const { return scratch_->counts; }

}  // namespace toccata
