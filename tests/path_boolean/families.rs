//! Pairs of paths of the families that Boolean operations get wrong.

use crate::support::Rng;
use crate::support::paths::{RandomPlane, closed, points};
use casteljau::glam::{DAffine2, DVec2};
use casteljau::{Curve, Path, Spline};
use std::f64::consts::{PI, TAU};

pub(crate) type Family = fn(&mut Rng) -> (Path, Path);

/// The families: name, generator, and whether outlines may nearly coincide.
pub(crate) const FAMILIES: [(&str, Family, bool); 16] = [
    ("blobs", blobs, false),
    ("scribbles", |random| two(random, scribble), false),
    ("turned", turned, true),
    ("moved", moved, true),
    ("shared segments", shared_segments, false),
    ("partial overlap", partial_overlap, false),
    ("tangent circles", tangent_circles, false),
    ("touching", touching, false),
    ("nested", nested, false),
    ("grids", grids, false),
    ("glyphs", glyphs, false),
    ("lattice", |random| two(random, lattice), false),
    ("stars", |random| two(random, star), true),
    ("slivers", |random| two(random, slivers), true),
    ("cusps", |random| two(random, cusps), false),
    ("high degrees", |random| two(random, high_degrees), false),
];

fn two(random: &mut Rng, shape: fn(&mut Rng) -> Path) -> (Path, Path) {
    (shape(random), shape(random))
}

fn spots(random: &mut Rng, count: usize) -> Vec<DVec2> {
    (0..count).map(|_| random.spot(1.0)).collect()
}

fn join(paths: impl IntoIterator<Item = Path>) -> Path {
    let subpaths = |path: Path| path.subpaths().collect::<Vec<_>>();
    paths.into_iter().flat_map(subpaths).collect()
}

fn rect(x: f64, y: f64, w: f64, h: f64) -> Path {
    let corners = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)];
    closed(&corners.map(|p| DVec2::new(x, y) + DVec2::from(p)), 1)
}

/// Four cubics.
pub(crate) fn circle(centre: DVec2, radius: f64) -> Path {
    const K: f64 = 0.551_784_777_797_922;
    let quarter = |out: DVec2| [out, out + out.perp() * K, out.perp() + out * K];
    let points = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y].map(quarter);
    let points = points.as_flattened().iter().map(|&p| centre + p * radius);
    closed(&points.collect::<Vec<_>>(), 3)
}

/// A smooth closed curve around a point.
fn blob(random: &mut Rng, centre: DVec2, count: usize) -> Path {
    let radius: Vec<f64> = (0..count).map(|_| random.between(0.4, 1.0)).collect();
    let at = |k: usize| {
        let k = k % count;
        centre + DVec2::from_angle(TAU * k as f64 / count as f64) * radius[k]
    };
    let tangent = |k: usize| (at(k + 1) - at(k + count - 1)) / 6.0;
    let segment = |k: usize| [at(k), at(k) + tangent(k), at(k + 1) - tangent(k + 1)];
    closed(&(0..count).flat_map(segment).collect::<Vec<_>>(), 3)
}

fn blobs(random: &mut Rng) -> (Path, Path) {
    let (n, m) = (3 + random.below(6), 3 + random.below(6));
    let offset = random.spot(0.6);
    (blob(random, DVec2::ZERO, n), blob(random, offset, m))
}

/// Closed curves of random control points, which cross themselves.
fn scribble(random: &mut Rng) -> Path {
    let (count, degree) = (1 + random.below(4), 1 + random.below(4));
    let count = if degree < 3 { count + 2 } else { count };
    closed(&spots(random, count * degree), degree)
}

fn any(random: &mut Rng) -> Path {
    match random.below(4) {
        0 => blob(random, DVec2::ZERO, 5),
        1 => scribble(random),
        2 => glyph(random),
        _ => rect(-1.0, -0.7, 2.0, 1.4),
    }
}

/// A shape and itself, turned by a small angle.
fn turned(random: &mut Rng) -> (Path, Path) {
    let shape = any(random);
    let other = DAffine2::from_angle(random.magnitude(-12.0, -3.0)) * &shape;
    (shape, other)
}

/// A shape and itself, moved by a small distance.
fn moved(random: &mut Rng) -> (Path, Path) {
    let shape = any(random);
    let mut by = random.direction() * random.magnitude(-16.0, -2.0);
    if random.below(3) == 0 {
        by.y = 0.0;
    }
    let other = DAffine2::from_translation(by) * &shape;
    (shape, other)
}

