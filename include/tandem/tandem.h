#pragma once

/// The library's table of contents; tandem::io has its own headers under tandem/io/.

#include "tandem/curve/arc_length.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/curve.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/curve/points.h"
#include "tandem/error.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"
#include "tandem/progress.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/path_builder.h"
#include "tandem/shape/shape.h"
#include "tandem/shape/transform.h"
#include "tandem/version.h"
