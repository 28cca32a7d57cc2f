//! Pairs of paths of the families that Boolean operations get wrong.

use crate::path_boolean::random::Random;
use casteljau::Path;
use casteljau::Spline;
use casteljau::glam::{DAffine2, DVec2};
use std::f64::consts::{PI, TAU};

pub(crate) type Family = fn(&mut Random) -> (Path, Path);

/// The families: name, generator, and whether outlines may nearly coincide.
pub(crate) const FAMILIES: [(&str, Family, bool); 16] = [
    ("blobs", blobs, false),
    ("scribbles", scribbles, false),
    ("turned", turned, true),
    ("moved", moved, true),
    ("shared segments", shared_segments, false),
    ("partial overlap", partial_overlap, false),
    ("tangent circles", tangent_circles, false),
    ("touching", touching, false),
    ("nested", nested, false),
    ("grids", grids, false),
    ("glyphs", glyphs, false),
    ("lattice", lattice, false),
    ("stars", stars, true),
    ("slivers", slivers, true),
    ("cusps", cusps, false),
    ("high degrees", high_degrees, false),
];

fn closed(points: &[DVec2], degree: usize) -> Path {
    Path::from(Spline::new(points, degree, true).expect("valid points"))
}

fn join(paths: impl IntoIterator<Item = Path>) -> Path {
    paths
        .into_iter()
        .flat_map(|path| path.subpaths().collect::<Vec<_>>())
        .collect()
}

fn polygon(points: &[(f64, f64)]) -> Path {
    closed(&points.iter().map(|&p| p.into()).collect::<Vec<_>>(), 1)
}

fn rect(x: f64, y: f64, w: f64, h: f64) -> Path {
    polygon(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h)])
}

/// Four cubics.
fn circle(centre: DVec2, radius: f64) -> Path {
    const K: f64 = 0.551_784_777_797_922;
    let points: Vec<DVec2> = (0..4)
        .flat_map(|k| {
            let (c, s) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][k];
            let (out, along) = (DVec2::new(c, s), DVec2::new(-s, c));
            [out, out + along * K, along + out * K].map(|p| centre + p * radius)
        })
        .collect();
    closed(&points, 3)
}

/// A smooth closed curve around a point.
fn blob(random: &mut Random, centre: DVec2, size: f64, count: usize) -> Path {
    let radius: Vec<f64> = (0..count)
        .map(|_| random.between(0.4, 1.0) * size)
        .collect();
    let at =
        |k: usize| centre + DVec2::from_angle(TAU * k as f64 / count as f64) * radius[k % count];
    let tangent = |k: usize| (at(k + 1) - at((k + count - 1) % count)) / 6.0;
    let points: Vec<DVec2> = (0..count)
        .flat_map(|k| {
            [
                at(k),
                at(k) + tangent(k),
                at((k + 1) % count) - tangent((k + 1) % count),
            ]
        })
        .collect();
    closed(&points, 3)
}

fn blobs(random: &mut Random) -> (Path, Path) {
    let (n, m) = (3 + random.below(6), 3 + random.below(6));
    let offset = random.point(0.6);
    (
        blob(random, DVec2::ZERO, 1.0, n),
        blob(random, offset, 1.0, m),
    )
}

/// Closed curves of random control points, which cross themselves.
fn scribble(random: &mut Random) -> Path {
    let (count, degree) = (1 + random.below(4), 1 + random.below(4));
    let count = if degree < 3 { count + 2 } else { count };
    let points: Vec<DVec2> = (0..count * degree).map(|_| random.point(1.0)).collect();
    closed(&points, degree)
}

fn scribbles(random: &mut Random) -> (Path, Path) {
    (scribble(random), scribble(random))
}

fn any(random: &mut Random) -> Path {
    match random.below(4) {
        0 => blob(random, DVec2::ZERO, 1.0, 5),
        1 => scribble(random),
        2 => glyph(random),
        _ => rect(-1.0, -0.7, 2.0, 1.4),
    }
}

/// A shape and itself, turned by a small angle.
fn turned(random: &mut Random) -> (Path, Path) {
    let shape = any(random);
    let angle = 10.0_f64.powf(random.between(-12.0, -3.0));
    let map = DAffine2::from_angle(angle);
    let other = shape.transform(&map).expect("a finite image");
    (shape, other)
}

/// A shape and itself, moved by a small distance.
fn moved(random: &mut Random) -> (Path, Path) {
    let shape = any(random);
    let by =
        DVec2::from_angle(random.between(0.0, TAU)) * 10.0_f64.powf(random.between(-16.0, -2.0));
    let by = if random.below(3) == 0 {
        DVec2::new(by.x, 0.0)
    } else {
        by
    };
    let other = shape
        .transform(&DAffine2::from_translation(by))
        .expect("a finite image");
    (shape, other)
}

