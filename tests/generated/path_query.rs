//! Checks of paths: nearest points, winding numbers, intersections.

use crate::arguments::*;
use crate::check::*;
use crate::curve_measure::holds;
use crate::path::DEGREE;
use crate::runner::Row;
use casteljau::Path;
use casteljau::curve::IntersectionKind;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, PathIntersection};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Path::nearest", nearest),
    ("Path::winding_number", winding_number),
    ("Path::contains", contains),
    ("Path::intersections", intersections),
    ("Path::self_intersections", self_intersections),
];

fn nearest(case: &Case) -> Checked {
    let (path, p) = (path(case, "path"), point::<DVec2>(case, "p"));
    let nearest = answer!(case, path.nearest(p));
    ensure!(
        nearest.is_some() != path.is_empty(),
        "no place on a path, or one on none"
    );
    let Some(nearest) = nearest else {
        return Ok(());
    };
    let slack = 16.0 * slack(case.size(), DEGREE);
    for (k, spline) in path.subpaths().collect::<Vec<_>>().iter().enumerate() {
        let other = spline.nearest(p).map_err(|error| error.to_string())?;
        ensure!(
            nearest.distance <= other.distance + slack,
            "subpath {k} is nearer"
        );
        let gap = distance(spline.eval(nearest.t), nearest.point);
        ensure!(
            k != nearest.subpath || gap <= slack,
            "the point is not that at t"
        );
    }
    Ok(())
}

fn winding_number(case: &Case) -> Checked {
    let (path, p) = (path(case, "path"), point::<DVec2>(case, "p"));
    let winding = value!(case, path.winding_number(p));
    let bounds = path.control_bounds();
    let outside = bounds.is_none_or(|bounds| !holds(&bounds, p, 0.0));
    ensure!(!outside || winding == 0, "{winding} outside of the box");
    // Reversing the path changes the sign of the winding number, unless the point is on the boundary.
    let away = path
        .nearest(p)
        .map_err(|error| error.to_string())?
        .map_or(1.0, |nearest| nearest.distance);
    let closed = path
        .subpaths()
        .collect::<Vec<_>>()
        .iter()
        .all(|spline| spline.is_closed());
    let back = path.reverse().winding_number(p);
    ensure!(
        !closed || away <= slack(case.size(), DEGREE) || back == -winding,
        "{winding}, and backwards {back}"
    );
    Ok(())
}

fn contains(case: &Case) -> Checked {
    let (path, p) = (path(case, "path"), point::<DVec2>(case, "p"));
    let rule = if word(case, "rule") == "evenodd" {
        FillRule::EvenOdd
    } else {
        FillRule::NonZero
    };
    let inside = value!(case, path.contains(p, rule));
    let winding = path.winding_number(p);
    let expected = if rule == FillRule::EvenOdd {
        winding % 2 != 0
    } else {
        winding != 0
    };
    ensure!(
        inside == expected,
        "inside: {inside} with the winding number {winding}"
    );
    Ok(())
}

fn contacts(case: &Case, found: &[PathIntersection], a: &Path, b: &Path) -> Checked {
    let (a, b) = (
        a.subpaths().collect::<Vec<_>>(),
        b.subpaths().collect::<Vec<_>>(),
    );
    let slack = 4.0 * slack(case.size(), DEGREE);
    for contact in found {
        let (a, b) = (&a[contact.subpath], &b[contact.other_subpath]);
        let mut pairs = vec![(contact.t, contact.u)];
        if let IntersectionKind::Overlap { t_end, u_end } = contact.kind {
            pairs.push((t_end, u_end));
        }
        for (t, u) in pairs {
            let gap = distance(a.eval(t), b.eval(u));
            ensure!(
                gap <= slack,
                "{gap:e} apart at ({t}, {u}), more than {slack:e}"
            );
        }
    }
    Ok(())
}

fn intersections(case: &Case) -> Checked {
    let (a, b) = (path(case, "path"), path(case, "other"));
    let found = value!(case, a.intersections(&b));
    contacts(case, &found, &a, &b)
}

fn self_intersections(case: &Case) -> Checked {
    let path = path(case, "path");
    let found = value!(case, path.self_intersections());
    contacts(case, &found, &path, &path)
}
