#include "figures/light_joint.h"

#include <algorithm>
#include <cmath>

#include "figures/least_squares.h"

namespace scree::test {
namespace {

constexpr double kNearDeg = 68, kFarDeg = 85;

double root_of_tangent(double cosine) { return std::sqrt(std::sqrt(1 - cosine * cosine) / cosine); }

double at_node(double angle_deg)
{
    return root_of_tangent(std::cos(angle_deg * 0.017453292519943295769));
}

double at_direction(const Vec3f& w)
{
    return root_of_tangent(std::min(static_cast<double>(w.z), 1.0));
}

/// Of one node.
double hat(const Vec3f& w) { return std::min(at_direction(w) / at_node(kFarDeg), 1.0); }

/// Of two nodes, the nearer to the normal first.
std::array<double, 2> hats(const Vec3f& w)
{
    const double x = at_direction(w), near = at_node(kNearDeg), far = at_node(kFarDeg);
    if (x <= near)
        return {x / near, 0};
    const double share = std::min((x - near) / (far - near), 1.0);
    return {1 - share, share};
}

/// Of the difference of azimuths; 0 where one of them has none.
double cosine_between(const Vec3f& wo, const Vec3f& wi)
{
    const Vec2 o(static_cast<double>(wo.x), static_cast<double>(wo.y)),
        i(static_cast<double>(wi.x), static_cast<double>(wi.y));
    const double lengths = o.length() * i.length();
    return lengths > 0 ? o.dot(i) / lengths : 0;
}

using Functions = std::vector<double>;

Functions of_one_node(const Vec3f& wo, const Vec3f& wi)
{
    const double both = hat(wo) * hat(wi);
    return {both, both * cosine_between(wo, wi)};
}

Functions of_two_nodes(const Vec3f& wo, const Vec3f& wi)
{
    const auto o = hats(wo), i = hats(wi);
    const double d = cosine_between(wo, wi), mixed = o[0] * i[1] + o[1] * i[0];
    return {o[0] * i[0], mixed, o[1] * i[1], d * o[0] * i[0], d * mixed, d * o[1] * i[1]};
}

Functions of_two_nodes_alone(const Vec3f& wo, const Vec3f& wi)
{
    Functions all = of_two_nodes(wo, wi);
    const auto o = hats(wo), i = hats(wi);
    // Where the other direction is straight above: 1 at the node before the first one.
    const double o_above = 1 - std::min(o[0] + o[1], 1.0), i_above = 1 - std::min(i[0] + i[1], 1.0);
    all.push_back(o[0] * i_above + o_above * i[0]);
    all.push_back(o[1] * i_above + o_above * i[1]);
    return all;
}

JointForm joint(const std::string& name, const LightWay& base, size_t count,
                Functions (*functions)(const Vec3f&, const Vec3f&))
{
    JointForm form{name, base, NumbersOf::channel, {}, count};
    form.functions = [functions](const PairColors& pair) {
        const Functions all = functions(pair.wo, pair.wi);
        return std::array<Functions, 3>{all, all, all};
    };
    return form;
}

JointForm own_overlap(const std::string& name, const LightWay& base, NumbersOf of)
{
    JointForm form{name, base, of, {}, 2};
    form.functions = [](const PairColors& pair) {
        const Rgbf smaller = overlap(pair);
        const double level = static_cast<double>(pair.wo.x * pair.wi.x + pair.wo.y * pair.wi.y);
        std::array<Functions, 3> all;
        for (size_t c = 0; c < 3; ++c)
            all[c] = {-static_cast<double>(smaller[c]), -level * static_cast<double>(smaller[c])};
        return all;
    };
    return form;
}

/// Least squares of the numbers of a form.
class Fit {
public:
    Fit(const JointForm& form, const LightPairs& pairs)
        : form_(form), pairs_(pairs),
          fits_(form.of == NumbersOf::channel ? 3 : 1, LeastSquares(form.count))
    {}

