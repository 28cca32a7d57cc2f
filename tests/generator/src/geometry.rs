//! Curves, splines, paths, patches and surfaces of each mode.

use crate::adversarial::{self, Kind, ORDINARY, elevated_to, within_range};
use crate::case::{Mode, NurbsSurfaceData, RationalData, SplineData, SurfaceData};
use crate::large;
use crate::random::{Rng, real};
use glam::DVec3;
use std::f64::consts::FRAC_1_SQRT_2;

/// The control points of a curve.
pub(crate) fn curve(rng: &mut Rng, mode: Mode, dimension: usize, max_degree: usize) -> Vec<DVec3> {
    let degree = degree(rng, mode, max_degree);
    match mode {
        Mode::Moderate => moderate(rng, degree, dimension),
        Mode::MixedScale => mixed_scale(rng, degree, dimension),
        Mode::Extreme => {
            let kind = rng.pick(&[Kind::Huge, Kind::Tiny, Kind::Largest]);
            adversarial::points(rng, kind, degree, dimension)
        }
    }
}

/// Mostly low degrees, up to 24.
fn degree(rng: &mut Rng, mode: Mode, max: usize) -> usize {
    let degree = if mode == Mode::MixedScale && rng.chance(0.5) {
        1 + rng.below(24)
    } else {
        rng.pick(&[1, 2, 2, 3, 3, 3, 3, 3, 4, 4, 5, 6, 8, 12])
    };
    degree.min(max)
}

fn moderate(rng: &mut Rng, degree: usize, dimension: usize) -> Vec<DVec3> {
    let kind = rng.pick(&ORDINARY);
    let scale = rng.pick(&[1.0, 1.0, 10.0, 100.0, 1000.0]);
    let mut points = adversarial::points(rng, kind, degree, dimension);
    points.iter_mut().for_each(|p| *p *= scale);
    points
}

/// A number whose size lies between 1e-12 and 1e15, or zero, or one of few values that repeat.
fn mixed_number(rng: &mut Rng) -> f64 {
    let sign = rng.sign();
    match rng.below(10) {
        0 | 1 => 0.0,
        2 => sign,
        3 => sign * 1e15,
        _ => sign * rng.magnitude(-12.0, 15.0),
    }
}

fn mixed_point(rng: &mut Rng, dimension: usize) -> DVec3 {
    let (x, y, z) = (mixed_number(rng), mixed_number(rng), mixed_number(rng));
    DVec3::new(x, y, if dimension == 3 { z } else { 0.0 })
}

fn mixed_scale(rng: &mut Rng, degree: usize, dimension: usize) -> Vec<DVec3> {
    // Half of the curves have one size for each point, so that their two or three coordinates are comparable.
    let together = rng.chance(0.5);
    let mut points: Vec<DVec3>;
    if together {
        let kind = rng.pick(&ORDINARY);
        points = adversarial::points(rng, kind, degree, dimension);
        let scale = rng.magnitude(-9.0, 12.0);
        points
            .iter_mut()
            .for_each(|p| *p *= scale * rng.magnitude(-3.0, 3.0));
    } else {
        points = (0..=degree).map(|_| mixed_point(rng, dimension)).collect();
    }
    if rng.chance(0.3) {
        repeat_points(rng, &mut points);
    }
    if rng.chance(0.2) {
        // On a line through the first point; the multiples are of very different sizes.
        let (origin, direction) = (points[0], rng.point(dimension));
        let along = points.iter().map(|p| origin + direction * p.x);
        points = along.collect();
    }
    points
}

/// Some points take the place of others.
fn repeat_points(rng: &mut Rng, points: &mut [DVec3]) {
    for _ in 0..1 + rng.below(points.len()) {
        let (from, to) = (rng.below(points.len()), rng.below(points.len()));
        points[to] = points[from];
    }
}

/// A curve that has something in common with another one: a piece, an end, a direction, or all but a few ulps.
pub(crate) fn related(rng: &mut Rng, mode: Mode, dimension: usize, first: &[DVec3]) -> Vec<DVec3> {
    let mut points = first.to_vec();
    match rng.below(8) {
        0 => points.reverse(),
        1 => {
            let chord = first[0] - first[first.len() - 1];
            let up = DVec3::Y * (chord.abs().max_element() * rng.magnitude(-16.0, 0.0));
            points.iter_mut().for_each(|p| *p += up);
        }
        2 => points = left_piece(first, rng.unit()),
        3 => points = adversarial::elevated(first),
        4 => {
            let (joint, mut other) = (first[first.len() - 1], curve(rng, mode, dimension, 24));
            other[0] = joint;
            points = other;
        }
        _ => points = curve(rng, mode, dimension, 24),
    }
    points.truncate(25);
    points.into_iter().map(within_range).collect()
}

