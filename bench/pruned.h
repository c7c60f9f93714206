#pragma once
// Materials with less in them than they were fitted with, for curves of error against time.
#include "engine/project/project.h"

namespace vamp {

// Every material without its residual.
Project without_residuals(Project project);

// Every material with so many PCA terms of its residual at most.
Project with_terms(Project project, int terms);

// Every material with at most so many functions a texel: those that send most light back head-on, their weights raised
// so that the sum of it stays.
Project with_functions(Project project, int most);

// Functions a texel on the mean.
double functions_of(const Spmm& fit);

}  // namespace vamp
