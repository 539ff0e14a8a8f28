#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scree::test {

/// What a number is worth.
enum class Verdict {
    ok,      ///< within kOkWithin of the truth
    limited, ///< within kLimitedWithin
    fails,   ///< further off, or not a number
};

constexpr double kOkWithin = 0.02, kLimitedWithin = 0.25; // of the figure's yardstick

/// One number to watch: what it should be, what others make of it, what Scree makes of it.
///
///     Figure("G1 at 75 degrees", truth).peer("Smith, Gaussian", g1).ours(mine).bound(0.07)
class Figure {
public:
    Figure(std::string what, double truth);

    /// The number of others. way  whose: "maketx", "as printed", "plain code", ...
    Figure& peer(std::string way, double value);
    /// The same, absent where the program is not installed.
    Figure& peer(std::string way, std::optional<double> value);
    Figure& ours(double value);
    /// The largest error of ours that the test lets pass, relative to the yardstick.
    Figure& bound(double relative_error);
    /// What errors are relative to, where it is not the truth itself: a truth of 0, say.
    /// value  above 0
    Figure& relative_to(double value, std::string name);

    /// Shown, but no part of the verdict: what comes of an option that nobody has to take.
    Figure& aside();

    [[nodiscard]] const std::string& what() const { return what_; }
    [[nodiscard]] double truth() const { return truth_; }
    [[nodiscard]] const std::string& peer_way() const { return peer_way_; } ///< empty: no peer
    [[nodiscard]] const std::optional<double>& peer_value() const { return peer_; }
    [[nodiscard]] double our_value() const { return ours_; }
    [[nodiscard]] double allowed() const { return bound_; }
    [[nodiscard]] bool is_aside() const { return aside_; }
    [[nodiscard]] double yardstick() const { return yardstick_; }
    [[nodiscard]] const std::string& yardstick_name() const { return yardstick_name_; }

    /// |value - truth| / yardstick; infinite where the value is not a number.
    [[nodiscard]] double error_of(double value) const;
    [[nodiscard]] Verdict verdict_of(double value) const;
    /// Whether the error of ours is within its bound.
    [[nodiscard]] bool holds() const { return error_of(ours_) <= bound_; }

private:
    std::string what_, peer_way_, yardstick_name_;
    double truth_, ours_ = 0, bound_ = 0, yardstick_;
    std::optional<double> peer_;
    bool aside_ = false;
};

/// What Scree says of an asset when it bakes or validates it.
struct OurWords {
    std::string asset; ///< "the groove"
    std::string words; ///< without the file's name; empty: nothing
};

/// What was measured of a case.
struct Measured {
    std::vector<Figure> figures; ///< the most telling one first
    std::vector<OurWords> our_words;
};

/// Adds what Scree says of one more asset.
void add_words(Measured& all, const std::vector<OurWords>& words);

/// One way for a filtered surface to go wrong.
struct FailureCase {
    int number;          ///< as in the list of cases, 1 to 23
    std::string title;   ///< a few words
    std::string asset;   ///< what is baked or evaluated
    std::string happens; ///< what goes wrong, where and why
    std::string advice;  ///< to the user of Scree
    Measured (*measure)();
};

/// What an overview shows: the figure that Scree is worst at; the first where all are ok.
const Figure& shown_figure(const Measured& measured);

/// The worst of a case's figures: ours, and others' (ok where there is none).
Verdict our_verdict(const Measured& measured);
Verdict peer_verdict(const Measured& measured);

} // namespace scree::test
