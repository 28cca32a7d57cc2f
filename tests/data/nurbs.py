"""Writes nurbs.json: figures on rational and NURBS curves from geomdl and mpmath.

    python3 -m venv VENV && VENV/bin/pip install geomdl==5.4.0 mpmath==1.4.1
    VENV/bin/python tests/data/nurbs.py

`curves` are figures of geomdl. Each is compared with an evaluation of the same input by the Cox-de Boor recursion at
50 digits; the script stops if one is farther away than TOLERANCE times the size of the figure. A result that is a curve
(knot insertion, elevation and so on) is compared with the given curve at parameters of its own.
`facts` are figures of mpmath alone: closed forms, quadrature at 40 digits, and roots of polynomials.
Inputs are the doubles of the file, taken as exact numbers.
"""

import json
from importlib.metadata import version
from itertools import pairwise, zip_longest
from pathlib import Path

import mpmath as mp
from geomdl import NURBS, fitting, operations

mp.mp.dps = 50
TOLERANCE = 1e-13


class Curve(NURBS.Curve):
    """geomdl's curve with the knots as given; geomdl maps them to [0, 1] otherwise, also those of pieces."""

    def __init__(self, **options):
        super().__init__(**{**options, "normalize_kv": False})


def curve_of(degree, points, weights, knots):
    curve = Curve()
    curve.degree = degree
    curve.set_ctrlpts([[*(x * w for x in p), w] for p, w in zip(points, weights)])
    curve.knotvector = knots
    return curve


def record(curve):
    """Points, weights and knots of a curve of geomdl."""
    homogeneous = [list(p) for p in curve.ctrlptsw]
    return {
        "degree": curve.degree,
        "points": [[x / p[-1] for x in p[:-1]] for p in homogeneous],
        "weights": [p[-1] for p in homogeneous],
        "knots": list(curve.knotvector),
    }


# Evaluation at 50 digits


def span_of(knots, degree, count, t):
    """The last non-empty knot span that starts at or before t; at the end of the domain the last one."""
    return max(i for i in range(degree, count) if knots[i] < knots[i + 1] and (knots[i] <= t or i == degree))


def basis(knots, degree, i, t, span):
    """N_{i,degree}(t) of the Cox-de Boor recursion, as the polynomial of a knot span."""
    if degree == 0:
        return mp.mpf(i == span)
    value = mp.mpf(0)
    if knots[i + degree] > knots[i]:
        value += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, degree - 1, i, t, span)
    if knots[i + degree + 1] > knots[i + 1]:
        remaining = (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1])
        value += remaining * basis(knots, degree - 1, i + 1, t, span)
    return value


def homogeneous_derivatives(degree, points, weights, knots, t, order):
    """The derivatives of (w x, w y, …, w) at t, by differences of control points."""
    rows = [[*(mp.mpf(x) * mp.mpf(w) for x in p), mp.mpf(w)] for p, w in zip(points, weights)]
    knots, t = [mp.mpf(k) for k in knots], mp.mpf(t)
    span = span_of(knots, degree, len(points), t)
    results = []
    for k in range(order + 1):
        if degree < 0:
            results.append([mp.mpf(0)] * len(rows[0]))
            continue
        values = [basis(knots, degree, i, t, span - k) for i in range(len(rows))]
        results.append([mp.fsum(v * row[axis] for v, row in zip(values, rows)) for axis in range(len(points[0]) + 1)])
        if degree > 0:
            width = [knots[i + degree + 1] - knots[i + 1] for i in range(len(rows) - 1)]
            rows = [
                [degree * (b - a) / width[i] if width[i] else mp.mpf(0) for a, b in zip(rows[i], rows[i + 1])]
                for i in range(len(rows) - 1)
            ]
            knots = knots[1:-1]
        degree -= 1
    return results


def derivatives(data, t, order=2):
    """Point, first and second derivative at t, by the quotient rule."""
    rows = homogeneous_derivatives(data["degree"], data["points"], data["weights"], data["knots"], t, order)
    results = []
    for k, row in enumerate(rows):
        value = row[:-1]
        for i in range(1, k + 1):
            value = [v - mp.binomial(k, i) * rows[i][-1] * r for v, r in zip(value, results[k - i])]
        results.append([v / rows[0][-1] for v in value])
    return results


