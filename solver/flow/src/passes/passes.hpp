// Declarations of the passes inside the namespace of the instruction set being compiled.
#pragma once

#include "parapet/flow/flow_arrays.hpp"

namespace parapet::solver::PARAPET_ISA {

int pick_near(const NearCandidates& candidates, std::int32_t* out);
void reached_rows(const FlowArrays& a, const NearView& near, const ReachedRows& rows, int begin,
                  int end);
void extrapolate_walls(const FlowArrays& a, int begin, int end);
void gradient_sums(const FlowArrays& a, const GradientSums& sums, int begin, int end);
void pressure_force(const FlowArrays& a, double* ax, double* az, int begin, int end);
void viscous_force(const FlowArrays& a, double* ax, double* az, int begin, int end);
void density_rate(const FlowArrays& a, const ShiftedRates& rates, int begin, int end);
void viscous_matrix(const FlowArrays& a, const ViscousView& v, int begin, int end);
double viscous_product(const FlowArrays& a, const ViscousView& v, const MotionRecord* p, double* yx,
                       double* yz, int begin, int end);
DescentSums descend(const DescentView& d, double step, int begin, int end);
void turn(const DescentView& d, double beta, int begin, int end);
void wall_load(const FlowArrays& a, double* fx, double* fz, int begin, int end);

}  // namespace parapet::solver::PARAPET_ISA
