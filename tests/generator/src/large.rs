//! Large ordinary drawings and surfaces: maps, hatchings, scribbles, terrains.

use crate::case::{SplineData, SurfaceData};
use crate::random::{Rng, real};
use glam::DVec3;

/// The largest number of segments of drawings in which most pairs of segments cross.
const MAX_CROSSING: usize = 400;

fn lines(points: Vec<DVec3>, closed: bool) -> SplineData {
    let count = points.len() - usize::from(!closed);
    SplineData {
        dimension: 2,
        points,
        degrees: vec![1; count],
        closed,
    }
}

/// A path of 10² to 10 to the power `max` segments.
pub(crate) fn path(rng: &mut Rng, max: f64) -> Vec<SplineData> {
    let size = rng.magnitude(2.0, max);
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 100 to 10,000"
    )]
    let count = size as usize;
    let mut anywhere = |_| rng.point(2) * 100.0;
    match count % 5 {
        0 => vec![lines(
            (0..count.min(MAX_CROSSING)).map(anywhere).collect(),
            true,
        )],
        1 => vec![scribble(rng, count.min(4 * MAX_CROSSING))],
        2 => vec![coast(rng, count)],
        3 => (0..count / 4).map(|_| square(rng)).collect(),
        _ => {
            let shift = anywhere(0);
            (0..count / 4).map(|k| hatch(k, shift)).collect()
        }
    }
}

/// A line that wanders.
fn scribble(rng: &mut Rng, count: usize) -> SplineData {
    let mut points = vec![DVec3::ZERO];
    while points.len() <= count {
        let next = points[points.len() - 1] + rng.point(2) * 10.0;
        points.push(next.clamp(DVec3::splat(-100.0), DVec3::splat(100.0)));
    }
    lines(points, false)
}

/// A closed outline of cubics with bays, around the origin.
fn coast(rng: &mut Rng, count: usize) -> SplineData {
    let points = (0..3 * count).map(|k| {
        let angle = std::f64::consts::TAU * real(k) / real(3 * count);
        DVec3::new(angle.cos(), angle.sin(), 0.0) * (100.0 + rng.signed())
    });
    SplineData {
        dimension: 2,
        points: points.collect(),
        degrees: vec![3; count],
        closed: true,
    }
}

/// A small square somewhere.
fn square(rng: &mut Rng) -> SplineData {
    let (corner, side) = (rng.point(2) * 100.0, 1.0 + 2.0 * rng.unit());
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let points = corners.map(|(x, y)| corner + DVec3::new(x, y, 0.0) * side);
    lines(points.to_vec(), true)
}

/// One of many parallel strips.
fn hatch(k: usize, shift: DVec3) -> SplineData {
    let x = 0.1 * real(k);
    let corners = [
        (x, 0.0),
        (x + 30.0, 30.0),
        (x + 30.05, 30.0),
        (x + 0.05, 0.0),
    ];
    let points = corners.map(|(x, y)| shift + DVec3::new(x, y, 0.0));
    lines(points.to_vec(), true)
}

/// A terrain of a hundred bicubic patches that share their edges.
pub(crate) fn surface(rng: &mut Rng) -> SurfaceData {
    const SIDE: usize = 10;
    const ACROSS: usize = 3 * SIDE + 1;
    let vertices = (0..ACROSS * ACROSS).map(|k| {
        let (x, y) = (real(k % ACROSS) / 3.0, real(k / ACROSS) / 3.0);
        DVec3::new(x, y, 0.1 * rng.signed())
    });
    let index = |x: usize, y: usize| u32::try_from(y * ACROSS + x).expect("few vertices");
    let patch = |k: usize| {
        let (x, y) = (3 * (k % SIDE), 3 * (k / SIDE));
        (0..16).map(move |i| index(x + i % 4, y + i / 4))
    };
    SurfaceData {
        vertices: vertices.collect(),
        indices: (0..SIDE * SIDE).flat_map(patch).collect(),
        degrees: vec![[3, 3]; SIDE * SIDE],
        weights: Vec::new(),
    }
}