worst = {}


def assert_near(what, values, exact):
    size = max(1, *(abs(e) for e in exact))
    error = max(abs(mp.mpf(v) - e) for v, e in zip(values, exact, strict=True)) / size
    kind = what.split(":")[0]
    worst[kind] = max(worst.get(kind, 0), float(error))
    if error > TOLERANCE:
        raise ValueError(f"{what}: geomdl has {values}, exact is {[mp.nstr(e, 17) for e in exact]}")


def assert_same_curve(what, result, data):
    """Throws unless a result has the points and the weight function of the given curve on its own domain."""
    p, n = result["degree"], len(result["points"])
    start, end = result["knots"][p], result["knots"][n]
    for k in range(12):
        t = start + (end - start) * (0.03 + 0.085 * k)
        assert_near(f"{what} at {t}", derivatives(result, t, 0)[0], derivatives(data, t, 0)[0])
        weight, expected = (homogeneous_derivatives(**c, t=t, order=0)[0][-1] for c in (result, data))
        assert_near(f"{what} at {t}", [weight / expected], [mp.mpf(1)])


def elevate(data):
    """The curve as one of the next degree, by interpolation at the Greville parameters of the new knots."""
    degree, count = data["degree"] + 1, len(data["points"]) + len(set(data["knots"])) - 1
    knots = sorted([*data["knots"], *set(data["knots"])])
    exact = [mp.mpf(k) for k in knots]
    greville = [mp.fsum(exact[i + 1 : i + degree + 1]) / degree for i in range(count)]
    spans = [span_of(exact, degree, count, t) for t in greville]
    matrix = mp.matrix([[basis(exact, degree, i, t, s) for i in range(count)] for t, s in zip(greville, spans)])
    given = (data["degree"], data["points"], data["weights"], data["knots"])
    values = [homogeneous_derivatives(*given, t, 0)[0] for t in greville]
    columns = [mp.lu_solve(matrix, mp.matrix([v[axis] for v in values])) for axis in range(len(values[0]))]
    *coordinates, weights = columns
    return {
        "degree": degree,
        "points": [[float(c[i] / weights[i]) for c in coordinates] for i in range(count)],
        "weights": [float(w) for w in weights],
        "knots": knots,
    }


# Curves of geomdl


def domain(data):
    return data["knots"][data["degree"]], data["knots"][len(data["points"])]


def parameters(data):
    """The ends, the inner knots and irregular parameters, about 20 in all."""
    start, end = domain(data)
    inner = sorted({k for k in data["knots"] if start < k < end})
    others = [start + (end - start) * f for f in (k / 17 + 0.011 for k in range(17))]
    return sorted({start, end, *inner, *others})


def multiplicity(data, t):
    return data["knots"].count(t)


def curve_record(id, source, degree, points, weights, knots, insert=(), refine=False, split=None):
    data = {"degree": degree, "points": points, "weights": weights, "knots": knots}
    result = {"id": id, "source": source, **data, "samples": []}
    make = lambda: curve_of(**data)
    curve = make()
    for t in parameters(data):
        values = [list(v) for v in curve.derivatives(t, 2)]
        exact = derivatives(data, t)
        for name, value, e in zip(("point", "first", "second"), values, exact):
            assert_near(f"{name}: {id} at {t}", value, e)
        result["samples"].append({"t": t, "point": values[0], "first": values[1], "second": values[2]})

    if knots[0] < knots[degree]:  # geomdl 5.4.0 changes only curves with clamped knots
        return result

    result["insert"] = []
    for t, times in insert:
        inserted = record(operations.insert_knot(make(), [t], [times]))
        assert_same_curve(f"insert: {id}", inserted, data)
        result["insert"].append({"t": t, "times": times, "curve": inserted})
    if refine:  # the middle of each span, and the inner knots, to the multiplicity of the degree
        refined = record(operations.refine_knotvector(make(), [1]))
        assert_same_curve(f"refine: {id}", refined, data)
        added = list(refined["knots"])
        for k in knots:
            added.remove(k)
        result["refine"] = {"ts": added, "curve": refined}
    if split is not None:
        pieces = [record(piece) for piece in operations.split_curve(make(), split)]
        for piece in pieces:
            assert_same_curve(f"split: {id}", piece, data)
        result["split"] = {"t": split, "curves": pieces}
    segments = [record(piece) for piece in operations.decompose_curve(make())]
    for segment in segments:
        assert_same_curve(f"segments: {id}", segment, data)
    result["segments"] = segments
    result["elevate"] = elevate(data)
    assert_same_curve(f"elevate: {id}", result["elevate"], data)
    if len(segments) == 1:  # geomdl 5.4.0 elevates Bézier curves; with inner knots it throws or returns another curve
        by_geomdl = record(operations.degree_operations(make(), [1]))
        for key in ("points", "weights"):
            for value, e in zip(by_geomdl[key], result["elevate"][key], strict=True):
                assert_near(f"elevate: {id}", *([x] if key == "weights" else x for x in (value, e)))
    return result