fn perhaps_reversed(random: &mut Rng, path: Path) -> Path {
    if random.chance(0.5) {
        path
    } else {
        path.reverse()
    }
}

/// Two outlines with some common segments, in either direction.
fn shared_segments(random: &mut Rng) -> (Path, Path) {
    let count = 4 + random.below(5);
    let a = blob(random, DVec2::ZERO, count);
    let b = blob(random, DVec2::new(0.1, 0.05), count);
    let [p, q] = [&a, &b].map(|path| path.subpath(0).expect("a subpath"));
    let shared = 3 * (1 + random.below(count - 1)) + 1;
    let points = [&p.control_points()[..shared], &q.control_points()[shared..]].concat();
    (a, perhaps_reversed(random, closed(&points, 3)))
}

/// Outlines that share a part of a curve.
fn partial_overlap(random: &mut Rng) -> (Path, Path) {
    let mut curve = points("-1 0  -0.3 0  0.4 0.6  1 0");
    curve[1].y = random.between(-1.0, 1.0);
    if random.chance(0.5) {
        curve.drain(1..3);
    }
    let curve = Curve::new(&curve).expect("a curve");
    let mut part = || {
        let (from, to) = (random.between(0.0, 0.45), random.between(0.55, 1.0));
        let piece = curve.subsegment(from..to);
        let tip = DVec2::new(random.between(-0.5, 0.5), random.between(-2.0, 2.0));
        let sides = [
            Curve::line(piece.end(), tip),
            Curve::line(tip, piece.start()),
        ];
        let outline = [&[piece][..], &sides].concat();
        Path::from(Spline::from_curves(&outline, true).expect("joined"))
    };
    (part(), part())
}

fn tangent_circles(random: &mut Rng) -> (Path, Path) {
    let (r, s) = (
        random.pick(&[1.0, 0.5, 0.75]),
        random.pick(&[0.25, 0.5, 1.0]),
    );
    let axis = random.pick(&[DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y]);
    let direction = random.direction();
    let direction = random.pick(&[axis, direction]);
    let distance = random.pick(&[r + s, r - s]);
    (circle(DVec2::ZERO, r), circle(direction * distance, s))
}

/// Shapes that touch in points.
fn touching(random: &mut Rng) -> (Path, Path) {
    let tip = random.spot(0.5);
    let mut triangle = |from: f64| {
        let angle = from + random.between(0.0, 0.5);
        let other = angle + random.between(0.3, 1.2);
        closed(
            &[
                tip,
                tip + DVec2::from_angle(angle),
                tip + DVec2::from_angle(other),
            ],
            1,
        )
    };
    let a = join([triangle(0.0), triangle(PI * 0.6)]);
    let mut b = join([triangle(PI), triangle(PI * 1.5)]);
    if random.chance(0.5) {
        b = join([b, rect(tip.x, tip.y - 1.0, 1.0, 2.0)]);
    }
    (a, b)
}

fn nested(random: &mut Rng) -> (Path, Path) {
    let offset = random.pick(&[0.0, 0.05, 0.17]);
    let mut rings = |offset: f64| {
        let count = 1 + random.below(5);
        let ring = |k: usize| circle(DVec2::ZERO, 1.0 - offset - 0.17 * k as f64);
        join((0..count).map(|k| perhaps_reversed(random, ring(k))))
    };
    (rings(0.0), rings(offset))
}

fn grids(random: &mut Rng) -> (Path, Path) {
    let upright = random.chance(0.5);
    let mut bars = |upright: bool| {
        let count = 2 + random.below(5);
        let step = 2.0 / count as f64;
        let width = step * random.pick(&[0.5, 1.0, 0.25]);
        join((0..count).map(|k| match -1.0 + step * k as f64 {
            from if upright => rect(from, -1.0, width, 2.0),
            from => rect(-1.0, from, 2.0, width),
        }))
    };
    (bars(true), bars(upright))
}