/// Two outlines with some common segments, in either direction.
fn shared_segments(random: &mut Random) -> (Path, Path) {
    let count = 4 + random.below(5);
    let a = blob(random, DVec2::ZERO, 1.0, count);
    let b = blob(random, random_offset(), 1.0, count);
    let (p, q) = (points_of(&a), points_of(&b));
    let shared = 1 + random.below(count - 1);
    let mut points = p[..=3 * shared].to_vec();
    points.extend(&q[3 * shared + 1..]);
    let other = closed(&points, 3);
    (
        a,
        if random.below(2) == 0 {
            other
        } else {
            other.reverse()
        },
    )
}

fn random_offset() -> DVec2 {
    DVec2::new(0.1, 0.05)
}

fn points_of(path: &Path) -> Vec<DVec2> {
    path.subpath(0)
        .expect("a subpath")
        .control_points()
        .to_vec()
}

/// Outlines that share a part of a curve.
fn partial_overlap(random: &mut Random) -> (Path, Path) {
    let curve: Vec<DVec2> = match random.below(2) {
        0 => vec![
            DVec2::new(-1.0, 0.0),
            DVec2::new(-0.3, random.between(-1.0, 1.0)),
            DVec2::new(0.4, 0.6),
            DVec2::new(1.0, 0.0),
        ],
        _ => vec![DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)],
    };
    let curve = casteljau::Curve::new(&curve).expect("a curve");
    let part = |random: &mut Random| {
        let (from, to) = (random.between(0.0, 0.45), random.between(0.55, 1.0));
        let piece = curve.subsegment(from, to);
        let mut points = piece.control_points().to_vec();
        let tip = DVec2::new(random.between(-0.5, 0.5), random.between(-2.0, 2.0));
        let end = piece.end();
        let degree = points.len() - 1;
        let mut spline = vec![casteljau::Curve::new(&points).expect("a curve")];
        spline.push(casteljau::Curve::new(&[end, tip]).expect("a line"));
        points.truncate(1);
        spline.push(casteljau::Curve::new(&[tip, points[0]]).expect("a line"));
        assert!(degree > 0);
        Path::from(Spline::from_curves(&spline, true).expect("joined"))
    };
    (part(random), part(random))
}

fn tangent_circles(random: &mut Random) -> (Path, Path) {
    let (r, s) = (
        [1.0, 0.5, 0.75][random.below(3)],
        [0.25, 0.5, 1.0][random.below(3)],
    );
    let direction = if random.below(2) == 0 {
        [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y][random.below(4)]
    } else {
        DVec2::from_angle(random.between(0.0, TAU))
    };
    let distance = if random.below(2) == 0 { r + s } else { r - s };
    (circle(DVec2::ZERO, r), circle(direction * distance, s))
}

/// Shapes that touch in points.
fn touching(random: &mut Random) -> (Path, Path) {
    let tip = random.point(0.5);
    let triangle = |random: &mut Random, from: f64| {
        let angle = from + random.between(0.0, 0.5);
        let (a, b) = (
            DVec2::from_angle(angle),
            DVec2::from_angle(angle + random.between(0.3, 1.2)),
        );
        closed(&[tip, tip + a, tip + b], 1)
    };
    let a = join([triangle(random, 0.0), triangle(random, PI * 0.6)]);
    let b = join([triangle(random, PI), triangle(random, PI * 1.5)]);
    (
        a,
        if random.below(2) == 0 {
            b
        } else {
            join([b, rect(tip.x, tip.y - 1.0, 1.0, 2.0)])
        },
    )
}

fn nested(random: &mut Random) -> (Path, Path) {
    let rings = |random: &mut Random, offset: f64| {
        let count = 1 + random.below(5);
        join((0..count).map(|k| {
            let ring = circle(DVec2::ZERO, 1.0 - offset - 0.17 * k as f64);
            if random.below(2) == 0 {
                ring
            } else {
                ring.reverse()
            }
        }))
    };
    let offset = [0.0, 0.05, 0.17][random.below(3)];
    (rings(random, 0.0), rings(random, offset))
}

fn grids(random: &mut Random) -> (Path, Path) {
    let bars = |random: &mut Random, upright: bool| {
        let count = 2 + random.below(5);
        let step = 2.0 / count as f64;
        let width = step * [0.5, 1.0, 0.25][random.below(3)];
        join((0..count).map(|k| {
            let from = -1.0 + step * k as f64;
            if upright {
                rect(from, -1.0, width, 2.0)
            } else {
                rect(-1.0, from, 2.0, width)
            }
        }))
    };
    let upright = random.below(2) == 0;
    (bars(random, true), bars(random, upright))
}

/// A letter: a bowl with a counter, a stem, an accent, with coordinates of a font.
fn glyph(random: &mut Random) -> Path {
    let unit = 1.0 / 1000.0;
    let at = |x: i32, y: i32| DVec2::new(f64::from(x), f64::from(y)) * unit;
    let stem = random.integer(120) + 60;
    let bowl = |w: i32, h: i32| {
        let k = 0.55;
        let (w, h) = (f64::from(w), f64::from(h));
        let points: Vec<DVec2> = [
            (w, 0.0),
            (w, h * k),
            (w * k, h),
            (0.0, h),
            (-w * k, h),
            (-w, h * k),
            (-w, 0.0),
            (-w, -h * k),
            (-w * k, -h),
            (0.0, -h),
            (w * k, -h),
            (w, -h * k),
        ]
        .iter()
        .map(|&(x, y)| DVec2::new(x.round(), y.round()) * unit)
        .collect();
        closed(&points, 3)
    };
    let (w, h) = (300 + random.integer(200), 300 + random.integer(300));
    let post = closed(
        &[
            at(w - stem, -h),
            at(w, -h),
            at(w, h + 200),
            at(w - stem, h + 200),
        ],
        1,
    );
    join([bowl(w, h), bowl(w - stem, h - stem / 2).reverse(), post])
}