def curves():
    half = 0.5**0.5
    wave = [[0, 0], [1, 3], [3, 4], [5, 1], [6, -2], [9, 0]]
    wave_3d = [[0, 0, 1], [1, 3, 0], [3, 4, -1], [5, 1, 2], [6, -2, 2.5], [9, 0, 0.5]]
    uneven = [0.5, 1, 0.75, 1, 0.25, 1]
    uniform = [0, 0, 0, 0, 1, 2, 3, 3, 3, 3]
    circle = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]
    circle_knots = [0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1]
    eight = [[0, 0], [1, 2], [2, 3], [4, 3], [5, 0], [7, -1], [8, 2], [10, 1]]
    results = [
        curve_record(
            "nurbs-book-4.1",
            "Piegl and Tiller, The NURBS Book, example 4.1",
            2,
            [[0, 0], [1, 1], [3, 2], [4, 1], [5, -1]],
            [1, 4, 1, 1, 1],
            [0, 0, 0, 1, 2, 3, 3, 3],
            insert=[(0.5, 1), (1, 1), (2.5, 2)],
            refine=True,
            split=1.25,
        ),
        curve_record(
            "nurbs-book-4.2",
            "The NURBS Book, example 4.2: a quarter of a circle with weights 1, 1, 2",
            2,
            [[1, 0], [1, 1], [0, 1]],
            [1, 1, 2],
            [0, 0, 0, 1, 1, 1],
            insert=[(0.5, 1), (0.3, 2)],
            refine=True,
            split=0.4,
        ),
        curve_record(
            "nurbs-book-2.3",
            "The NURBS Book, knots of example 2.3",
            2,
            eight,
            [1, 2, 0.5, 1, 3, 1, 0.25, 1],
            [0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5],
            insert=[(2.5, 1), (3, 1)],
            refine=True,
            split=2.25,
        ),
        curve_record(
            "nurbs-book-5.1",
            "The NURBS Book, knots of example 5.1",
            3,
            eight,
            [1, 2, 0.5, 1, 3, 1, 0.25, 1],
            [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5],
            insert=[(2.5, 1), (2, 2), (0.75, 3)],
            refine=True,
            split=2.5,
        ),
        curve_record(
            "circle-9",
            "the unit circle of nine points",
            2,
            circle,
            [1, half, 1, half, 1, half, 1, half, 1],
            circle_knots,
            insert=[(0.1, 1), (0.6, 2)],
            refine=True,
            split=0.3,
        ),
        curve_record(
            "circle-9-space",
            "a circle of radius 2 in the plane z = x / 2 + 3, stretched by the slope",
            2,
            [[2 * x, 2 * y, x + 3] for x, y in circle],
            [1, half, 1, half, 1, half, 1, half, 1],
            circle_knots,
            insert=[(0.1, 1)],
            refine=True,
            split=0.5,
        ),
        curve_record(
            "uneven-weights",
            "degree 3, clamped uniform knots",
            3,
            wave,
            uneven,
            uniform,
            insert=[(0.5, 1), (1, 2), (2.25, 3)],
            refine=True,
            split=1.7,
        ),
        curve_record(
            "uneven-weights-space",
            "the same in space",
            3,
            wave_3d,
            uneven,
            uniform,
            insert=[(0.5, 1), (1, 2)],
            refine=True,
            split=2,
        ),
        curve_record(
            "wide-weights",
            "weights from 1e-3 to 1e3",
            3,
            wave,
            [1, 1e3, 1e-3, 1, 1e-2, 10],
            uniform,
            insert=[(0.5, 1), (1, 1)],
            refine=True,
            split=1.5,
        ),
        curve_record(
            "double-knot",
            "degree 4 in space, a double knot, a domain that starts below 0",
            4,
            [*wave_3d, [10, 2, 1], [11, 1, 3]],
            [*uneven, 2, 1.5],
            [-1.5, -1.5, -1.5, -1.5, -1.5, -0.25, 1, 1, 2.5, 2.5, 2.5, 2.5, 2.5],
            insert=[(0.5, 1), (1, 1), (-0.25, 2)],
            refine=True,
            split=0.125,
        ),
        curve_record(
            "degree-1",
            "a polyline with weights: the shape of a polyline at other parameters",
            1,
            wave[:4],
            [1, 3, 0.5, 2],
            [0, 0, 1, 2.5, 4, 4],
            insert=[(0.5, 1), (3, 1)],
            refine=True,
            split=1.5,
        ),
        curve_record(
            "polynomial",
            "all weights 1",
            3,
            wave,
            [1] * 6,
            uniform,
            insert=[(0.5, 1)],
            refine=True,
            split=1.5,
        ),
        curve_record("unclamped", "uniform knots", 3, wave, uneven, list(range(10))),
        curve_record(
            "closed",
            "a closed curve of five points and uneven knots, with three points repeated at the end",
            3,
            [*wave[:5], *wave[:3]],
            [*uneven[:5], *uneven[:3]],
            [-4, -3, -1.5, 0, 1, 3, 4, 5.5, 7, 8, 10, 11],
        ),
    ]
    # The results that the book prints.
    sample = lambda k, t: next(s for s in results[k]["samples"] if s["t"] == t)
    assert_near("point: book", sample(0, 1)["point"], [mp.mpf(7) / 5, mp.mpf(6) / 5])
    assert_near("first: book", [*sample(1, 0)["first"], *sample(1, 1)["first"]], [0, 2, -1, 0])
    return results


