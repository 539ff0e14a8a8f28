#!/usr/bin/env python3
"""Fits the constants of src/kernel/scree_*.h and prints them, lowest power first.

Usage: docs/fit_kernel.py    (Debian: python3-mpmath python3-numpy python3-scipy)

Minimax in the relative error: weighted least squares on Chebyshev points, weights raised where the
error is largest (Lawson), denominators of rational functions iterated. The tests of the kernel check
the results against integrals; this only says where the digits come from.
"""
import mpmath as mp
import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.special import erfcx, log_ndtr

mp.mp.dps = 60


def chebyshev(count):
    """Points in (0, 1), dense towards both ends."""
    return (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)) / 2


def lawson(columns, right, scale, value, error, rounds, start=0, accept=lambda x: True):
    """Solves columns x = right for the least largest error.

    scale(x)  what rows are divided by, from the last solution (None at first)
    """
    weight = np.ones(len(right))
    best = (np.inf, None)
    last = None
    for step in range(rounds):
        w = np.sqrt(weight) / scale(last)
        norm = np.linalg.norm(columns * w[:, None], axis=0)
        x, *_ = np.linalg.lstsq(columns * w[:, None] / norm, right * w, rcond=1e-17)
        last = x / norm
        e = error(value(last))
        if step >= start:
            if e.max() < best[0] and accept(last):
                best = (e.max(), last)
            weight = weight * (e / e.max() + 1e-3) ** 0.7
            weight /= weight.max()
    return best


def show(name, worst, **series):
    print(f"{name}: relative error {worst:.2g}")
    for letter, numbers in series.items():
        print(f"    {letter} =", ", ".join(repr(float(n)) for n in numbers))


def fraction_rest(y):
    """K3(y) = 1 / (y + 4 / (y + 5 / (y + ...)))."""
    y = mp.mpf(y)
    if y < 60:
        mills = mp.sqrt(mp.pi / 2) * mp.erfc(y / mp.sqrt(2)) * mp.exp(y * y / 2)
        k1 = 1 / mills - y
        k2 = (1 / k1 - y) / 2
        return (1 / k2 - y) / 3
    k = 1 / y
    for n in range(60, 3, -1):
        k = 1 / (y + n * k)
    return k


def fit_fraction_rest(m=5):
    """P / Q of degrees m and m + 1, both with leading coefficient 1, on y >= 0."""
    t = chebyshev(600) * 0.9999
    y = 2.5 * t / (1 - t)
    f = np.array([float(fraction_rest(v)) for v in y])
    columns = np.stack([y**i for i in range(m)] + [-f * y**j for j in range(m + 1)], axis=1)
    right = f * y ** (m + 1) - y**m

    def p(x):
        return np.append(x[:m], 1.0)

    def q(x):
        return np.append(x[m:], 1.0)

    def scale(x):
        return f * ((1 + y) ** (m + 1) if x is None else np.polyval(q(x)[::-1], y))

    worst, x = lawson(columns, right, scale,
                      lambda x: np.polyval(p(x)[::-1], y) / np.polyval(q(x)[::-1], y),
                      lambda got: np.abs(got / f - 1), 60, 6, lambda x: x.min() > 0)
    show("K3(y) = p / q", worst, p=p(x), q=q(x))


def visible_height(exponent):
    """Mean and variance of the density proportional to phi Phi^exponent."""
    low, high = (-12.0, 9.5) if exponent < 5 else (-7.0, 9.5)
    node, weight = leggauss(20)
    edges = np.linspace(low, high, 160)
    a, b = edges[:-1, None], edges[1:, None]
    x, w = (a + b) / 2 + (b - a) / 2 * node, (b - a) / 2 * weight
    density = np.exp(-x * x / 2 + exponent * log_ndtr(x)) * w
    total = density.sum()
    mean = (density * x).sum() / total
    return mean, (density * (x - mean) ** 2).sum() / total


def fit_visible_height():
    """mu(L) = u P / Q and nu(L) = P / Q in u = (1 + L)^(1/4) - 1, L in [0, 1e6]."""
    largest = (1 + 1e6) ** 0.25 - 1
    t = chebyshev(500)
    u = 3 * t / (1 - t * (1 - 3 / largest))
    u *= largest / u.max()
    mean, variance = np.array([visible_height((1 + v) ** 4 - 1) for v in u]).T
    for name, f, first in (("mu / u", mean / u, None), ("nu", variance, 1.0)):
        low = 0 if first is None else 1
        columns = np.stack([u**i for i in range(low, 6)] + [-f * u**j for j in range(1, 6)], axis=1)
        right = f - (first or 0.0)

        def p(x):
            return x[:6] if low == 0 else np.append(1.0, x[:5])

        def q(x):
            return np.append(1.0, x[6 - low:])

        def scale(x):
            return f * (1.0 if x is None else np.abs(np.polyval(q(x)[::-1], u)))

        worst, x = lawson(columns, right, scale,
                          lambda x: np.polyval(p(x)[::-1], u) / np.polyval(q(x)[::-1], u),
                          lambda got: np.abs(got / f - 1), 80, 6, lambda x: q(x).min() > 0)
        show(f"{name} = p / q", worst, p=p(x), q=q(x))


def fit_polynomial(name, f, x, degree):
    value = np.array([float(f(mp.mpf(v))) for v in x])
    columns = np.stack([x**i for i in range(degree + 1)], axis=1)
    worst, c = lawson(columns, value, lambda _: np.abs(value), lambda c: columns @ c,
                      lambda got: np.abs(got / value - 1), 60)
    show(name, worst, c=c)