    void add(const SetTexel& texel, const DirectionColors& colors, const LitFootprint& truth)
    {
        const size_t lights = pairs_.lights.size();
        const std::vector<double> sent = sent_by_angles(truth);
        for (size_t pair = 0; pair < truth.all.size(); ++pair) {
            const SeenLit& lit = truth.all[pair];
            if (!(lit.sent > 0))
                continue;
            const PairColors of_pair =
                pair_colors(texel, colors, pairs_, pair / lights, pair % lights);
            const auto functions = form_.functions(of_pair);
            const Rgbf base = form_.base.color(of_pair);
            for (size_t c = 0; c < 3; ++c)
                fits_[c % fits_.size()].add(functions[c],
                                            lit.color[c] - static_cast<double>(base[c]),
                                            lit.sent / sent[angles(pair)]);
        }
    }

    [[nodiscard]] JointNumbers numbers() const
    {
        JointNumbers numbers;
        for (size_t c = 0; c < 3; ++c)
            numbers[c] = fits_[c % fits_.size()].solution();
        return numbers;
    }

private:
    [[nodiscard]] size_t angles(size_t pair) const
    {
        const size_t lights = pairs_.lights.size();
        return pairs_.view_angle(pair / lights) * pairs_.light_angles_deg.size() +
               pairs_.light_angle(pair % lights);
    }
    [[nodiscard]] std::vector<double> sent_by_angles(const LitFootprint& truth) const
    {
        std::vector<double> sent(pairs_.view_angles_deg.size() * pairs_.light_angles_deg.size());
        for (size_t pair = 0; pair < truth.all.size(); ++pair)
            sent[angles(pair)] += truth.all[pair].sent;
        return sent;
    }

    const JointForm& form_;
    const LightPairs& pairs_;
    std::vector<LeastSquares> fits_;
};

Rgbf not_below_zero(const Rgbf& color)
{
    return {std::max(color[0], 0.0F), std::max(color[1], 0.0F), std::max(color[2], 0.0F)};
}

} // namespace

size_t JointForm::numbers() const
{
    switch (of) {
    case NumbersOf::channel:
        return base.numbers.value() + 3 * count;
    case NumbersOf::texel:
        return base.numbers.value() + count;
    case NumbersOf::level:
        break;
    }
    return base.numbers.value();
}

std::vector<JointForm> joint_forms(const std::vector<LightSource>& sources)
{
    const size_t largest = most_harmonics(sources);
    std::vector<JointForm> all;
    for (const size_t source : {largest, size_t{0}}) {
        const LightWay base = shifts_less_overlap(sources, source);
        const std::string& name = sources[source].name;
        all.push_back(joint(name + ", joint 1x1", base, 2, of_one_node));
        all.push_back(joint(name + ", joint 2x2", base, 6, of_two_nodes));
    }
    const LightWay base = shifts_less_overlap(sources, largest);
    const std::string& name = sources[largest].name;
    all.push_back(own_overlap(name + ", overlap by level", base, NumbersOf::level));
    all.push_back(own_overlap(name + ", overlap by texel", base, NumbersOf::texel));
    all.push_back(joint("joint 2x2 alone", light_ways(sources).front(), 8, of_two_nodes_alone));
    all.back().of_light_alone = true;
    return all;
}

std::vector<JointNumbers> fitted_numbers(const JointForm& form, const std::vector<SetTexel>& texels,
                                         const std::vector<DirectionColors>& colors,
                                         const std::vector<LitFootprint>& truth,
                                         const LightPairs& pairs)
{
    std::vector<JointNumbers> numbers;
    Fit of_level(form, pairs);
    for (size_t i = 0; i < texels.size(); ++i) {
        Fit of_texel(form, pairs);
        (form.of == NumbersOf::level ? of_level : of_texel).add(texels[i], colors[i], truth[i]);
        numbers.push_back(of_texel.numbers());
    }
    if (form.of == NumbersOf::level)
        numbers.assign(texels.size(), of_level.numbers());
    return numbers;
}

Rgbf joint_color(const JointForm& form, const JointNumbers& numbers, const PairColors& pair)
{
    Rgbf color = form.base.color(pair);
    const auto functions = form.functions(pair);
    for (size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (size_t k = 0; k < form.count; ++k)
            sum += numbers[c][k] * functions[c][k];
        color[c] += static_cast<float>(sum);
    }
    return not_below_zero(color);
}

} // namespace scree::test
