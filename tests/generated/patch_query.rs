//! Checks of patches: subdivision, bounding boxes, areas, nearest points, rays.

use crate::arguments::*;
use crate::check::*;
use crate::curve_measure::holds;
use crate::patch::{locations, slack_at};
use crate::runner::Row;
use casteljau::Patch;
use casteljau::glam::DVec3;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Patch::split_u", split_u),
    ("Patch::split_v", split_v),
    ("Patch::split", split),
    ("Patch::elevate", elevate),
    ("Patch::bounds", bounds),
    ("Patch::flatness", flatness),
    ("Patch::area", area),
    ("Patch::nearest", nearest),
    ("Patch::intersect_ray", intersect_ray),
];

/// Checks that a piece is the part of the patch over [u0, u1] × [v0, v1].
fn is_piece(
    case: &Case,
    patch: &Patch,
    piece: &Patch,
    [u0, u1]: [f64; 2],
    [v0, v1]: [f64; 2],
) -> Checked {
    let worst = |a: f64, b: f64, n: usize| growth(a, n).max(growth(b, n));
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let slack = 8.0 * slack(case.size(), m + n) * worst(u0, u1, m) * worst(v0, v1, n);
    for (s, t) in locations(3) {
        let (u, v) = (u0 * (1.0 - s) + u1 * s, v0 * (1.0 - t) + v1 * t);
        let gap = distance(piece.eval(s, t), patch.eval(u, v));
        ensure!(
            gap <= slack,
            "the piece is {gap:e} away at ({u}, {v}), more than {slack:e}"
        );
    }
    Ok(())
}

fn split_u(case: &Case) -> Checked {
    let (patch, u) = (patch(case), number(case, "u"));
    let (before, after) = value!(case, patch.split_u(u));
    is_piece(case, &patch, &before, [0.0, u], [0.0, 1.0])?;
    is_piece(case, &patch, &after, [u, 1.0], [0.0, 1.0])
}

fn split_v(case: &Case) -> Checked {
    let (patch, v) = (patch(case), number(case, "v"));
    let (before, after) = value!(case, patch.split_v(v));
    is_piece(case, &patch, &before, [0.0, 1.0], [0.0, v])?;
    is_piece(case, &patch, &after, [0.0, 1.0], [v, 1.0])
}

fn split(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let [a, b, c, d] = value!(case, patch.split(u, v));
    is_piece(case, &patch, &a, [0.0, u], [0.0, v])?;
    is_piece(case, &patch, &b, [u, 1.0], [0.0, v])?;
    is_piece(case, &patch, &c, [0.0, u], [v, 1.0])?;
    is_piece(case, &patch, &d, [u, 1.0], [v, 1.0])
}

fn elevate(case: &Case) -> Checked {
    let patch = patch(case);
    let elevated = answer!(case, patch.elevate());
    ensure!(
        elevated.degree_u() == patch.degree_u() + 1,
        "degree {}",
        elevated.degree_u()
    );
    is_piece(case, &patch, &elevated, [0.0, 1.0], [0.0, 1.0])
}

fn bounds(case: &Case) -> Checked {
    let patch = patch(case);
    let bounds = value!(case, patch.bounds());
    let slack = 4.0 * slack_at(case, &patch, 0.0, 0.0);
    for (u, v) in locations(8) {
        ensure!(
            holds(&bounds, patch.eval(u, v), slack),
            "S({u}, {v}) lies outside"
        );
    }
    let outer = patch.control_bounds();
    ensure!(
        holds(&outer, bounds.min, slack) && holds(&outer, bounds.max, slack),
        "larger than the box of the control points"
    );
    Ok(())
}

