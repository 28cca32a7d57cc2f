//! Checks of curves: construction, evaluation, derivatives.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::curve::{Basis, bernstein};
use casteljau::{CrossProduct, Curve, Point};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Curve::new", both!(new)),
    ("Curve::degree", both!(accessors)),
    ("Curve::control_points", both!(accessors)),
    ("Curve::start", both!(accessors)),
    ("Curve::end", both!(accessors)),
    ("Curve::line", both!(low_degrees)),
    ("Curve::quad", both!(low_degrees)),
    ("Curve::cubic", both!(low_degrees)),
    ("Curve::approx_eq", both!(approx_eq)),
    ("Curve::from_basis", both!(from_basis)),
    ("Curve::to_basis", both!(to_basis)),
    ("Curve::basis_matrix", basis_matrix),
    ("Curve::bernstein", bernstein_weights),
    ("Curve::interpolate", both!(interpolate)),
    ("Curve::eval", both!(eval)),
    ("Curve::eval_at", both!(eval_at)),
    ("Curve::sample", both!(sample)),
    ("Curve::sample_into", both!(sample_into)),
    ("Curve::derivative", both!(derivative)),
    ("Curve::derivative_at", both!(derivative_at)),
    ("Curve::tangent", both!(tangent)),
    ("Curve::normal", both!(normal)),
    ("Curve::curvature", both!(curvature)),
    ("Curve::torsion", both!(torsion)),
];

fn new<P: Space>(case: &Case) -> Checked {
    let points = points::<P>(case, "points");
    let curve = answer!(case, Curve::new(&points));
    ensure!(curve.control_points() == points, "other control points");
    Ok(())
}

fn accessors<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let (degree, points) = (
        call(case, || curve.degree())?,
        call(case, || curve.control_points().to_vec())?,
    );
    let (start, end) = (call(case, || curve.start())?, call(case, || curve.end())?);
    ensure!(
        points.len() == degree + 1,
        "{} points of degree {degree}",
        points.len()
    );
    ensure!(
        start == points[0] && end == points[degree],
        "the ends are no control points"
    );
    Ok(())
}

fn low_degrees<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let points = curve.control_points();
    let [p0, p1, p2, p3] = std::array::from_fn(|i| points[i % points.len()]);
    let result = call(case, || {
        [
            Curve::line(p0, p1),
            Curve::quad(p0, p1, p2),
            Curve::cubic(p0, p1, p2, p3),
        ]
    })?;
    for (n, curve) in (1..).zip(&result) {
        let same = Curve::new(&[p0, p1, p2, p3][..=n]);
        ensure!(same.as_ref() == Ok(curve), "another curve of degree {n}");
    }
    Ok(())
}

fn approx_eq<P: Space>(case: &Case) -> Checked {
    let (a, b) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let same = call(case, || a.approx_eq(&b, number(case, "tolerance")))?;
    ensure!(
        same == b.approx_eq(&a, number(case, "tolerance")),
        "not symmetric"
    );
    ensure!(a.approx_eq(&a, 0.0), "not equal to itself");
    Ok(())
}

fn from_basis<P: Space>(case: &Case) -> Checked {
    let points: [P; 4] = points(case, "points").try_into().expect("four points");
    let curve = answer!(
        case,
        Curve::from_basis(basis(case, "basis"), points),
        &["points"]
    );
    ensure!(curve.degree() == 3, "degree {}", curve.degree());
    Ok(())
}

fn to_basis<P: Space>(case: &Case) -> Checked {
    let (curve, basis) = (curve::<P>(case, "curve"), basis(case, "basis"));
    let points = answer!(case, curve.to_basis(basis), &["matrix", "basis"]);
    if let Basis::Matrix(_) = basis {
        return Ok(()); // An ill-conditioned matrix enlarges rounding errors without bound.
    }
    let back = Curve::from_basis(basis, points).map_err(|error| error.to_string())?;
    // The inverse matrices of the named bases have entries up to 6, the matrices themselves up to 3.
    let slack = 100.0 * slack(case.size(), 3);
    for t in parameters(4, 1.0) {
        let gap = distance(back.eval(t), curve.eval(t));
        ensure!(gap <= slack, "{gap:e} away from the curve at {t}");
    }
    Ok(())
}

