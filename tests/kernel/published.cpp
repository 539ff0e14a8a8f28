#include "kernel/published.h"

#include <cmath>

namespace scree::test {

NineIntegrals nine_integrals(const ViewFrame& f, Form form)
{
    const double kPi = std::acos(-1.0);
    const double x = (f.cot_theta - f.mean_o) / std::sqrt(2 * f.var_o);
    const double e1 = std::sqrt(f.var_o / (2 * kPi)) * std::exp(-x * x);
    const double e2 = 1 - std::erfc(x) / 2; // 60

    // Across, given that the slope along is just cot theta: its mean and variance.
    const double lean = f.cov / f.var_o;
    const double edge_mean = f.mean_p + lean * (f.cot_theta - f.mean_o);
    const double edge_variance = (f.var_o * f.var_p - f.cov * f.cov) / f.var_o;
    const double cot2 = f.cot_theta * f.cot_theta;

    NineIntegrals i{};
    i.one = e2;                                                   // 61
    i.o = f.mean_o * e2 - e1;                                     // 62
    i.p = f.mean_p * e2 - lean * e1;                              // 63
    i.oo = f.var_o * e2 + f.mean_o * i.o - f.cot_theta * e1;      // 64
    i.pp = f.var_p * e2 + f.mean_p * i.p - lean * edge_mean * e1; // 65
    i.op = f.cov * e2 + f.mean_p * i.o - lean * f.cot_theta * e1; // 66
    i.oop = 2 * f.cov * i.o + f.mean_p * i.oo - lean * cot2 * e1; // 67
    const double at_edge = form == Form::mended
                               ? -(edge_variance + edge_mean * edge_mean) * e1
                               : -edge_variance + edge_mean * edge_mean * e1; // line 36
    i.opp = f.mean_o * i.pp + 2 * f.cov * i.p + at_edge;                      // 68
    i.ooo = 2 * f.var_o * i.o + f.mean_o * i.oo - cot2 * e1;                  // 69
    return i;
}

PublishedResult published_visible_slopes(double mean_s, double mean_t, double css, double cst,
                                         double ctt, double theta, double phi, Form form)
{
    const double cp = std::cos(phi), sp = std::sin(phi);
    const double horizontal = std::sin(theta), upright = std::cos(theta);
    ViewFrame frame{};
    frame.cot_theta = upright / horizontal;
    frame.mean_o = mean_s * cp + mean_t * sp;                        // 6
    frame.mean_p = mean_t * cp - mean_s * sp;                        // 7
    frame.var_o = css * cp * cp + ctt * sp * sp + 2 * cst * cp * sp; // 8
    frame.var_p = css * sp * sp + ctt * cp * cp - 2 * cst * cp * sp; // 9
    frame.cov = (ctt - css) * cp * sp + cst * (cp * cp - sp * sp);   // 10

    const NineIntegrals i = nine_integrals(frame, form);
    const double n = upright * i.one - horizontal * i.o;    // 24
    auto visible = [&](double with_slope, double without) { // 25 to 29
        return (upright * without - horizontal * with_slope) / n;
    };
    const double o = visible(i.oo, i.o), p = visible(i.op, i.p);
    const double oo = visible(i.ooo, i.oo) - o * o; // 39
    const double pp = visible(i.opp, i.pp) - p * p; // 40
    const double op = visible(i.oop, i.op) - o * p; // 41
    return {n,
            o * cp - p * sp,                                 // 42
            o * sp + p * cp,                                 // 43
            oo * cp * cp + pp * sp * sp - 2 * op * cp * sp,  // 44
            (oo - pp) * cp * sp + op * (cp * cp - sp * sp),  // 46
            oo * sp * sp + pp * cp * cp + 2 * op * cp * sp}; // 45
}

} // namespace scree::test
