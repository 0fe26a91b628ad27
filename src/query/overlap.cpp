#include "toccata/query/overlap.hpp"

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "query/relation_posed.hpp"

namespace toccata {

bool overlap(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  if (!overlap(pair.a.box(), pair.b.box())) return false;
  if (surfaces_meet(pair.a, pair.b)) return true;
  // One may lie wholly inside the other.
  return (pair.a_solid || pair.b_solid) &&
         relation_of({pair.a, pair.a_solid}, {pair.b, pair.b_solid}).kind != RelationKind::apart;
}

}  // namespace toccata
