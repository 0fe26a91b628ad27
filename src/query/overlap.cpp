#include "toccata/query/overlap.hpp"

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

bool overlap(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  if (!overlap(pair.a.box(), pair.b.box())) return false;
  if (surfaces_meet(pair.a, pair.b)) return true;
  // One may lie wholly inside the other.
  return (pair.a_solid || pair.b_solid) && relation(a, b, query).kind != RelationKind::apart;
}

}  // namespace toccata
