// The exact oscillating drop of oscillating_drop.cpp, and how its swings are read.
#pragma once

#include <vector>

namespace parapet::validation::exact_drop {

constexpr double radius = 1.0;      // R [m]
constexpr double rate = 1.0;        // A, and s at the start [1/s]
constexpr double density = 1000.0;  // [kg/m3]

// ln(a/b) at a time [s], and its largest value.
double elongation(double time);
double largest_elongation();

// Of a full swing [s].
double period();

// Integral of p g over the drop and a period, g = 2 |s| being its shear rate: what friction between
// particles would dissipate with a coefficient of one [J/m].
double friction_scale(double period);

// Upward and downward passages of ln(a/b) through zero after the start, in order; the period is
// twice the time between neighbours.
std::vector<double> passages(const std::vector<double>& time, const std::vector<double>& value);

}  // namespace parapet::validation::exact_drop
