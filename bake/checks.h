#pragma once

namespace CLI {
class Validator;
}

namespace scree::tool {

// Checks of the numbers that options take, for CLI::Option::check(). Unlike CLI11's own they refuse
// a NaN, and say in a few words what is expected.

/// least <= x <= most
CLI::Validator number_from_to(double least, double most);

/// Above 0, finite.
CLI::Validator number_above_zero();

CLI::Validator finite_number();

/// least <= n <= most
CLI::Validator whole_number_from_to(long long least, long long most);

/// n >= least
CLI::Validator whole_number_from(long long least);

/// "auto", or a finite number.
CLI::Validator angle_or_auto();

} // namespace scree::tool
