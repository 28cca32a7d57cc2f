//! Checks of curves: polylines, drawing, offset curves.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::curve::PathSink;
use casteljau::glam::DVec2;
use casteljau::{Curve, Path, Point, Spline};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Curve::flatten", both!(flatten)),
    ("Curve::flatten_with", both!(flatten_with)),
    ("Curve::subdivide", both!(subdivide)),
    ("Curve::trace", trace),
    ("Curve::to_svg", to_svg),
    ("Curve::offset", offset),
];

/// Checks that a polyline lies on the curve and that the curve is within the tolerance of it.
fn follows<P: Space>(case: &Case, curve: &Curve<P>, points: &[P], ts: &[f64]) -> Checked {
    let tolerance = number(case, "tolerance");
    let slack = slack(case.size(), curve.degree());
    ensure!(
        ascends(ts, 0.0, 1.0) && ts[0] == 0.0 && ts[ts.len() - 1] == 1.0,
        "the parameters do not ascend from 0 to 1"
    );
    let stride = points.len().div_ceil(50);
    for k in (0..points.len() - 1).step_by(stride) {
        ensure!(
            distance(points[k], curve.eval(ts[k])) <= slack,
            "vertex {k} is not on the curve"
        );
        for s in [0.25, 0.5, 0.8] {
            let t = ts[k] * (1.0 - s) + ts[k + 1] * s;
            let gap = from_segment(curve.eval(t), points[k], points[k + 1]);
            ensure!(
                gap <= tolerance + 2.0 * slack,
                "{gap:e} from the polyline at {t}, the tolerance is {tolerance:e}"
            );
        }
    }
    Ok(())
}

fn flatten<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let line = answer!(
        case,
        curve.flatten(number(case, "tolerance")),
        &["tolerance"]
    );
    follows(case, &curve, &line.points, &line.ts)
}

fn flatten_with<P: Space>(case: &Case) -> Checked {
    let (curve, mut points, mut ts) = (curve::<P>(case, "curve"), Vec::new(), Vec::new());
    let add = |t: f64, p: P| {
        ts.push(t);
        points.push(p);
    };
    answer!(
        case,
        curve.flatten_with(number(case, "tolerance"), add),
        &["tolerance"]
    );
    follows(case, &curve, &points, &ts)
}

fn subdivide<P: Space>(case: &Case) -> Checked {
    let (curve, tolerance) = (curve::<P>(case, "curve"), number(case, "tolerance"));
    let tree = answer!(case, curve.subdivide(tolerance), &["tolerance"]);
    let leaves = tree.leaves();
    ensure!(
        leaves[0].t0 == 0.0 && leaves[leaves.len() - 1].t1 == 1.0,
        "the leaves do not reach the ends"
    );
    ensure!(
        leaves.windows(2).all(|w| w[0].t1 == w[1].t0),
        "the leaves do not follow each other"
    );
    for leaf in leaves.iter().step_by(leaves.len().div_ceil(20)) {
        let excess = leaf.polygon_length - leaf.chord_length;
        ensure!(excess < tolerance, "a leaf with D1 − D2 = {excess:e}");
        ensure!(
            leaf.deviation_bound() >= 0.0,
            "a deviation of {}",
            leaf.deviation_bound()
        );
        let end = curve.eval(leaf.t1);
        ensure!(
            distance(leaf.curve.end(), end) <= 4.0 * slack(case.size(), curve.degree()),
            "a leaf off the curve"
        );
    }
    Ok(())
}

/// Records what is drawn: the curves of each subpath, and whether it was closed.
#[derive(Default)]
pub(crate) struct Recorder {
    pub(crate) subpaths: Vec<(Vec<Curve<DVec2>>, bool)>,
    at: DVec2,
    bad: bool,
}

impl Recorder {
    fn add(&mut self, points: &[DVec2]) {
        match (Curve::new(points), self.subpaths.last_mut()) {
            (Ok(curve), Some((curves, _))) => curves.push(curve),
            _ => self.bad = true,
        }
        self.at = points[points.len() - 1];
    }

    /// Whether every number is finite and every subpath starts with a `move_to`.
    pub(crate) fn is_fine(&self) -> bool {
        !self.bad
    }
}

impl PathSink for Recorder {
    fn move_to(&mut self, p: DVec2) {
        self.bad |= !p.is_finite();
        self.at = p;
        self.subpaths.push((Vec::new(), false));
    }
    fn line_to(&mut self, p: DVec2) {
        self.add(&[self.at, p]);
    }
    fn quad_to(&mut self, a: DVec2, p: DVec2) {
        self.add(&[self.at, a, p]);
    }
    fn cubic_to(&mut self, a: DVec2, b: DVec2, p: DVec2) {
        self.add(&[self.at, a, b, p]);
    }
    fn close(&mut self) {
        if let Some((_, closed)) = self.subpaths.last_mut() {
            *closed = true;
        }
    }
}