fn glyphs(random: &mut Random) -> (Path, Path) {
    let (a, b) = (glyph(random), glyph(random));
    let by = DVec2::new(random.below(400) as f64, random.below(200) as f64) / 1000.0;
    (
        a,
        b.transform(&DAffine2::from_translation(by))
            .expect("a finite image"),
    )
}

/// Polygons and curves with small integer coordinates, so that points and segments often coincide.
fn lattice(random: &mut Random) -> (Path, Path) {
    let shape = |random: &mut Random| {
        let degree = [1, 1, 2, 3][random.below(4)];
        let count = (3 + random.below(5)).max(2);
        let points: Vec<DVec2> = (0..count * degree)
            .map(|_| DVec2::new(random.below(5) as f64 - 2.0, random.below(5) as f64 - 2.0) / 2.0)
            .collect();
        closed(&points, degree)
    };
    (shape(random), shape(random))
}

/// Many contours through one point.
fn stars(random: &mut Random) -> (Path, Path) {
    let star = |random: &mut Random| {
        let count = 2 + random.below(8);
        join((0..count).map(|_| {
            let (a, b) = (random.between(0.0, TAU), random.between(0.1, 2.0));
            if random.below(2) == 0 {
                closed(
                    &[DVec2::ZERO, DVec2::from_angle(a), DVec2::from_angle(a + b)],
                    1,
                )
            } else {
                circle(DVec2::from_angle(a) * 0.5, 0.5)
            }
        }))
    };
    (star(random), star(random))
}

/// Long thin shapes.
fn slivers(random: &mut Random) -> (Path, Path) {
    let sliver = |random: &mut Random| {
        let (a, b) = (random.point(1.0), random.point(1.0));
        let width = 10.0_f64.powf(random.between(-8.0, -1.0));
        let across = (b - a).perp().normalize_or_zero() * width;
        let bulge = random.point(0.5);
        closed(
            &[
                a,
                a + bulge,
                b + bulge,
                b,
                b + across + bulge,
                a + across + bulge,
            ],
            3,
        )
    };
    (
        join([sliver(random), sliver(random)]),
        join([sliver(random), sliver(random)]),
    )
}

/// Curves with cusps, loops, turn-backs and control points that coincide.
fn cusps(random: &mut Random) -> (Path, Path) {
    let shape = |random: &mut Random| {
        let (a, b, c) = (random.point(1.0), random.point(1.0), random.point(1.0));
        let tip = a + b - c;
        let points = match random.below(6) {
            0 => vec![a, b + (c - a), a + (b - c), c, c, a], // nearly a cusp, and a handle of length 0
            1 => vec![a, tip, tip, b, c, c],
            2 => vec![a, a, a, b, b, b],
            3 => vec![a, a + (b - a) * 2.0, b - (b - a) * 1.5, b, b, c], // turns back on a line
            4 => vec![a, a + (b - a) * 3.0, a + (c - a) * 3.0, a, c, b], // a loop that closes
            _ => vec![a, DVec2::new(b.x, a.y), DVec2::new(a.x, b.y), b, b, a], // a line, and a crossing over
        };
        closed(&points, 3)
    };
    (shape(random), shape(random))
}

fn high_degrees(random: &mut Random) -> (Path, Path) {
    let shape = |random: &mut Random| {
        let (count, degree) = (1 + random.below(2), 4 + random.below(5));
        let points: Vec<DVec2> = (0..count * degree).map(|_| random.point(1.0)).collect();
        closed(&points, degree)
    };
    (shape(random), shape(random))
}

/// Open and closed subpaths with coordinates of many sizes, points that coincide, and segments of length 0.
pub(crate) fn mixed_scales(random: &mut Random) -> Path {
    let count = 1 + random.below(4);
    let subpath = |random: &mut Random| {
        let (degree, segments) = (1 + random.below(4), 1 + random.below(4));
        let closed = random.below(2) == 0;
        let mut points: Vec<DVec2> = Vec::new();
        for _ in 0..degree * segments + usize::from(!closed) {
            let size = 10.0_f64.powf(random.between(-14.0, 14.0));
            let next = match (random.below(4), points.last()) {
                (0, Some(&last)) => last,
                (1, Some(&last)) => last + random.point(size * 1e-9),
                (2, Some(_)) => points[random.below(points.len())],
                _ => random.point(size),
            };
            points.push(next);
        }
        Spline::new(&points, degree, closed).expect("valid points")
    };
    (0..count).map(|_| subpath(random)).collect()
}