fn basis_matrix(case: &Case) -> Checked {
    let matrix = call(case, || named_basis(word(case, "basis")).matrix())?;
    // Points on a line at 0, 1/3, 2/3, 1 are geometry points whose weights sum to 1 at every t, except for the
    // derivatives of the Hermite basis.
    let columns = if word(case, "basis") == "hermite" {
        2
    } else {
        4
    };
    for row in 0..4 {
        let sum: f64 = matrix[4 * row..4 * row + columns].iter().sum();
        let expected = if row == 3 { 1.0 } else { 0.0 };
        ensure!((sum - expected).abs() <= 1e-15, "row {row} sums to {sum}");
    }
    Ok(())
}

fn bernstein_weights(case: &Case) -> Checked {
    let (degree, t) = (count(case, "degree"), number(case, "t"));
    let weights = answer!(case, bernstein(degree, t), &["degree"]);
    ensure!(weights.len() == degree + 1, "{} weights", weights.len());
    let sum: f64 = weights.iter().sum();
    let size: f64 = weights.iter().map(|w| w.abs()).sum();
    ensure!(
        (sum - 1.0).abs() <= slack(size, degree),
        "the weights sum to {sum}"
    );
    Ok(())
}

fn interpolate<P: Space>(case: &Case) -> Checked {
    let (points, ts) = (points::<P>(case, "points"), optional_numbers(case, "ts"));
    let curve = answer!(case, Curve::interpolate(&points, ts), &["ts"]);
    let largest = curve
        .control_points()
        .iter()
        .map(|p| p.max_abs())
        .fold(0.0, f64::max);
    let slack = 64.0 * slack(largest, points.len());
    for (k, &t) in ts.unwrap_or_default().iter().enumerate() {
        let gap = distance(curve.eval(t), points[k]);
        ensure!(
            gap <= slack * growth(t, curve.degree()),
            "{gap:e} away from points[{k}]"
        );
    }
    ensure!(
        ts.is_some() || distance(curve.eval(1.0), points[points.len() - 1]) <= slack,
        "misses the last point"
    );
    Ok(())
}

fn eval<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let point = value!(case, curve.eval(t));
    let gap = distance(point, de_casteljau(curve.control_points(), t));
    let slack = slack(case.size(), curve.degree()) * growth(t, curve.degree());
    ensure!(
        gap <= slack,
        "{gap:e} away from de Casteljau's algorithm, more than {slack:e}"
    );
    ensure!(
        curve.eval(0.0) == curve.start() && curve.eval(1.0) == curve.end(),
        "the ends are not exact"
    );
    Ok(())
}

fn eval_at<P: Space>(case: &Case) -> Checked {
    let (curve, ts) = (curve::<P>(case, "curve"), numbers(case, "ts"));
    let points = value!(case, curve.eval_at(ts));
    ensure!(
        points.len() == ts.len(),
        "{} points for {} parameters",
        points.len(),
        ts.len()
    );
    for (&t, &point) in ts.iter().zip(&points) {
        let slack = slack(case.size(), curve.degree()) * growth(t, curve.degree());
        ensure!(
            distance(point, curve.eval(t)) <= slack,
            "differs from eval at {t}"
        );
    }
    Ok(())
}

fn sample<P: Space>(case: &Case) -> Checked {
    let (curve, segments) = (curve::<P>(case, "curve"), count(case, "segments"));
    let points = answer!(case, curve.sample(segments), &["segments"]);
    samples_are_points(case, &curve, &points, segments)
}

fn sample_into<P: Space>(case: &Case) -> Checked {
    let (curve, segments) = (curve::<P>(case, "curve"), count(case, "count"));
    let mut points = vec![P::default(); segments + 1];
    value!(case, curve.sample_into(&mut points));
    curve.sample_into(&mut []);
    samples_are_points(case, &curve, &points, segments.max(1))
}

fn samples_are_points<P: Space>(
    case: &Case,
    curve: &Curve<P>,
    points: &[P],
    segments: usize,
) -> Checked {
    let slack = slack(case.size(), curve.degree());
    for (k, &point) in points.iter().enumerate() {
        let gap = distance(point, curve.eval(real(k) / real(segments)));
        ensure!(gap <= slack, "sample {k} is {gap:e} away from eval");
    }
    ensure!(
        points[0] == curve.start(),
        "the first sample is not the start"
    );
    Ok(())
}

/// The control points of the derivative, by differences.
fn differences<P: Point>(points: &[P]) -> Vec<P> {
    let degree = real(points.len() - 1);
    points.windows(2).map(|w| (w[1] - w[0]) * degree).collect()
}

