//! Strokes of points, and contours that are too thin to be kept.

use super::options::{Pen, StrokeCap};
use super::outline::{add_cap, push_closed};
use super::section::{Disc, RIGHT};
use crate::curve::nearest::nearest_on;
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::path::Path;
use crate::path::winding::crossings;
use crate::spline::Spline;
use crate::spline::spline_builder::SplineBuilder;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;
use std::borrow::Cow;
use std::f64::consts::{PI, SQRT_2};

/// A part of the stroke thinner than this part of half the width is an error of approximation.
const THIN_PART: f64 = 0.25;

/// Appends the stroke of a point: two caps back to back.
pub(super) fn push_dot(path: &mut Path, center: DVec2, tangent: DVec2, pen: &Pen) {
    let disc = Disc {
        center,
        tangent,
        radii: pen.sides.unwrap_or([pen.radius; 2]),
        slope: 0.0,
        speed: 0.0,
    }
    .cap_disc();
    match pen.cap {
        StrokeCap::Butt => {}
        StrokeCap::Square => {
            let (ahead, aside) = (tangent * disc.radius(), tangent.perp() * disc.radius());
            let corners = [ahead - aside, ahead + aside, aside - ahead, -ahead - aside];
            path.push(&corners.map(|by| disc.center + by), [1; 4], true);
        }
        StrokeCap::Round => {
            let mut dot = SplineBuilder::default();
            dot.start(disc.point(RIGHT));
            for sign in [1.0, -1.0] {
                add_cap(&mut dot, disc, sign, pen.cap, pen);
            }
            push_closed(path, dot);
        }
    }
}

/// Appends a disk.
pub(super) fn push_disk(path: &mut Path, center: DVec2, pen: &Pen) {
    let round = Pen {
        cap: StrokeCap::Round,
        ..*pen
    };
    push_dot(path, center, DVec2::X, &round);
}

/// The contours of a region without those that are thinner than the tolerance.
///
/// The mean thickness of a contour is 2 A/L for an area A and a length L, and no more than the diameter of the largest disc
/// in it. A contour with a small mean can still be thick somewhere: then a disc is searched.
pub(super) fn without_thin(region: &Path, pen: &Pen) -> Path {
    let mut work = WorkLimit::new(BASE_STEPS);
    work.raise_limit(STEPS_PER_SEGMENT, region.segment_count());
    let keeps = |contour: &Spline<DVec2>| {
        let area = contour.area();
        let thin = if area < 0.0 {
            pen.tolerance
        } else {
            pen.tolerance.min(THIN_PART * pen.radius)
        };
        2.0 * area.abs() > thin * contour.length()
            || contains_disc(contour, area, 0.5 * thin, &mut work)
    };
    region.subpaths().filter(keeps).collect()
}

/// A disc is certain to be found if its radius is larger than asked for by this part.
const DISC_SLACK: f64 = 0.125;

/// The steps of the searches in all contours: for each segment, and in addition for any number of them. A step is a
/// comparison with a box, about 10 ns. A contour that is longer than some 10⁴ radii takes about as many.
const STEPS_PER_SEGMENT: usize = 1 << 8;
const BASE_STEPS: usize = 1 << 20;

/// Whether there is a disc in a contour with an area: true if there is one of a radius that is larger by `DISC_SLACK`,
/// false if there is none of the radius. If there are no steps left, the answer is true.
///
/// Squares are divided until the distance of their centres from the contour decides about all their points: it differs
/// from that of a centre by at most half the diagonal.
fn contains_disc(contour: &Spline<DVec2>, area: f64, radius: f64, work: &mut WorkLimit) -> bool {
    let all = contour.control_bounds();
    let size = all.max - all.min;
    let larger = radius * (1.0 + DISC_SLACK);
    // Such a disc has a smaller area than the contour and fits into its box.
    if area.abs() < PI * larger * larger || size.min_element() < 2.0 * larger {
        return false;
    }
    let segments: Vec<Cow<[DVec2]>> = (0..contour.segment_count())
        .map(|k| contour.segment_points(k))
        .collect();
    let boxes: Vec<_> = segments.iter().map(|p| Bounds::from_points(p)).collect();
    let tree = BoxTree::new(&boxes);
    let mut squares = vec![(all.min * 0.5 + all.max * 0.5, 0.5 * size.max_element())];
    while !squares.is_empty() {
        let mut next = Vec::new();
        for (center, half) in squares {
            let corner = half * SQRT_2;
            // Farther segments cannot decide about the square.
            let mut distance = larger + corner;
            tree.within(center, &mut distance, work, |k| {
                nearest_on(&segments[k], center).distance
            });
            if distance + corner < larger {
                continue;
            }
            let is_inside = winding_number(&tree, &segments, center, work) != 0;
            if work.is_exceeded() || is_inside && distance >= radius {
                return true;
            }
            // The points inside are beyond the contour.
            if !is_inside && corner - distance < larger {
                continue;
            }
            let quarter = 0.5 * half;
            for x in [-quarter, quarter] {
                next.extend([-quarter, quarter].map(|y| (center + DVec2::new(x, y), quarter)));
            }
        }
        squares = next;
    }
    false
}

/// The winding number of closed segments around a point.
fn winding_number(
    tree: &BoxTree,
    segments: &[Cow<[DVec2]>],
    p: DVec2,
    work: &mut WorkLimit,
) -> i32 {
    let mut winding = 0;
    let is_right = |all: &Bounds<DVec2>| all.min.y <= p.y && p.y <= all.max.y && p.x <= all.max.x;
    tree.matching(is_right, work, |k, _| {
        winding += crossings(&segments[k], p);
    });
    winding
}