def interpolations():
    """Global interpolation with the knots of averaged parameters (The NURBS Book, section 9.2.1)."""
    book = [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3]]  # example 9.1: the inner knot is 28/51
    space = [[0, 0, 0], [1, 2, 1], [3, 2, 4], [4, -1, 2], [7, 0, 0], [8, 3, -2], [9, 3, -2.5]]
    results = []
    for points, degree, centripetal in (
        (book, 3, False),
        (book, 2, True),
        (space, 3, False),
        (space, 3, True),
        (space, 5, True),
    ):
        curve = fitting.interpolate_curve(points, degree, centripetal=centripetal)
        steps = [
            mp.norm([mp.mpf(b) - a for a, b in zip(p, q)]) ** (0.5 if centripetal else 1) for p, q in pairwise(points)
        ]
        times = [mp.fsum(steps[:k]) / mp.fsum(steps) for k in range(len(points))]
        data = {
            "degree": degree,
            "points": curve.ctrlpts,
            "weights": [1] * len(points),
            "knots": list(curve.knotvector),
        }
        for t, point in zip(times, points):
            assert_near("interpolate:", derivatives(data, t, 0)[0], [mp.mpf(x) for x in point])
        parameters = "centripetal" if centripetal else "chord-length"
        results.append({"through": points, "parameters": parameters, "times": [float(t) for t in times], "curve": data})
    assert abs(results[0]["curve"]["knots"][4] - 28 / 51) < 1e-15
    return results


# Facts of mpmath


