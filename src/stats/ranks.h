#pragma once

#include <array>
#include <vector>

namespace scree {

/// The part of a footprint that has one height.
struct RankAtom {
    double height;              ///< in any unit: only the order counts
    float weight;               ///< its area times coverage, > 0
    std::array<float, 3> color; ///< mean color there
};

/// A footprint by rising height, no two atoms of one height: all that masking by rank looks at.
struct RankProfile {
    const RankAtom* atoms = nullptr;
    int count = 0;
};

/// A profile that is one of several side by side.
struct ProfilePart {
    RankProfile profile;
    float share; ///< of the union's area, in (0, 1]
};

/// Profiles side by side as one: the union of the atoms, weights times shares; atoms of one height
/// become one of their mean color, so ties share a rank and few-valued heights stay short.
///
/// The two buffers grow as needed and hold nothing a caller may keep but the result, which lies in
/// one of them.
class ProfileMerger {
public:
    /// parts  1 to 9, from neighbouring texels; none of them in this object's buffers
    RankProfile merge(const ProfilePart* parts, int part_count);

private:
    std::vector<RankAtom> from_, to_;
};

/// A profile of about `most` atoms, at most twice as many: neighbours by rank merged into atoms of
/// equal weight.
///
/// An atom of weight total / most or more stays as it is, so few-valued heights lose nothing. A
/// rank moves by at most 1 / most of the footprint.
///
/// profile  more than 0 atoms
/// summary  gets them
void summarise(const RankProfile& profile, int most, std::vector<RankAtom>& summary);

/// The most terms a table has; scree_color_by_rank of the kernel reads as many.
constexpr int kMaxRankTerms = 8;

/// Color as a function of the height's rank u in the footprint, in shifted Legendre polynomials:
///
///   a_n = (2 n + 1) integral of c(u) P_n(2 u - 1) over [0, 1],   n = 1 .. terms
///       = 1/2 sum_b (c_(b+1) - c_b) (P_(n-1)(x_b) - P_(n+1)(x_b)),   x_b = 2 U_b - 1
///
/// c(u) is the step function of the atoms, U_b the weight below boundary b. Each atom takes the
/// mean of P_n over its ranks, which for n = 1 is P_n at its mean rank; taking it at the mean rank
/// for n > 1 would give a constant color a false a_2. Written as differences of neighbouring
/// colors, equal colors give exactly 0. Derived in docs/statistics.md.
///
/// terms   1 to kMaxRankTerms
/// a       3 x terms numbers, a_1 of R G B, then a_2, ...; zeros for a profile of one atom or none
void rank_coefficients(const RankProfile& profile, int terms, double* a);

/// Visible color where a point of rank u is seen with probability u^L:
///
///   sum_b c_b (U_b^(1+L) - U_(b-1)^(1+L))
///
/// the truth that tables approximate; no assumption on heights, ties need no convention.
///
/// profile  more than 0 atoms
/// L        Smith's Lambda, in [0, 1e6]
std::array<double, 3> visible_color(const RankProfile& profile, double L);

} // namespace scree
