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
/// chords(b), from chord_costs(). elastic_path() needs no such table; it is for programmes of
/// one's own, and for looking at. Source: spec, "The better formulation".
[[nodiscard]] TANDEM_EXPORT EdgeTable edge_costs(const Samples& a, const Samples& b,
                                                 const NodeTable& chord_costs,
                                                 const ElasticOptions& options = {},
                                                 Aggregate aggregate = Aggregate::sum,
                                                 const Progress& progress = {});

/// Optimal path over the edges of edge_costs(), from the same arguments but without that table: memory for
/// one double per pair of nodes (two where no path is valid; twice that on loops). Two open curves: as
/// open_path(); the first a loop: as cut_path(); both: as closed_path(), with `beat` as there.
/// @throws InvalidArgument as edge_costs(); only the second curve is a loop (exchange them)
[[nodiscard]] TANDEM_EXPORT Path elastic_path(const Samples& a, const Samples& b,
                                              const NodeTable& chord_costs,
                                              const ElasticOptions& options = {},
                                              Aggregate aggregate = Aggregate::sum,
                                              const Progress& progress = {}, const Path* beat = nullptr);

}  // namespace v0
}  // namespace tandem
