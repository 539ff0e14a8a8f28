#include "kernel/cases.h"

#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_filter.h"
// after it
#include "kernel/case_outputs.h"
} // namespace scree::kernel

namespace scree::test {

template <typename Real>
Outputs<Real> evaluate(const KernelCase& row)
{
    const auto in = [&](int i) { return static_cast<Real>(row.in[static_cast<size_t>(i)]); };
    Outputs<Real> o{};
    kernel::case_outputs(
        in(0), in(1), in(2), in(3), in(4), in(5), in(6), in(7), in(8), in(9), in(10), in(11),
        in(12), in(13), in(14), in(15), in(16), in(17), in(18), in(19), in(20), in(21), in(22),
        in(23), in(24), in(25), in(26), in(27), in(28), in(29), in(30), in(31), in(32), in(33),
        in(34), in(35), in(36), in(37), in(38), in(39), in(40), in(41), in(42), in(43), o[0], o[1],
        o[2], o[3], o[4], o[5], o[6], o[7], o[8], o[9], o[10], o[11], o[12], o[13], o[14], o[15],
        o[16], o[17], o[18], o[19], o[20], o[21], o[22], o[23], o[24], o[25], o[26], o[27], o[28],
        o[29], o[30], o[31], o[32], o[33], o[34], o[35], o[36], o[37], o[38], o[39]);
    static_assert(kInputs == 44 && kOutputs == 40);
    return o;
}

template Outputs<float> evaluate<float>(const KernelCase&);
template Outputs<double> evaluate<double>(const KernelCase&);

} // namespace scree::test
