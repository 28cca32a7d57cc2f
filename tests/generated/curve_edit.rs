//! Checks of curves: subdivision, other forms of the same curve, drawing.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::Curve;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Curve::split", both!(split)),
    ("Curve::halve", both!(halve)),
    ("Curve::subsegment", both!(subsegment)),
    ("Curve::reverse", both!(reverse)),
    ("Curve::elevate", both!(elevate)),
    ("Curve::reduce", both!(reduce)),
    ("Curve::transform", both!(transform)),
    ("Curve::de_casteljau", both!(de_casteljau)),
];

/// Checks that a piece has the same points as the curve.
fn is_piece<P: Space>(
    case: &Case,
    curve: &Curve<P>,
    piece: &Curve<P>,
    t0: f64,
    t1: f64,
) -> Checked {
    let n = curve.degree();
    let slack = 4.0
        * slack(case.size(), n)
        * growth(t0, n).max(growth(t1, n))
        * growth(t0, n).min(growth(t1, n));
    for s in parameters(4, 1.0) {
        let t = t0 * (1.0 - s) + t1 * s;
        let gap = distance(piece.eval(s), curve.eval(t));
        ensure!(
            gap <= slack,
            "the piece from {t0} to {t1} is {gap:e} away at {t}, more than {slack:e}"
        );
    }
    Ok(())
}

fn split<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let (left, right) = value!(case, curve.split(t));
    ensure!(left.end() == right.start(), "the pieces do not join");
    ensure!(
        left.start() == curve.start() && right.end() == curve.end(),
        "the outer ends are not kept"
    );
    is_piece(case, &curve, &left, 0.0, t)?;
    is_piece(case, &curve, &right, t, 1.0)
}

fn halve<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let (left, right) = value!(case, curve.halve());
    ensure!(left.end() == right.start(), "the halves do not join");
    is_piece(case, &curve, &left, 0.0, 0.5)?;
    is_piece(case, &curve, &right, 0.5, 1.0)
}

fn subsegment<P: Space>(case: &Case) -> Checked {
    let (curve, t0, t1) = (
        curve::<P>(case, "curve"),
        number(case, "t0"),
        number(case, "t1"),
    );
    let piece = value!(case, curve.subsegment(t0, t1));
    is_piece(case, &curve, &piece, t0, t1)
}

fn reverse<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let reversed = call(case, || curve.reverse())?;
    ensure!(
        reversed
            .control_points()
            .iter()
            .rev()
            .eq(curve.control_points()),
        "not the same points backwards"
    );
    Ok(())
}

fn elevate<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let elevated = answer!(case, curve.elevate());
    ensure!(
        elevated.degree() == curve.degree() + 1,
        "degree {}",
        elevated.degree()
    );
    is_piece(case, &curve, &elevated, 0.0, 1.0)
}

fn reduce<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let reduced = value!(case, curve.reduce());
    let n = curve.degree();
    ensure!(
        reduced.curve.degree() == (n - 1).max(1),
        "degree {}",
        reduced.curve.degree()
    );
    // The error comes from a formula: the control points are rounded, and the n-th difference enlarges this rounding.
    let largest = reduced
        .curve
        .control_points()
        .iter()
        .map(|p| p.max_abs())
        .fold(case.size(), f64::max);
    let slack = 16.0 * slack(largest, n) + reduced.error * 1e-9;
    for t in parameters(16, 1.0) {
        let gap = distance(reduced.curve.eval(t), curve.eval(t));
        ensure!(
            gap <= reduced.error + slack,
            "{gap:e} away at {t}, more than {:e}",
            reduced.error
        );
    }
    Ok(())
}

fn transform<P: Space>(case: &Case) -> Checked {
    let (curve, map) = (curve::<P>(case, "curve"), affine::<P>(case, "map"));
    let image = answer!(case, curve.transform(&map), &["image"]);
    let slack = 8.0 * slack(case.size() + 2.0, curve.degree());
    for t in parameters(4, 1.0) {
        let gap = distance(image.eval(t), curve.eval(t).transform(&map));
        ensure!(gap <= slack, "{gap:e} away from the image at {t}");
    }
    Ok(())
}

fn de_casteljau<P: Space>(case: &Case) -> Checked {
    let (curve, t) = (curve::<P>(case, "curve"), number(case, "t"));
    let levels = value!(case, curve.de_casteljau(t));
    let lengths: Vec<usize> = levels.iter().map(Vec::len).collect();
    ensure!(
        lengths == (1..=curve.degree() + 1).rev().collect::<Vec<_>>(),
        "levels of {lengths:?} points"
    );
    let gap = distance(levels[curve.degree()][0], curve.eval(t));
    ensure!(
        gap <= slack(case.size(), curve.degree()) * growth(t, curve.degree()),
        "{gap:e} away from eval"
    );
    Ok(())
}
