#pragma once

#include "tandem/match/cost_table.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"
#include "tandem/progress.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

struct ElasticOptions {
  /// Weight of the strain (ds1-ds2)^2/(ds1+ds2). The measured error is flat from 0.001 to 0.02.
  double lambda = 0.02;
  int longest_step = 6;
};

/// Edge costs of the elastic programme: the integral of the chord costs over (ds1+ds2)/2 along the edge, both
/// curves run through at constant speed, plus lambda (ds1-ds2)^2/(ds1+ds2); invalid length by the same
/// quadrature. An edge that touches an invalid chord has one unit of invalid length at least. With
/// Aggregate::maximum an edge holds the largest chord cost under it and no strain. chord_costs: chords(a) x
/// chords(b), from chord_costs(). The programmes of match() compute edges as they go; this table of all of
/// them is for programmes of one's own, and for looking at. Source: spec, "The better formulation".
[[nodiscard]] TANDEM_EXPORT EdgeTable edge_costs(const Samples& a, const Samples& b,
                                                 const NodeTable& chord_costs,
                                                 const ElasticOptions& options = {},
                                                 Aggregate aggregate = Aggregate::sum,
                                                 const Progress& progress = {});

}  // namespace v0
}  // namespace tandem