/// The control points of the piece from 0 to t, by de Casteljau's algorithm.
fn left_piece(points: &[DVec3], t: f64) -> Vec<DVec3> {
    let mut row = points.to_vec();
    let mut piece = vec![row[0]];
    while row.len() > 1 {
        row = row
            .windows(2)
            .map(|w| w[0] * (1.0 - t) + w[1] * t)
            .collect();
        piece.push(row[0]);
    }
    piece
}

/// A weight between 10⁻⁶ and 10⁶.
pub(crate) fn weight(rng: &mut Rng) -> f64 {
    let size = rng.pick(&[0.0, 0.5, 1.0, 6.0]);
    rng.magnitude(-size, size)
}

/// Weights of similar sizes, or between 10⁻⁶ and 10⁶.
pub(crate) fn weights(rng: &mut Rng, count: usize) -> Vec<f64> {
    let size = rng.pick(&[0.0, 0.5, 1.0, 6.0]);
    (0..count).map(|_| rng.magnitude(-size, size)).collect()
}

/// A rational curve.
pub(crate) fn rational(rng: &mut Rng, mode: Mode, dimension: usize) -> RationalData {
    let points = curve(rng, mode, dimension, 24);
    RationalData {
        dimension,
        degree: points.len() - 1,
        weights: weights(rng, points.len()),
        points,
        knots: Vec::new(),
        closed: false,
    }
}

/// A rational curve whose points are those of [`related`], half of the time with the weights of the first curve.
pub(crate) fn related_rational(rng: &mut Rng, mode: Mode, first: &RationalData) -> RationalData {
    let points = related(rng, mode, first.dimension, &first.points);
    let has_same_weights = points.len() == first.points.len() && rng.chance(0.5);
    RationalData {
        degree: points.len() - 1,
        weights: if has_same_weights {
            first.weights.clone()
        } else {
            weights(rng, points.len())
        },
        points,
        ..first.clone()
    }
}

/// A NURBS curve with the knots of the first one and the points of [`related`], or any other one.
pub(crate) fn related_nurbs(rng: &mut Rng, mode: Mode, first: &RationalData) -> RationalData {
    let points = related(rng, mode, first.dimension, &first.points);
    if points.len() != first.points.len() {
        return nurbs(rng, mode, first.dimension);
    }
    RationalData {
        points,
        ..first.clone()
    }
}

/// A NURBS curve of up to eight segments, with knots of every multiplicity up to the degree.
pub(crate) fn nurbs(rng: &mut Rng, mode: Mode, dimension: usize) -> RationalData {
    let degree = rng.pick(&[1, 2, 2, 3, 3, 3, 4, 7]);
    let closed = rng.chance(0.25);
    let count = degree + 1 + rng.below(8);
    let mut points = Vec::new();
    while points.len() < count {
        points.extend(curve(rng, mode, dimension, 8));
    }
    points.truncate(count);
    let knots = knots(rng, degree, count, closed);
    RationalData {
        dimension,
        degree,
        weights: weights(rng, count),
        points,
        knots,
        closed,
    }
}

/// Knots of every multiplicity up to the degree.
fn knots(rng: &mut Rng, degree: usize, count: usize, closed: bool) -> Vec<f64> {
    let inner = if closed {
        count + 1
    } else {
        count - degree + 1
    };
    let (mut knots, mut knot, mut times) = (Vec::new(), 0.0, 1);
    for k in 0..inner {
        let is_end = k < 2 || k + 1 == inner;
        if is_end || times == degree || rng.chance(0.7) {
            knot += rng.pick(&[1.0, 1.0, 0.25, 3.0]);
            times = 0;
        }
        times += 1;
        knots.push(knot);
    }
    if !closed {
        let (first, last) = (knots[0], knots[inner - 1]);
        let mut all = vec![first; degree];
        all.extend(knots);
        all.extend(vec![last; degree]);
        knots = all;
    }
    knots
}

/// A patch with weights.
pub(crate) fn rational_patch(rng: &mut Rng, mode: Mode) -> NurbsSurfaceData {
    let (points, degrees) = net(rng, mode);
    NurbsSurfaceData {
        degrees,
        weights: weights(rng, points.len()),
        points,
        knots: [Vec::new(), Vec::new()],
    }
}