/// Checks that points of the curve lie within the tolerance of what was drawn.
pub(crate) fn near_drawn(
    case: &Case,
    curve: &Curve<DVec2>,
    drawn: &[Curve<DVec2>],
    tolerance: Option<f64>,
) -> Checked {
    let bounds = curve.control_bounds();
    let tolerance = if curve.degree() <= 3 {
        0.0
    } else {
        tolerance.unwrap_or(1e-4 * bounds.diagonal())
    };
    let slack = 4.0 * slack(case.size(), curve.degree());
    for t in parameters(6, 1.0) {
        let p = curve.eval(t);
        let gaps = drawn
            .iter()
            .filter_map(|piece| piece.nearest(p).ok())
            .map(|nearest| nearest.distance);
        let gap = gaps.fold(f64::INFINITY, f64::min);
        ensure!(
            gap <= tolerance + slack,
            "the curve at {t} is {gap:e} from what was drawn"
        );
    }
    Ok(())
}

fn trace(case: &Case) -> Checked {
    let (curve, tolerance) = (curve::<DVec2>(case, "curve"), optional(case, "tolerance"));
    let mut pen = Recorder::default();
    answer!(case, curve.trace(&mut pen, tolerance), &["tolerance"]);
    ensure!(
        pen.is_fine() && pen.subpaths.len() == 1,
        "not one subpath of finite numbers"
    );
    near_drawn(case, &curve, &pen.subpaths[0].0, tolerance)
}

fn to_svg(case: &Case) -> Checked {
    let (curve, tolerance) = (curve::<DVec2>(case, "curve"), optional(case, "tolerance"));
    let precision =
        optional_count(case, "precision").map(|digits| u8::try_from(digits).expect("few digits"));
    let text = answer!(
        case,
        curve.to_svg(precision, tolerance),
        &["tolerance", "precision"]
    );
    let path = Path::from_svg(&text).map_err(|error| error.to_string())?;
    if precision.is_none() && curve.degree() <= 3 {
        let expected = Path::from(curve);
        ensure!(path == expected, "another path is read back from {text}");
    }
    Ok(())
}

/// The arguments and limits for which an offset may return an error.
pub(crate) const OFFSET_REFUSALS: [&str; 3] = ["tolerance", "distance", "steps of an offset"];

/// The documented default tolerance of an offset.
pub(crate) fn default_tolerance(case: &Case, diagonal: f64, distance: f64) -> f64 {
    (1e-4 * diagonal).max(1e-12 * (case.size() + distance.abs()))
}

fn offset(case: &Case) -> Checked {
    let (curve, d, tolerance) = (
        curve::<DVec2>(case, "curve"),
        number(case, "distance"),
        optional(case, "tolerance"),
    );
    let spline = answer!(case, curve.offset(d, tolerance), &OFFSET_REFUSALS);
    if case.mode == Mode::MixedScale || curve.control_points().iter().all(|&p| p == curve.start()) {
        return Ok(());
    }
    let diagonal = curve.control_bounds().diagonal();
    let tolerance = tolerance.unwrap_or_else(|| default_tolerance(case, diagonal, d));
    is_offset(case, &curve, &spline, d, tolerance, d.abs())
}

/// Checks that points of O(t) = B(t) + d·N(t) lie within the tolerance of the spline, and that the spline's points are
/// at most `farthest` plus the tolerance from the curve.
pub(crate) fn is_offset(
    case: &Case,
    curve: &Curve<DVec2>,
    spline: &Spline<DVec2>,
    d: f64,
    tolerance: f64,
    farthest: f64,
) -> Checked {
    let slack = 16.0 * slack(case.size() + d.abs(), curve.degree());
    let length = curve
        .derivative()
        .control_points()
        .iter()
        .map(|p| p.max_abs())
        .fold(0.0, f64::max);
    for t in parameters(7, 1.0) {
        // Where the speed is almost zero, rounding decides the normal.
        if curve.derivative_at(t, 1).max_abs() > 1e-6 * length {
            let o = curve.eval(t) + curve.normal(t) * d;
            let gap = spline
                .nearest(o)
                .map_err(|error| error.to_string())?
                .distance;
            ensure!(
                gap <= tolerance * (1.0 + 1e-9) + slack,
                "O({t}) is {gap:e} from the spline, the tolerance is {tolerance:e}"
            );
        }
        let q = spline.eval(t * real(spline.segment_count()));
        let away = curve
            .nearest(q)
            .map_err(|error| error.to_string())?
            .distance;
        ensure!(
            away <= farthest + tolerance + slack,
            "the spline is {away:e} from the curve at {t} of its length"
        );
    }
    Ok(())
}