def fit_erfc(per_x=0.5, degree=7):
    """exp(x^2) erfc(x) as t P(t), t = 1 / (1 + per_x x), x in [0, 60]; 1 at x = 0."""
    t = chebyshev(600)
    t = t * (1 - 1 / (1 + 60 * per_x)) + 1 / (1 + 60 * per_x)
    value = erfcx((1 / t - 1) / per_x)
    columns = np.stack([t**i - t**degree for i in range(1, degree)], axis=1)
    right = value - t**degree
    worst, c = lawson(columns, right, lambda _: value, lambda c: columns @ c + t**degree,
                      lambda got: np.abs(got / value - 1), 80)
    show(f"exp(x^2) erfc(x) / t, t = 1 / (1 + {per_x} x)", worst, c=np.append(c, 1 - c.sum()))


def fit_to_double(name, f, limit, terms):
    """f in x^2, |x| <= limit: near the minimax, with digits to spare; the highest power first."""
    c, worst = mp.chebyfit(lambda s: f(mp.sqrt(max(s, mp.mpf(10) ** -20))), [0, limit**2 * 1.0001],
                           terms, error=True)
    print(f"{name}: absolute error {mp.nstr(worst, 2)}")
    print("    c =", ", ".join(mp.nstr(n, 18) for n in c))


fit_fraction_rest()
fit_visible_height()
half = float(mp.log(2)) / 2 * 1.001
fit_polynomial("(exp(r) - 1 - r) / r^2", lambda r: (mp.exp(r) - 1 - r) / r**2,
               half * np.cos(np.pi * (np.arange(400) + 0.5) / 400), 4)
fit_to_double("(sin(x) / x - 1) / x^2", lambda x: (mp.sin(x) / x - 1) / x**2, mp.pi / 4, 6)
fit_to_double("(cos(x) - 1 + x^2 / 2) / x^4", lambda x: (mp.cos(x) - 1 + x**2 / 2) / x**4,
              mp.pi / 4, 6)
fit_to_double("(atan(x) / x - 1) / x^2", lambda x: (mp.atan(x) / x - 1) / x**2,
              mp.tan(mp.pi / 8), 11)


# --- scree_k0.h ---------------------------------------------------------------------------------


def fit_near(name, f, whole, degree, limit):
    """f in x^2, x in (0, limit], to an error relative to `whole`, the sum that it is a part of."""
    s = chebyshev(400) * limit**2 * 1.0001
    value, size = (np.array([float(g(mp.sqrt(mp.mpf(v)))) for v in s]) for g in (f, whole))
    columns = np.stack([s**i for i in range(degree + 1)], axis=1)
    worst, c = lawson(columns, value, lambda _: size, lambda c: columns @ c,
                      lambda got: np.abs((got - value) / size), 60)
    show(name, worst, c=c)


def fit_far(name, f, degree, limit):
    """P / Q in t = limit / x, x >= limit, Q with constant term 1."""
    t = chebyshev(400) * 1.0001
    value = np.array([float(f(limit / mp.mpf(v))) for v in t])
    columns = np.stack([t**i for i in range(degree + 1)] +
                       [-value * t**j for j in range(1, degree + 1)], axis=1)

    def parts(x):
        return np.polyval(x[degree::-1], t), np.polyval(np.append(1.0, x[degree + 1:])[::-1], t)

    def scale(x):
        return value * (1.0 if x is None else np.abs(parts(x)[1]))

    worst, x = lawson(columns, value, scale, lambda x: np.divide(*parts(x)),
                      lambda got: np.abs(got / value - 1), 80, 6, lambda x: parts(x)[1].min() > 0)
    show(name, worst, p=x[:degree + 1], q=np.append(1.0, x[degree + 1:]))


def disk(x):
    """(1 - x K1(x)) / x^2"""
    return (1 - x * mp.besselk(1, x)) / x**2


fit_polynomial("atanh(s) / s in s^2", lambda x: mp.atanh(mp.sqrt(x)) / mp.sqrt(x),
               chebyshev(400) * 0.0295, 3)
fit_near("(I0(x) - 1) / x^2 in x^2", lambda x: (mp.besseli(0, x) - 1) / x**2,
         lambda x: (mp.besseli(0, x) - 1) / x**2, 6, 4)
fit_near("I1(x) / x in x^2", lambda x: mp.besseli(1, x) / x, lambda x: mp.besseli(1, x) / x, 6, 4)
fit_near("K0(x) + ln(x / 2) I0(x) in x^2",
         lambda x: mp.besselk(0, x) + mp.log(x / 2) * mp.besseli(0, x),
         lambda x: mp.besselk(0, x), 5, 2)
fit_near("(1 - x K1(x)) / x^2 + ln(x / 2) I1(x) / x in x^2",
         lambda x: disk(x) + mp.log(x / 2) * mp.besseli(1, x) / x, disk, 5, 2)
fit_far("sqrt(x) exp(x) K0(x) in 2 / x",
        lambda x: mp.sqrt(x) * mp.exp(x) * mp.besselk(0, x), 3, 2)
fit_far("sqrt(x) exp(x) K1(x) in 2 / x",
        lambda x: mp.sqrt(x) * mp.exp(x) * mp.besselk(1, x), 3, 2)
for order in (0, 1):
    fit_far(f"sqrt(x) exp(-x) I{order}(x) in 4 / x",
            lambda x: mp.sqrt(x) * mp.exp(-x) * mp.besseli(order, x), 4, 4)


fit_erfc()
