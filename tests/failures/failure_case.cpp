#include "failures/failure_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace scree::test {

Figure::Figure(std::string what, double truth)
    : what_(std::move(what)), truth_(truth), yardstick_(std::abs(truth))
{}

Figure& Figure::peer(std::string way, double value)
{
    return peer(std::move(way), std::optional<double>(value));
}

Figure& Figure::peer(std::string way, std::optional<double> value)
{
    peer_way_ = std::move(way);
    peer_ = value;
    return *this;
}

Figure& Figure::ours(double value)
{
    ours_ = value;
    return *this;
}

Figure& Figure::bound(double relative_error)
{
    bound_ = relative_error;
    return *this;
}

Figure& Figure::relative_to(double value, std::string name)
{
    yardstick_ = value;
    yardstick_name_ = std::move(name);
    return *this;
}

Figure& Figure::aside()
{
    aside_ = true;
    return *this;
}

double Figure::error_of(double value) const
{
    return std::isfinite(value) ? std::abs(value - truth_) / yardstick_
                                : std::numeric_limits<double>::infinity();
}

Verdict Figure::verdict_of(double value) const
{
    const double error = error_of(value);
    if (error <= kOkWithin)
        return Verdict::ok;
    return error <= kLimitedWithin ? Verdict::limited : Verdict::fails;
}

void add_words(Measured& all, const std::vector<OurWords>& words)
{
    all.our_words.insert(all.our_words.end(), words.begin(), words.end());
}

const Figure& shown_figure(const Measured& measured)
{
    const Figure* worst = &measured.figures.front();
    if (our_verdict(measured) == Verdict::ok)
        return *worst;
    for (const Figure& figure : measured.figures)
        if (!figure.is_aside() &&
            figure.error_of(figure.our_value()) > worst->error_of(worst->our_value()))
            worst = &figure;
    return *worst;
}

Verdict our_verdict(const Measured& measured)
{
    Verdict worst = Verdict::ok;
    for (const Figure& figure : measured.figures)
        if (!figure.is_aside())
            worst = std::max(worst, figure.verdict_of(figure.our_value()));
    return worst;
}

Verdict peer_verdict(const Measured& measured)
{
    Verdict worst = Verdict::ok;
    for (const Figure& figure : measured.figures)
        if (figure.peer_value())
            worst = std::max(worst, figure.verdict_of(*figure.peer_value()));
    return worst;
}

} // namespace scree::test
