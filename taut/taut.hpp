#pragma once
/// What most programs on the library need: build a machine, solve it, ask it; or run a deck. The other entry headers
/// are listed in cmake/public_headers.cmake; docs/guide/cpp.md has whole programs.
#include "taut/app/job.hpp"
#include "taut/base/version.hpp"
#include "taut/machine/builder.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/payload.hpp"
#include "taut/units/parse.hpp"
