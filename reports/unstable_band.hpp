#pragma once
#include "reports/chart.hpp"

namespace mpmvv::reports {

/// Puts the crosses of unstable runs above all values: where there are any, the y axis gets a band at its upper end,
/// named `unstable`, in which the crosses at one x of the chart stand below one another in rows of this height or more,
/// a fraction of the axis without the band.
void add_unstable_band(Chart& chart, double row);

/// The same axis, of the values alone, made longer by a band that is this fraction of the whole. Texts of tics that
/// would touch the band's name, with letters of this height, are left out.
void add_band(Axis& axis, double band, double letter);

/// Where the values of the y axis end and the band begins.
double top_of_values(const Chart& chart);

/// Whether the dot has a place within the axes: a cross in the band, a value below it.
bool holds(const Chart& chart, const Dot& dot);

}  // namespace mpmvv::reports
