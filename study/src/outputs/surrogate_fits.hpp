/// What a surrogate's fit says beside its predictions: how far it can be trusted, and how its
/// answer changes with the noise and with the level.
#pragma once

#include <Eigen/Core>

#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::study {

/// By how much designs left out lie farther off than a process says, at a level; at least 1. Of a
/// level with fewer than five runs nothing can be said: all runs stand for it.
double inflation_at(const surrogate::GaussianProcess& process, int level);

/// Half of what a value moves by when the model's moves by `deviation` either way.
double in_unit(const surrogate::GaussianProcess& process, double z, double deviation);

/// Mean squares of the difference between two levels at the inputs, in the output's unit.
Eigen::VectorXd grid_squares(const surrogate::GaussianProcess& process,
                             const Eigen::MatrixXd& inputs, int level);

/// Their mean over the runs at a level; 0 without one.
double typical_grid_square(const surrogate::GaussianProcess& process, int level);

/// The process fitted again with a noise at every level of so many standard deviations of all
/// values.
surrogate::GaussianProcess with_noise(const surrogate::GaussianProcess& process, double noise);

}  // namespace parapet::study