/// A letter: a bowl with a counter, a stem, an accent, with coordinates of a font.
fn glyph(random: &mut Rng) -> Path {
    let mut whole = |min: usize, range: usize| (min + random.below(range)) as f64;
    let (stem, w, h) = (whole(60, 120), whole(300, 200), whole(300, 300));
    let bowl = |w: f64, h: f64| {
        let quarter = points("1 0  1 0.55  0.55 1");
        let turns = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
        let turned = |turn: DVec2| quarter.iter().map(move |&p| turn.rotate(p));
        let unit = turns.into_iter().flat_map(turned);
        let points = unit.map(|p| (p * DVec2::new(w, h)).round() / 1000.0);
        closed(&points.collect::<Vec<_>>(), 3)
    };
    let counter = bowl(w - stem, h - (stem / 2.0).floor()).reverse();
    let post = [
        (w - stem, -h),
        (w, -h),
        (w, h + 200.0),
        (w - stem, h + 200.0),
    ];
    let post = closed(&post.map(|p| DVec2::from(p) / 1000.0), 1);
    join([bowl(w, h), counter, post])
}

fn glyphs(random: &mut Rng) -> (Path, Path) {
    let (a, b) = two(random, glyph);
    let by = DVec2::new(random.below(400) as f64, random.below(200) as f64) / 1000.0;
    (a, DAffine2::from_translation(by) * &b)
}

/// Polygons and curves with small integer coordinates, so that points and segments often coincide.
fn lattice(random: &mut Rng) -> Path {
    let (degree, count) = (random.pick(&[1, 1, 2, 3]), 3 + random.below(5));
    let mut number = || random.pick(&[-1.0, -0.5, 0.0, 0.5, 1.0]);
    let points = (0..count * degree).map(|_| DVec2::new(number(), number()));
    closed(&points.collect::<Vec<_>>(), degree)
}

/// Many contours through one point.
fn star(random: &mut Rng) -> Path {
    let mut contour = || {
        let (a, b) = (random.between(0.0, TAU), random.between(0.1, 2.0));
        let [first, second] = [a, a + b].map(DVec2::from_angle);
        match random.below(2) {
            0 => closed(&[DVec2::ZERO, first, second], 1),
            _ => circle(first * 0.5, 0.5),
        }
    };
    let all: Vec<Path> = [(); 10].map(|()| contour()).to_vec();
    join(all.into_iter().take(2 + random.below(8)))
}

/// Long thin shapes.
fn slivers(random: &mut Rng) -> Path {
    let mut sliver = || {
        let (a, b) = (random.spot(1.0), random.spot(1.0));
        let width = random.magnitude(-8.0, -1.0);
        let (across, bulge) = ((b - a).perp().normalize_or_zero() * width, random.spot(0.5));
        let [c, d] = [b + across, a + across];
        closed(&[a, a + bulge, b + bulge, b, c + bulge, d + bulge], 3)
    };
    join([sliver(), sliver()])
}

/// Curves with cusps, loops, turn-backs and control points that coincide.
fn cusps(random: &mut Rng) -> Path {
    let (a, b, c) = (random.spot(1.0), random.spot(1.0), random.spot(1.0));
    let tip = a + b - c;
    let points = match random.below(6) {
        0 => [a, b + (c - a), a + (b - c), c, c, a], // nearly a cusp, and a handle of length 0
        1 => [a, tip, tip, b, c, c],
        2 => [a, a, a, b, b, b],
        3 => [a, a + (b - a) * 2.0, b - (b - a) * 1.5, b, b, c], // turns back on a line
        4 => [a, a + (b - a) * 3.0, a + (c - a) * 3.0, a, c, b], // a loop that closes
        _ => [a, DVec2::new(b.x, a.y), DVec2::new(a.x, b.y), b, b, a], // a line, and a crossing over
    };
    closed(&points, 3)
}

fn high_degrees(random: &mut Rng) -> Path {
    let (count, degree) = (1 + random.below(2), 4 + random.below(5));
    closed(&spots(random, count * degree), degree)
}

/// Open and closed subpaths with coordinates of many sizes, points that coincide, and segments of length 0.
pub(crate) fn mixed_scales(random: &mut Rng) -> Path {
    let count = 1 + random.below(4);
    let subpath = |_| {
        let (degree, segments) = (1 + random.below(4), 1 + random.below(4));
        let closed = random.chance(0.5);
        let mut points: Vec<DVec2> = Vec::new();
        for _ in 0..degree * segments + usize::from(!closed) {
            let size = random.magnitude(-14.0, 14.0);
            let next = match (random.below(4), points.last()) {
                (0, Some(&last)) => last,
                (1, Some(&last)) => last + random.spot(size * 1e-9),
                (2, Some(_)) => random.pick(&points),
                _ => random.spot(size),
            };
            points.push(next);
        }
        Spline::new(&points, degree, closed).expect("valid points")
    };
    (0..count).map(subpath).collect()
}