/// A NURBS surface of up to nine patches. The net is that of a patch, of which the degrees are only a part of the counts.
pub(crate) fn nurbs_surface(rng: &mut Rng, mode: Mode) -> NurbsSurfaceData {
    let (points, [m, n]) = net(rng, mode);
    let degrees = [m, n].map(|most| most - rng.below(most.min(3)));
    let knots = [0, 1].map(|k| knots(rng, degrees[k], [m, n][k] + 1, false));
    NurbsSurfaceData {
        degrees,
        weights: weights(rng, points.len()),
        points,
        knots,
    }
}

/// A spline of one to five segments.
pub(crate) fn spline(rng: &mut Rng, mode: Mode, dimension: usize) -> SplineData {
    let closed = rng.chance(0.4);
    let count = 1 + rng.below(5);
    let same_degree = rng.chance(0.6).then(|| degree(rng, mode, 6));
    let mut points: Vec<DVec3> = Vec::new();
    let mut degrees = Vec::new();
    for _ in 0..count {
        let piece = curve(rng, mode, dimension, same_degree.unwrap_or(8));
        let piece = elevated_to(piece, same_degree.unwrap_or(1));
        degrees.push(piece.len() - 1);
        join(rng, &mut points, piece);
    }
    if closed {
        points.pop();
    }
    SplineData {
        dimension,
        points,
        degrees,
        closed,
    }
}

/// Appends a piece from where the last one ends; in half of the cases its first handle continues the last direction.
fn join(rng: &mut Rng, points: &mut Vec<DVec3>, mut piece: Vec<DVec3>) {
    let Some(&end) = points.last() else {
        points.extend(piece);
        return;
    };
    let shift = end - piece[0];
    piece.iter_mut().for_each(|p| *p = within_range(*p + shift));
    piece[0] = end;
    if rng.chance(0.5) && piece.len() > 2 {
        let back = end - points[points.len() - 2];
        piece[1] = within_range(end + back * rng.pick(&[1.0, 1.0, 0.5, 1e-6]));
    }
    points.extend(&piece[1..]);
}

/// None to three splines of the plane.
pub(crate) fn path(rng: &mut Rng, mode: Mode) -> Vec<SplineData> {
    let count = rng.pick(&[0, 1, 1, 1, 2, 2, 3]);
    (0..count).map(|_| spline(rng, mode, 2)).collect()
}

/// A net of control points: a graph with noise, or curves of any kind as rows; sides and rows may coincide.
pub(crate) fn net(rng: &mut Rng, mode: Mode) -> (Vec<DVec3>, [usize; 2]) {
    let max = if mode == Mode::MixedScale { 12 } else { 5 };
    let [m, n] = [patch_degree(rng, max), patch_degree(rng, max)];
    let mut net = match rng.chance(0.5) {
        true => graph(rng, m, n),
        false => rows(rng, mode, m, n),
    };
    match rng.below(8) {
        0 => collapse_row(rng, &mut net, m, n),
        1 => repeat_points(rng, &mut net),
        2 => net.iter_mut().for_each(|p| p.z = 0.0),
        3 if mode == Mode::MixedScale => {
            net.iter_mut().for_each(|p| *p *= rng.magnitude(-6.0, 6.0))
        }
        _ => {}
    }
    let scale = match mode {
        Mode::Moderate => rng.pick(&[1.0, 10.0, 100.0]),
        Mode::MixedScale => rng.magnitude(-6.0, 3.0),
        Mode::Extreme => rng.pick(&[1e140, 1e-290]),
    };
    if mode != Mode::Extreme || net.iter().all(|p| p.abs().max_element() < 1e3) {
        net.iter_mut().for_each(|p| *p *= scale);
    }
    (net, [m, n])
}

fn patch_degree(rng: &mut Rng, max: usize) -> usize {
    rng.pick(&[1, 2, 3, 3, 3, 3, 3, 4, 5, 8, 12]).min(max)
}

fn graph(rng: &mut Rng, m: usize, n: usize) -> Vec<DVec3> {
    let noise = rng.pick(&[0.0, 0.1, 1.0]);
    let locations = (0..=n).flat_map(|j| (0..=m).map(move |i| (i, j)));
    let points = locations.map(|(i, j)| DVec3::new(real(i), real(j), 0.0) + rng.point(3) * noise);
    points.collect()
}

fn rows(rng: &mut Rng, mode: Mode, m: usize, n: usize) -> Vec<DVec3> {
    let mut net = Vec::new();
    for _ in 0..=n {
        net.extend(elevated_to(curve(rng, mode, 3, m), m));
    }
    net
}