fn derivative<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let derivative = value!(case, curve.derivative());
    let expected = differences(curve.control_points());
    let slack = slack(case.size(), curve.degree()) * real(curve.degree());
    for (k, &p) in expected.iter().enumerate() {
        ensure!(
            distance(p, derivative.control_points()[k]) <= slack,
            "control point {k} is wrong"
        );
    }
    Ok(())
}

fn derivative_at<P: Space>(case: &Case) -> Checked {
    let (curve, t, k) = (
        curve::<P>(case, "curve"),
        number(case, "t"),
        count(case, "k"),
    );
    let vector = value!(case, curve.derivative_at(t, k));
    if k > curve.degree() {
        ensure!(vector == P::default(), "not zero beyond the degree");
        return Ok(());
    }
    let mut points = curve.control_points().to_vec();
    let mut size = case.size();
    for order in 0..k {
        points = differences(&points);
        size *= 2.0 * real(curve.degree() - order);
    }
    let gap = distance(vector, de_casteljau(&points, t));
    let slack = 4.0 * slack(size, curve.degree()) * growth(t, curve.degree());
    ensure!(
        gap <= slack,
        "{gap:e} away from the differences, more than {slack:e}"
    );
    Ok(())
}

/// Checks that a direction is a unit vector or zero.
fn unit_or_zero<P: Space>(direction: P) -> Checked {
    let length = direction.length();
    ensure!(
        length == 0.0 || (length - 1.0).abs() <= 1e-12,
        "the length is {length}"
    );
    Ok(())
}

fn tangent<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let tangent = call(case, || curve.tangent(t))?;
    unit_or_zero(tangent)?;
    if case.mode == Mode::Extreme {
        return Ok(());
    }
    let derivative = curve.derivative_at(t, 1);
    let rounding =
        slack(case.size(), curve.degree()) * real(curve.degree()) * growth(t, curve.degree());
    // The angle between the two vectors is at most the rounding error of B′ divided by its length.
    let across = distance(derivative, tangent * derivative.length());
    ensure!(
        derivative.length() <= 1e3 * rounding || across <= 4.0 * rounding,
        "{across:e} off the derivative's direction"
    );
    Ok(())
}

fn normal<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let normal = call(case, || curve.normal(t))?;
    unit_or_zero(normal)?;
    let along = normal.dot(curve.tangent(t));
    ensure!(
        along.abs() <= 1e-9,
        "the normal leans to the tangent by {along:e}"
    );
    Ok(())
}

fn curvature<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let curvature = call_unbounded(case, || curve.curvature(t))?;
    ensure!(
        P::DIMENSION == 2 || curvature >= 0.0,
        "{curvature} in space"
    );
    ensure!(
        curve.degree() > 1 || curvature == 0.0,
        "{curvature} of a line"
    );
    if case.mode == Mode::Extreme {
        return Ok(());
    }
    let (first, second) = (curve.derivative_at(t, 1), curve.derivative_at(t, 2));
    let (speed, size) = (first.length(), case.size() * growth(t, curve.degree()));
    // Far from a cusp the formula is accurate; elsewhere rounding decides.
    if speed > 1e-3 * size {
        let expected = first.cross(second).size() / speed.powi(3);
        let slack = 1e-6 * expected + curvature_rounding(&curve, size, speed, second.length());
        ensure!(
            (curvature.abs() - expected).abs() <= slack,
            "{curvature} instead of {expected}"
        );
    }
    Ok(())
}

/// The effect of rounding on B′ × B″ / |B′|³. The error of the k-th derivative is the error of points times 2ᵏ n!/(n −
/// k)!. In space B″ counts as parallel to B′ below an angle of 1e-13 between the vectors without the factors n and n (n
/// − 1).
fn curvature_rounding<P: Space>(curve: &Curve<P>, size: f64, speed: f64, bend: f64) -> f64 {
    let n = real(curve.degree());
    let slack = slack(size, curve.degree());
    let (first, second) = (2.0 * n * slack, 4.0 * n * (n - 1.0) * slack);
    (first / speed * bend + second + 1e-13 * bend) / (speed * speed)
}

fn torsion<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let torsion = call_unbounded(case, || curve.torsion(t))?;
    ensure!(
        (P::DIMENSION == 3 && curve.degree() > 2) || torsion == 0.0,
        "{torsion} of a plane curve"
    );
    Ok(())
}
