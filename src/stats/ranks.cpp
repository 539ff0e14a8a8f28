#include "stats/ranks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace scree {

namespace {

constexpr int kMaxParts = 9;

/// Adds an atom of the same height.
void join(RankAtom& atom, const RankAtom& other, float weight)
{
    atom.weight += weight;
    const float part = weight / atom.weight;
    for (size_t c = 0; c < 3; ++c)
        atom.color[c] += part * (other.color[c] - atom.color[c]);
}

/// Appends atoms of rising height, joining those that tie.
class Appender {
public:
    explicit Appender(RankAtom* out) : first_(out), end_(out) {}

    void add(const RankAtom& atom, float weight)
    {
        if (end_ != first_ && end_[-1].height == atom.height) {
            join(end_[-1], atom, weight);
        } else {
            *end_ = atom;
            end_->weight = weight;
            ++end_;
        }
    }

    [[nodiscard]] RankProfile profile() const { return {first_, static_cast<int>(end_ - first_)}; }

private:
    RankAtom *first_, *end_;
};

RankProfile merge_two(const ProfilePart& left, const ProfilePart& right, RankAtom* out)
{
    const RankAtom *a = left.profile.atoms, *a_end = a + left.profile.count;
    const RankAtom *b = right.profile.atoms, *b_end = b + right.profile.count;
    Appender merged(out);
    while (a != a_end && b != b_end) {
        // Selected, not branched on: which comes first is a coin toss to the processor.
        const bool is_a = a->height <= b->height;
        const RankAtom* next = is_a ? a : b;
        merged.add(*next, next->weight * (is_a ? left.share : right.share));
        a += is_a ? 1 : 0;
        b += is_a ? 0 : 1;
    }
    for (; a != a_end; ++a)
        merged.add(*a, a->weight * left.share);
    for (; b != b_end; ++b)
        merged.add(*b, b->weight * right.share);
    return merged.profile();
}

} // namespace

RankProfile ProfileMerger::merge(const ProfilePart* parts, int part_count)
{
    assert(part_count >= 1 && part_count <= kMaxParts);
    ProfilePart pending[kMaxParts];
    int count = 0;
    size_t atoms = 0;
    for (int k = 0; k < part_count; ++k)
        if (parts[k].profile.count > 0) {
            pending[count++] = parts[k];
            atoms += static_cast<size_t>(parts[k].profile.count);
        }
    for (auto* buffer : {&from_, &to_})
        if (buffer->size() < atoms)
            buffer->resize(atoms);

    // Two by two, so that every atom is moved log2(parts) times; once at least, for its share.
    bool shared = false;
    while (count > 1 || (count == 1 && !shared)) {
        RankAtom* out = to_.data();
        int merged = 0;
        for (int k = 0; k < count; k += 2) {
            const ProfilePart nothing{{}, 1};
            const RankProfile pair =
                merge_two(pending[k], k + 1 < count ? pending[k + 1] : nothing, out);
            out += pair.count;
            pending[merged++] = {pair, 1};
        }
        count = merged;
        shared = true;
        std::swap(from_, to_);
    }
    return count == 1 ? pending[0].profile : RankProfile{};
}

void summarise(const RankProfile& profile, int most, std::vector<RankAtom>& summary)
{
    assert(profile.count > 0 && most > 0);
    if (profile.count <= most) {
        summary.assign(profile.atoms, profile.atoms + profile.count);
        return;
    }
    double total = 0;
    for (int i = 0; i < profile.count; ++i)
        total += static_cast<double>(profile.atoms[i].weight);
    // An atom belongs to the slot its middle falls in, one of `most` of equal weight; an atom that
    // would fill a slot is one of its own.
    constexpr int kNone = -1;
    summary.clear();
    double below = 0;
    int open_slot = kNone;
    for (int i = 0; i < profile.count; ++i) {
        const RankAtom& atom = profile.atoms[i];
        const auto weight = static_cast<double>(atom.weight);
        const double middle = (below + 0.5 * weight) / total;
        const bool heavy = weight * most >= total;
        const int slot = heavy ? kNone : std::min(most - 1, static_cast<int>(middle * most));
        below += weight;
        if (heavy || slot != open_slot) {
            summary.push_back(atom);
            open_slot = slot;
            continue;
        }
        RankAtom& merged = summary.back();
        const double before = static_cast<double>(merged.weight);
        merged.height += (atom.height - merged.height) * (weight / (before + weight));
        join(merged, atom, atom.weight);
    }
}

namespace {

constexpr int kLanes = 8;
using Lanes = double[kLanes];

/// Adds (c_(b+1) - c_b) (P_(n-1) - P_(n+1))(x_b) of kLanes boundaries to `sums`.
[[gnu::target_clones("avx2", "default")]] void
add_boundaries(const Lanes& x, const Lanes (&step)[3], int terms, Lanes (*sums)[3])
{
    Lanes older, old; // P_(n-1) and P_n
    for (int i = 0; i < kLanes; ++i) {
        older[i] = 1;
        old[i] = x[i];
    }
    for (int n = 1; n <= terms; ++n) {
        const double next = (2.0 * n + 1) / (n + 1), last = static_cast<double>(n) / (n + 1);
        Lanes newer, weight;
        for (int i = 0; i < kLanes; ++i) {
            newer[i] = next * x[i] * old[i] - last * older[i];
            weight[i] = older[i] - newer[i];
        }
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < kLanes; ++i)
                sums[n - 1][c][i] += step[c][i] * weight[i];
        for (int i = 0; i < kLanes; ++i) {
            older[i] = old[i];
            old[i] = newer[i];
        }
    }
}

double sum_of(const Lanes& v)
{
    return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
}

} // namespace

void rank_coefficients(const RankProfile& profile, int terms, double* a)
{
    assert(terms >= 1 && terms <= kMaxRankTerms);
    double total = 0;
    for (int i = 0; i < profile.count; ++i)
        total += static_cast<double>(profile.atoms[i].weight);
    Lanes sums[kMaxRankTerms][3] = {};
    double below = 0;
    for (int begin = 0; begin + 1 < profile.count; begin += kLanes) {
        const int count = std::min(kLanes, profile.count - 1 - begin);
        Lanes x = {}, step[3] = {};
        for (int i = 0; i < count; ++i) {
            const RankAtom* atom = profile.atoms + begin + i;
            below += static_cast<double>(atom[0].weight);
            x[i] = 2 * (below / total) - 1;
            for (size_t c = 0; c < 3; ++c)
                step[c][i] =
                    static_cast<double>(atom[1].color[c]) - static_cast<double>(atom[0].color[c]);
        }
        add_boundaries(x, step, terms, sums);
    }
    for (int n = 0; n < terms; ++n)
        for (int c = 0; c < 3; ++c)
            a[3 * n + c] = 0.5 * sum_of(sums[n][c]);
}

std::array<double, 3> visible_color(const RankProfile& profile, double L)
{
    assert(profile.count > 0);
    double total = 0;
    for (int i = 0; i < profile.count; ++i)
        total += static_cast<double>(profile.atoms[i].weight);
    std::array<double, 3> color{};
    double below = 0, seen_below = 0;
    for (int i = 0; i < profile.count; ++i) {
        const RankAtom& atom = profile.atoms[i];
        below += static_cast<double>(atom.weight);
        const double seen = i + 1 < profile.count ? std::pow(below / total, 1 + L) : 1;
        for (size_t c = 0; c < 3; ++c)
            color[c] += (seen - seen_below) * static_cast<double>(atom.color[c]);
        seen_below = seen;
    }
    return color;
}

} // namespace scree