class Polynomial:
    """The coefficients of the powers of t, lowest first."""

    @staticmethod
    def from_bernstein(values):
        n = len(values) - 1
        differences, row = [], [mp.mpf(v) for v in values]
        for k in range(n + 1):
            differences.append(mp.binomial(n, k) * row[0])
            row = [b - a for a, b in pairwise(row)]
        return Polynomial(differences)

    def __init__(self, coefficients):
        self.coefficients = coefficients

    def __call__(self, t):
        return mp.polyval(self.coefficients[::-1], t)

    def __add__(self, other):
        return Polynomial([a + b for a, b in zip_longest(self.coefficients, other.coefficients, fillvalue=mp.mpf(0))])

    def __mul__(self, other):
        if not isinstance(other, Polynomial):
            return Polynomial([c * other for c in self.coefficients])
        product = [mp.mpf(0)] * (len(self.coefficients) + len(other.coefficients) - 1)
        for i, a in enumerate(self.coefficients):
            for j, b in enumerate(other.coefficients):
                product[i + j] += a * b
        return Polynomial(product)

    def __sub__(self, other):
        return self + other * mp.mpf(-1)

    def derivative(self):
        return Polynomial([k * c for k, c in enumerate(self.coefficients)][1:] or [mp.mpf(0)])

    def roots(self):
        """The real roots between 0 and 1, without the ends."""
        size = max(abs(c) for c in self.coefficients)
        coefficients = list(self.coefficients)
        while coefficients and abs(coefficients[-1]) <= size * mp.mpf(10) ** -40:
            coefficients.pop()
        if len(coefficients) < 2:
            return []
        roots = mp.polyroots(coefficients[::-1], maxsteps=500, extraprec=400)
        return sorted(mp.re(r) for r in roots if abs(mp.im(r)) < 1e-30 and 1e-30 < mp.re(r) < 1 - mp.mpf(1e-30))


def integral(f, start, end):
    """By Gauss rules, with parts halved until two rules agree to 32 digits."""
    value, error = mp.quad(f, [start, end], method="gauss-legendre", maxdegree=5, error=True)
    if error < mp.mpf(10) ** -32 or abs(end - start) < mp.mpf(10) ** -12:
        return value
    middle = (start + end) / 2
    return integral(f, start, middle) + integral(f, middle, end)


class Rational:
    """A rational Bézier curve at 50 digits."""

    def __init__(self, points, weights):
        self.w = Polynomial.from_bernstein(weights)
        axes = range(len(points[0]))
        self.axes = [
            Polynomial.from_bernstein([mp.mpf(p[k]) * mp.mpf(w) for p, w in zip(points, weights)]) for k in axes
        ]

    def eval(self, t):
        return [a(t) / self.w(t) for a in self.axes]

    def velocities(self):
        """The numerators of the derivatives: w a' - w' a."""
        return [self.w * a.derivative() - self.w.derivative() * a for a in self.axes]

    def derivative(self, t):
        return [v(t) / self.w(t) ** 2 for v in self.velocities()]

    def speed(self, t):
        return mp.norm([v(t) for v in self.velocities()]) / self.w(t) ** 2

    def length(self, start=0, end=1):
        velocities = self.velocities()
        return integral(lambda t: mp.norm([v(t) for v in velocities]) / self.w(t) ** 2, mp.mpf(start), mp.mpf(end))

    def time_at_length(self, length):
        """By Newton's method, kept in an interval that has the solution."""
        low, high, t, reached = mp.mpf(0), mp.mpf(1), mp.mpf(0.5), self.length(0, 0.5)
        for _ in range(200):
            low, high = (low, t) if reached > length else (t, high)
            step = t - (reached - length) / self.speed(t)
            after = step if low < step < high else (low + high) / 2
            reached += self.length(t, after)
            if abs(after - t) < mp.mpf(10) ** -25:
                return after
            t = after
        raise ValueError("Newton's method does not converge")

    def area(self):
        """Half the integral of x dy - y dx."""
        (x, y), (dx, dy) = self.axes, self.velocities()
        return integral(lambda t: (x(t) * dy(t) - y(t) * dx(t)) / self.w(t) ** 3, mp.mpf(0), mp.mpf(1)) / 2

    def extrema(self):
        return [v.roots() for v in self.velocities()]

    def determinant(self):
        """det(A, A', A'') of the homogeneous curve in the plane."""
        rows = [*self.axes, self.w]
        first = [r.derivative() for r in rows]
        second = [r.derivative() for r in first]
        minor = lambda i, j: first[i] * second[j] - first[j] * second[i]
        return rows[0] * minor(1, 2) - rows[1] * minor(0, 2) + rows[2] * minor(0, 1)

    def nearest(self, point):
        offsets = [a - self.w * mp.mpf(p) for a, p in zip(self.axes, point)]
        product = sum((o * v for o, v in zip(offsets, self.velocities())), Polynomial([mp.mpf(0)]))
        distance = lambda t: mp.norm([x - p for x, p in zip(self.eval(t), point)])
        return min([mp.mpf(0), *product.roots(), mp.mpf(1)], key=distance), distance

    def curvature(self, t):
        speed = mp.norm([v(t) for v in self.velocities()])
        return self.w(t) ** 3 * self.determinant()(t) / speed**3


