#pragma once
/// The headers that most programs need: to build a machine, solve it and read its results, or to run a deck.
/// cmake/public_headers.cmake lists the other entry headers; docs/guide/cpp.md shows complete programs.
#include "taut/app/job.hpp"
#include "taut/base/version.hpp"
#include "taut/machine/builder.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/payload.hpp"
#include "taut/units/parse.hpp"