fn flatness(case: &Case) -> Checked {
    let patch = patch(case);
    let flatness = value!(case, patch.flatness());
    let [a, b, c, d] =
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(u, v)| patch.eval(u, v));
    let slack = 8.0 * slack_at(case, &patch, 0.0, 0.0);
    for (u, v) in locations(6) {
        // The point of the triangles at (u, v), with the diagonal from b to c.
        let flat = if u + v <= 1.0 {
            a + (b - a) * u + (c - a) * v
        } else {
            d + (c - d) * (1.0 - u) + (b - d) * (1.0 - v)
        };
        let gap = distance(patch.eval(u, v), flat);
        ensure!(
            gap <= flatness + slack,
            "{gap:e} from the triangles at ({u}, {v}), the bound is {flatness:e}"
        );
    }
    Ok(())
}

fn area(case: &Case) -> Checked {
    let patch = patch(case);
    let area = value!(case, patch.area());
    ensure!(area >= 0.0, "{area:e} is negative");
    // The quarters take four times as long, so they are only checked for some of the calls.
    if case.number % 8 > 1 {
        return Ok(());
    }
    let [a, b, c, d] = patch.split(0.5, 0.5);
    let sum: f64 = [a, b, c, d].iter().map(Patch::area).sum();
    // The relative error is 1e-8 each; up to 1e-3 where the patch folds back (documented).
    let slack = 1e-3 * area + 64.0 * slack_at(case, &patch, 0.0, 0.0) * case.size();
    ensure!(
        area >= 0.0 && (area - sum).abs() <= slack,
        "{area:e}, but the quarters have {sum:e}"
    );
    Ok(())
}

fn nearest(case: &Case) -> Checked {
    let (patch, p) = (patch(case), point::<DVec3>(case, "p"));
    let nearest = answer!(case, patch.nearest(p));
    ensure!(
        [nearest.u, nearest.v]
            .iter()
            .all(|x| (0.0..=1.0).contains(x)),
        "({}, {})",
        nearest.u,
        nearest.v
    );
    let slack = 16.0 * slack_at(case, &patch, 0.0, 0.0);
    ensure!(
        distance(nearest.point, patch.eval(nearest.u, nearest.v)) <= slack,
        "the point is not that at (u, v)"
    );
    let off = (distance(nearest.point, p) - nearest.distance).abs();
    ensure!(off <= slack, "the distance is {off:e} off");
    let min = locations(12)
        .map(|(u, v)| distance(patch.eval(u, v), p))
        .fold(f64::INFINITY, f64::min);
    // Squares of distances are compared, so rounding counts as √ε where both are near zero.
    let square = slack * case.size();
    ensure!(
        nearest.distance.powi(2) <= min * min + square,
        "{:e}, but a sample is {min:e} away",
        nearest.distance
    );
    Ok(())
}

/// Checks that a hit lies on the ray, and on the patch at (u, v).
pub(crate) fn is_hit(
    case: &Case,
    origin: DVec3,
    direction: DVec3,
    got: f64,
    point: DVec3,
    on: DVec3,
    slack: f64,
) -> Checked {
    let gap = distance(point, on);
    ensure!(
        gap <= slack,
        "the point is {gap:e} away from that at (u, v)"
    );
    let along = direction.normalize();
    let off = distance(origin + along * got, point);
    // The ray is about 1e-14 of the size of patch and origin together wide, and 1e-7 of it where it grazes.
    let width = 1e-7 * (case.size() + origin.length());
    ensure!(off <= width, "{off:e} off the ray, more than {width:e}");
    Ok(())
}

fn intersect_ray(case: &Case) -> Checked {
    let (patch, origin, direction) = (
        patch(case),
        point::<DVec3>(case, "origin"),
        point::<DVec3>(case, "direction"),
    );
    let hits = answer!(
        case,
        patch.intersect_ray(origin, direction),
        &["direction", "too many"]
    );
    ensure!(
        hits.windows(2).all(|w| w[0].distance <= w[1].distance),
        "the hits are not sorted"
    );
    let slack = 16.0 * slack_at(case, &patch, 0.0, 0.0);
    for hit in hits {
        is_hit(
            case,
            origin,
            direction,
            hit.distance,
            hit.point,
            patch.eval(hit.u, hit.v),
            slack,
        )?;
    }
    Ok(())
}