/// One side becomes a point.
fn collapse_row(rng: &mut Rng, net: &mut [DVec3], m: usize, n: usize) {
    let along_u = rng.chance(0.5);
    let (step, count) = if along_u { (1, m + 1) } else { (m + 1, n + 1) };
    for k in 1..count {
        net[k * step] = net[0];
    }
}

/// A patch as a surface with one patch.
pub(crate) fn patch(rng: &mut Rng, mode: Mode) -> SurfaceData {
    let (vertices, degrees) = net(rng, mode);
    let count = u32::try_from(vertices.len()).expect("a small net");
    SurfaceData {
        vertices,
        indices: (0..count).collect(),
        degrees: vec![degrees],
        weights: Vec::new(),
    }
}

/// A surface of none to four patches; neighbours often share vertices or places.
pub(crate) fn surface(rng: &mut Rng, mode: Mode) -> SurfaceData {
    let mut surface = SurfaceData {
        vertices: Vec::new(),
        indices: Vec::new(),
        degrees: Vec::new(),
        weights: Vec::new(),
    };
    for _ in 0..rng.pick(&[0, 1, 1, 2, 2, 3, 4]) {
        let (net, degrees) = net(rng, mode);
        let first = surface.vertices.len();
        let shares = first > 0 && rng.chance(0.6);
        for (k, mut point) in net.into_iter().enumerate() {
            let mut index = surface.vertices.len();
            // The first row of a patch is taken from vertices that are there already, by index or by place.
            if shares && k <= degrees[0] && k < first {
                point = surface.vertices[first - 1 - k];
                index = if rng.chance(0.9) {
                    first - 1 - k
                } else {
                    index
                };
            }
            if index == surface.vertices.len() {
                surface.vertices.push(point);
            }
            let index = u32::try_from(index).expect("a small surface");
            surface.indices.push(index);
        }
        surface.degrees.push(degrees);
    }
    surface
}

/// A surface with weights: a body of revolution, a large surface, or any other one. Most edges that patches share have weights
/// in proportion, because they are those of the vertices.
pub(crate) fn rational_surface(rng: &mut Rng, mode: Mode, is_large: bool) -> SurfaceData {
    let (mut surface, of_vertices) = match rng.below(4) {
        _ if is_large => (large::surface(rng), Vec::new()),
        0 => revolved(rng, mode),
        _ => (surface(rng, mode), Vec::new()),
    };
    let of_vertices = match of_vertices.is_empty() {
        true => weights(rng, surface.vertices.len()),
        false => of_vertices,
    };
    let are_of_patches = rng.chance(0.2);
    let mut start = 0;
    for [m, n] in surface.degrees.clone() {
        let end = start + (m + 1) * (n + 1);
        if are_of_patches {
            surface.weights.extend(weights(rng, end - start));
        } else {
            let factor = rng.pick(&[1.0, 1.0, 3.0, 0.1]);
            let net = surface.indices[start..end].iter();
            let weights = net.map(|&index| factor * of_vertices[index as usize]);
            surface.weights.extend(weights);
        }
        start = end;
    }
    surface
}

/// A profile that turns around the z axis, in four patches, and the weights of its vertices; half of the profiles have poles.
fn revolved(rng: &mut Rng, mode: Mode) -> (SurfaceData, Vec<f64>) {
    /// Points around a circle; every other one is a corner of the square around it.
    const AROUND: [[f64; 2]; 8] = [
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [-1.0, 1.0],
        [-1.0, 0.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
    ];
    let mut profile = curve(rng, mode, 2, 5);
    let degree = profile.len() - 1;
    if rng.chance(0.5) {
        profile[0].x = 0.0;
        profile[degree].x = 0.0;
    }
    let along = weights(rng, profile.len());
    let ring = |p: DVec3| AROUND.map(|[x, y]| DVec3::new(p.x.abs() * x, p.x.abs() * y, p.y));
    let ring_weights = |&w: &f64| (0..8).map(move |k| [1.0, FRAC_1_SQRT_2][k % 2] * w);
    let index = |row: usize, k: usize| u32::try_from(8 * row + k % 8).expect("a small surface");
    let net = |quarter: usize| {
        let rows = 0..=degree;
        rows.flat_map(move |row| (0..3).map(move |k| index(row, 2 * quarter + k)))
    };
    let surface = SurfaceData {
        vertices: profile.into_iter().flat_map(ring).collect(),
        indices: (0..4).flat_map(net).collect(),
        degrees: vec![[2, degree]; 4],
        weights: Vec::new(),
    };
    (surface, along.iter().flat_map(ring_weights).collect())
}