def numbers(value):
    """Doubles in the place of mpmath's numbers."""
    if isinstance(value, dict):
        return {k: numbers(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [numbers(v) for v in value]
    return float(value) if isinstance(value, mp.mpf) else value


def fact(id, kind, source, input, expect, tol):
    return {"id": id, "kind": kind, "source": source, "input": input, "expect": numbers(expect), "tol": tol}


def perimeter(a, b):
    """Of an ellipse, by the arithmetic-geometric mean: 2π (a² - Σ 2ⁿ⁻¹ cₙ²) / M(a, b)."""
    a, b = mp.mpf(a), mp.mpf(b)
    total, power = a * a, mp.mpf(1) / 2
    c = mp.sqrt(a * a - b * b)
    while abs(c) > mp.mpf(10) ** -48 * a:
        total -= power * c * c
        a, b, c, power = (a + b) / 2, mp.sqrt(a * b), (a - b) / 2, 2 * power
    return 2 * mp.pi * total / a


def de_casteljau(points, weights, t):
    """Both parts of a rational curve at t: points and weights."""
    row = [[*(mp.mpf(x) * mp.mpf(w) for x in p), mp.mpf(w)] for p, w in zip(points, weights)]
    left, right = [row[0]], [row[-1]]
    while len(row) > 1:
        row = [[(1 - t) * x + t * y for x, y in zip(p, q)] for p, q in pairwise(row)]
        left.append(row[0])
        right.append(row[-1])
    part = lambda rows: {"points": [[x / r[-1] for x in r[:-1]] for r in rows], "weights": [r[-1] for r in rows]}
    return part(left), part(right[::-1])


def facts():
    results = []
    add = lambda *args: results.append(fact(*args))
    for a, b in ((1, 1), (2, 1), (10, 1), (100, 1), (3, 2.5)):
        exact = perimeter(a, b)
        assert abs(exact - 4 * a * mp.ellipe(1 - mp.mpf(b) ** 2 / mp.mpf(a) ** 2)) < 1e-40
        add(f"perimeter-{a}-{b}", "perimeter", "the arithmetic-geometric mean", {"rx": a, "ry": b}, exact, 1e-9 * a)

    curves = {f"conic-{w:g}": ([[0, 0], [1, 2], [3, 0.5]], [1, w, 1]) for w in (0.001, 0.1, 0.5, 1, 2, 10, 1000)}
    cubic = [[0, 0], [1, 3], [4, -2], [5, 1]]
    curves |= {
        "quarter-circle": ([[1, 0], [1, 1], [0, 1]], [1, 1, 2]),
        "cubic": (cubic, [1, 2, 0.5, 1]),
        "cubic-wide": (cubic, [1, 1e3, 1e-3, 10]),
        "cubic-loop": ([[0, 0], [6, 4], [-2, 4], [4, 0]], [1, 3, 0.5, 2]),
        "cubic-space": ([[0, 0, 1], [1, 3, 0], [4, -2, 2], [5, 1, -1]], [1, 2, 0.5, 1]),
        "quintic": ([[0, 0], [1, 4], [3, -3], [5, 5], [6, -2], [8, 1]], [1, 0.5, 2, 0.25, 3, 1]),
    }
    for name, (points, weights) in curves.items():
        input = {"points": points, "weights": weights}
        curve = Rational(points, weights)
        plane = len(points[0]) == 2
        axes = "xyz"[: len(points[0])]
        whole = curve.length()
        add(f"length-{name}", "length", "quadrature", input, whole, 1e-12 * float(whole))
        quarter = float(whole / 4)
        add(
            f"time-at-length-{name}",
            "time_at_length",
            "quadrature and Newton's method",
            {**input, "length": quarter},
            curve.time_at_length(quarter),
            1e-12,
        )
        extrema = curve.extrema()
        add(f"extrema-{name}", "extrema", "roots of w a' - w' a", input, dict(zip(axes, extrema)), 1e-11)
        coordinates = [[curve.eval(t)[k] for t in (0, *roots, 1)] for k, roots in enumerate(extrema)]
        add(
            f"bounds-{name}",
            "bounds",
            "the same roots",
            input,
            {"min": [min(c) for c in coordinates], "max": [max(c) for c in coordinates]},
            1e-13,
        )
        queries = [[2, 1], [0.5, -1], [3, 3], [-1, 0.25]]
        for k, query in enumerate(queries):
            query = query if plane else [*query, 0.5]
            t, distance = curve.nearest(query)
            add(
                f"nearest-{name}-{k}",
                "nearest",
                "roots of (A - w P) · (w A' - w' A)",
                {**input, "point": query},
                {"t": t, "point": curve.eval(t), "distance": distance(t)},
                1e-11,
            )
        if plane:
            add(f"area-{name}", "area", "quadrature", input, curve.area(), 1e-12)
            for t in (0, 0.25, 0.5, 0.9, 1):
                value = curve.curvature(mp.mpf(t))
                add(
                    f"curvature-{name}-{t}",
                    "curvature",
                    "w³ det(A, A', A'') / |w A' - w' A|³",
                    {**input, "t": t},
                    value,
                    1e-11 * abs(float(value)),
                )
            if len(points) > 3:
                add(
                    f"inflections-{name}",
                    "inflections",
                    "roots of det(A, A', A'')",
                    input,
                    curve.determinant().roots(),
                    1e-11,
                )
        for t in (0.25, 0.7):
            left, right = de_casteljau(points, weights, mp.mpf(t))
            add(
                f"split-{name}-{t}",
                "split",
                "de Casteljau's algorithm",
                {**input, "t": t},
                {"left": left, "right": right},
                1e-12,
            )
        n = len(weights) - 1
        ratio = (mp.mpf(weights[0]) / weights[-1]) ** (mp.mpf(1) / n)
        standard = [mp.mpf(w) * ratio**i / weights[0] for i, w in enumerate(weights)]
        add(
            f"standard-form-{name}",
            "standard_form",
            "w_i (w_0 / w_n)^(i / n) / w_0",
            input,
            standard,
            1e-14 * float(max(standard)),
        )

    # Every homogeneous coordinate is apolar to the cubic whose roots are the inflections.
    for roots, points, weights in (
        ([0.25, 0.75, 3], [[0, 0], [0, 1], [3, 1], [-4, 0.5]], [0.375, 0.75, 0.25, 0.5]),
        ([0.25, 0.5, 4], [[0, 0], [0, 1], [2, -2], [-3.25, 3.25]], [1.75, 0.25, 0.75, 1.5]),
        ([0.375, 2, -1], [[0, 0], [0, 3], [2, 1], [1.25, 3]], [0.25, 0.25, 0.75, 1]),
    ):
        determinant = Rational(points, weights).determinant()
        inside = [r for r in roots if 0 < r < 1]
        found = determinant.roots()
        assert all(abs(a - b) < 1e-30 for a, b in zip(found, inside, strict=True)), found
        assert all(abs(determinant(mp.mpf(r))) < 1e-40 for r in roots)
        name = "-".join(f"{r:g}" for r in inside)
        add(
            f"inflections-known-{name}",
            "inflections",
            "det(A, A', A'') has known roots",
            {"points": points, "weights": weights},
            inside,
            1e-13,
        )

    def add_crossings(id, source, a, b, parameters, tol):
        crossings = []
        for t, s in parameters:
            point = Rational(**a).eval(t)
            assert mp.norm([p - q for p, q in zip(point, Rational(**b).eval(s), strict=True)]) < 1e-40, id
            crossings.append({"t": t, "s": s, "point": point})
        add(id, "intersections", source, {"a": a, "b": b}, crossings, tol)

    quarter = {"points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]}  # x = (1 - t²) / (1 + t²), y = 2 t / (1 + t²)
    shifted = {
        "points": [[0, 0], [0, 1], [1, 1]],
        "weights": [2, 1, 1],
    }  # about (1, 0): 1 - x and y are those at 1 - t, exchanged
    line = lambda *points: {"points": points, "weights": [1, 1]}
    root2, root3 = mp.sqrt(2), mp.sqrt(3)
    add_crossings("line-quarter-circle", "x² + y² = 1", quarter, line([0, 0], [2, 2]), [(root2 - 1, root2 / 4)], 1e-13)
    add_crossings(
        "chord-quarter-circle",
        "x² + y² = 1",
        quarter,
        line([1.25, -0.25], [-0.25, 1.25]),
        [(mp.mpf(0), mp.mpf(1) / 6), (mp.mpf(1), mp.mpf(5) / 6)],
        1e-13,
    )
    add_crossings("two-quarter-circles", "they meet at (1/2, √3/2)", quarter, shifted, [(1 / root3, root3 - 1)], 1e-13)
    cubic = {"points": [[0, 0.5], [0.5, 1.5], [0.75, -0.5], [1.25, 1]], "weights": [1, 1, 1, 1]}
    curve = Rational(**cubic)
    x, y = curve.axes
    crossings = [(curve.eval(s), s) for s in (x * x + y * y - curve.w * curve.w).roots()]
    add_crossings(
        "cubic-quarter-circle",
        "roots of x² + y² - 1",
        quarter,
        cubic,
        sorted((y / (1 + x), s) for (x, y), s in crossings if x >= 0 and y >= 0),
        1e-12,
    )
    return results


def lines(content):
    """JSON with a line for each fact, each sample and each property of a curve."""
    dump = lambda value: json.dumps(value, ensure_ascii=False)
    array = lambda items: "[\n" + ",\n".join(items) + "\n]"
    pairs = lambda record: ",\n".join(
        f"{dump(k)}: {array(map(dump, v)) if k == 'samples' else dump(v)}" for k, v in record.items()
    )
    sections = {
        "meta": "{\n" + pairs(content["meta"]) + "\n}",
        "curves": array("{\n" + pairs(curve) + "\n}" for curve in content["curves"]),
        "interpolations": array(map(dump, content["interpolations"])),
        "facts": array(map(dump, content["facts"])),
    }
    return "{\n" + ",\n".join(f"{dump(k)}: {v}" for k, v in sections.items()) + "\n}\n"


def main():
    content = {
        "meta": {
            "script": "tests/data/nurbs.py",
            "versions": {name: version(name) for name in ("geomdl", "mpmath")},
            "conventions": "Knots: points + degree + 1. Derivatives at an inner knot are those of the span after it, at the end "
            "those of the span before it. Of split curves and segments the weights are determined up to a common factor.",
        },
        "curves": curves(),
        "interpolations": interpolations(),
        "facts": facts(),
    }
    content["meta"]["largest_errors"] = dict(sorted(worst.items()))
    Path(__file__).with_name("nurbs.json").write_text(lines(content), encoding="utf-8")
    print(f"{len(content['curves'])} curves, {len(content['facts'])} facts; largest errors of geomdl:")
    for kind, error in sorted(worst.items()):
        print(f"  {kind:12} {error:.1e}")


if __name__ == "__main__":
    main()
