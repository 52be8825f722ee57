// Those passes that the scheme as_published has of its own.
#pragma once

#include "../passes.hpp"

namespace parapet::solver::PARAPET_ISA::as_published {

void extrapolate_walls(const FlowArrays& a, int begin, int end);
void gradient_sums(const FlowArrays& a, const GradientSums& sums, int begin, int end);
void pressure_force(const FlowArrays& a, double* ax, double* az, int begin, int end);
void viscous_force(const FlowArrays& a, double* ax, double* az, int begin, int end);
void density_rate(const FlowArrays& a, const ShiftedRates& rates, int begin, int end);
void viscous_matrix(const FlowArrays& a, const ViscousView& v, int begin, int end);
void wall_load(const FlowArrays& a, double* fx, double* fz, int begin, int end);

}  // namespace parapet::solver::PARAPET_ISA::as_published
