//! Winding numbers, compared with the sum of the angles under which a fine polygon is seen, and for partitions of the
//! plane.

use crate::support::measure::from_segment;
use crate::support::paths::{RandomPlane, path, polygons, random_splines, sides};
use crate::support::{Rng, adversarial, real};
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::FillRule;
use casteljau::{Curve, Path, Spline};
use std::f64::consts::TAU;

/// Outlines for the queries: a letter with two holes, a leaf, a spiral of arcs, open subpaths, self-intersecting
/// shapes.
pub(crate) const OUTLINES: [&str; 8] = [
    // A letter B.
    "M10 0V70H36C50 70 58 62 58 52 58 44 54 39 47 37 56 35 62 29 62 19 62 7 53 0 38 0Z\
     M22 40H35C42 40 46 44 46 50S42 60 35 60H22ZM22 10H37C45 10 50 14 50 20S45 30 37 30H22Z",
    // A leaf of quadratics.
    "M0 0Q5 20 30 25 60 30 70 0 60-20 40-22T0 0z",
    // A gear wheel, roughly.
    "m20 0a20 20 0 01-4 12l4 6-6 5-6-4a20 20 0 01-14 0l-6 4-6-5 4-6a20 20 0 010-24l-4-6 6-5 6 4a20 20 0 0114 0l6-4 6 5-4 6a20 20 0 014 12z\
     M8 0A8 8 0 10-8 0 8 8 0 108 0z",
    // Open subpaths, which are filled as if closed.
    "M0 0C10 40 50 40 60 0L40 10M70 0L80 0 75 10",
    // A self-intersecting star, and a figure of eight.
    "M0 30L18-24-28 10H28L-18-24Z",
    "M0 0C40 40 40-40 0 0C-40 40-40-40 0 0Z",
    // Twice around.
    "M0 0H30V30H0V5H25V25H5V0Z M10 10H20V20H10Z",
    // Horizontal and vertical segments at equal heights, steps, segments of length 0.
    "M0 0H10V10H20V0H30V20H20V20H20V30H10V20H0V20V10H0Z",
];

fn angle_sum(rings: &[Vec<DVec2>], p: DVec2) -> f64 {
    let sides = rings.iter().flat_map(|ring| sides(ring));
    sides.map(|(a, b)| (a - p).angle_to(b - p)).sum()
}

fn distance(rings: &[Vec<DVec2>], p: DVec2) -> f64 {
    let sides = rings.iter().flat_map(|ring| sides(ring));
    let distances = sides.map(|(a, b)| from_segment(p, a, b));
    distances.fold(f64::INFINITY, f64::min)
}

/// Queries random points, points with the x or y of a control point or of the bounds, and points beside control points.
fn ask(path: &Path, rng: &mut Rng, questions: usize) {
    let bounds = path.control_bounds().expect("not empty");
    let size = bounds.diagonal();
    let tolerance = 1e-5 * size;
    let rings = polygons(path, tolerance);
    let corners = path.subpaths().map(|s| s.control_points().to_vec());
    let corners = corners.collect::<Vec<_>>().concat();
    for _ in 0..questions {
        let part = rng.spot(0.6) + 0.5;
        let random = bounds.min + (bounds.max - bounds.min) * part;
        let corner = rng.pick(&corners);
        let height = path.bounds().expect("not empty");
        let p = match rng.below(5) {
            0 => DVec2::new(random.x, corner.y),
            1 => DVec2::new(corner.x, random.y),
            2 => DVec2::new(corner.x + size * 1e-3 * rng.signed(), corner.y),
            3 => DVec2::new(random.x, rng.pick(&[height.min.y, height.max.y])),
            _ => random,
        };
        if distance(&rings, p) <= 2.0 * tolerance {
            continue;
        }
        let turns = angle_sum(&rings, p) / TAU;
        assert!((turns - turns.round()).abs() < 1e-6, "{turns}");
        let winding = path.winding_number(p);
        assert_eq!(f64::from(winding), turns.round(), "{p} in {path:?}");
        assert_eq!(path.contains(p, FillRule::NonZero), winding != 0);
        let is_odd = winding.rem_euclid(2) == 1;
        assert_eq!(path.contains(p, FillRule::EvenOdd), is_odd);
    }
}

#[test]
fn outlines_wind_as_their_polygons_do() {
    let mut rng = Rng(21);
    let (scale, by) = (DVec2::new(2.0, -0.5), DVec2::new(-30.0, 100.0));
    for d in OUTLINES {
        let path = path(d);
        ask(&path, &mut rng, 400);
        let map = DAffine2::from_scale_angle_translation(scale, 0.7, by);
        ask(&(map * &path), &mut rng, 100);
        ask(&path.reverse(), &mut rng, 100);
        for scale in [1e-9, 1e9] {
            let map = DAffine2::from_scale(DVec2::splat(scale));
            ask(&(map * &path), &mut rng, 50);
        }
    }
}

#[test]
fn random_paths_wind_as_their_polygons_do() {
    let mut rng = Rng(22);
    for _ in 0..1_000 {
        let count = 1 + rng.below(3);
        let path = Path::new(&random_splines(&mut rng, count));
        let bounds = path.control_bounds().expect("points");
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        if bounds.diagonal() > 1e-6 * largest {
            ask(&path, &mut rng, 20);
        }
    }
}

/// A grid of N × N cells with curved edges: the cells as paths, the outline, and all edges.
fn curved_cells(rng: &mut Rng, on_grid: bool) -> (Vec<Path>, Path, Vec<Curve<DVec2>>) {
    let mut node = |i: usize, j: usize| {
        let jitter = rng.spot(if on_grid { 0.0 } else { 0.3 });
        DVec2::new(real(i), real(j)) + jitter
    };
    let nodes: [[DVec2; N + 1]; N + 1] =
        std::array::from_fn(|j| std::array::from_fn(|i| node(i, j)));
    let rows: [[_; N]; N + 1] = std::array::from_fn(|j| {
        std::array::from_fn(|i| side(rng, nodes[j][i], nodes[j][i + 1], on_grid))
    });
    let columns: [[_; N + 1]; N] = std::array::from_fn(|j| {
        std::array::from_fn(|i| side(rng, nodes[j][i], nodes[j + 1][i], on_grid))
    });
    let closed =
        |curves: &[Curve<DVec2>]| Path::from(Spline::from_curves(curves, true).expect("a ring"));
    let cell = |i: usize, j: usize| {
        closed(&[
            rows[j][i].clone(),
            columns[j][i + 1].clone(),
            rows[j + 1][i].reverse(),
            columns[j][i].reverse(),
        ])
    };
    let cells = (0..N * N).map(|k| cell(k % N, k / N)).collect();
    let mut around: Vec<Curve<DVec2>> = rows[0].to_vec();
    around.extend(columns.iter().map(|row| row[N].clone()));
    around.extend(rows[N].iter().rev().map(Curve::reverse));
    around.extend(columns.iter().rev().map(|row| row[0].reverse()));
    let outline = closed(&around);
    let sides = rows.into_iter().flatten();
    let sides = sides.chain(columns.into_iter().flatten());
    (cells, outline, sides.collect())
}

/// A curve from a to b, of a random degree.
fn side(rng: &mut Rng, a: DVec2, b: DVec2, on_grid: bool) -> Curve<DVec2> {
    let degree = rng.pick(&[1, 1, 2, 3, 5]);
    let size = if on_grid { 0.25 } else { 0.4 };
    let inner =
        (1..degree).map(|k| a.lerp(b, real(k) / real(degree)) + rng.spot(size * 8.0).round() / 8.0);
    let points: Vec<DVec2> = std::iter::once(a).chain(inner).chain([b]).collect();
    Curve::new(&points).expect("finite")
}

/// The number of cells along each axis.
const N: usize = 4;

/// A partition into cells that share curved edges: every point of the plane lies in as many cells as the winding number
/// of the outline states, also on the edges.
#[test]
fn parts_of_the_plane_share_no_point_and_leave_none() {
    let mut rng = Rng(23);
    for case in 0..150 {
        let (cells, outline, sides) = curved_cells(&mut rng, case % 2 == 0);
        let check = |p: DVec2| {
            let sum: i32 = cells.iter().map(|cell| cell.winding_number(p)).sum();
            assert_eq!(sum, outline.winding_number(p), "case {case}: {p}");
        };
        for curve in sides {
            for t in [0.0, 0.125, 0.3, 0.5, 0.75, 0.9, 1.0] {
                let p = curve.eval(t);
                check(p);
                check(DVec2::new(p.x.next_up(), p.y));
                check(DVec2::new(p.x, p.y.next_down()));
            }
        }
        for _ in 0..50 {
            check(DVec2::new(rng.unit() * real(N), rng.unit() * real(N)));
        }
    }
}

#[test]
fn on_the_boundary_left_and_lower_sides_belong_to_the_inside() {
    let curved = "M0 0L2 0 4 0 4 4Q2 4 0 4C0 3 0 1 0 0Z";
    for d in ["M0 0H4V4H0Z", "M0 0V4H4V0Z", curved] {
        let square = path(d);
        let inside = |(x, y): (f64, f64)| square.contains(DVec2::new(x, y), FillRule::NonZero);
        let (least, last) = (f64::MIN_POSITIVE, 4.0_f64.next_down());
        let yes = [
            (0.0, 2.0),
            (2.0, 0.0),
            (0.0, 0.0),
            (least, 3.0),
            (last, 3.0),
        ];
        let no = [(4.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)];
        assert!(yes.into_iter().all(inside), "{d}");
        assert!(!no.into_iter().any(inside), "{d}");
        assert!(!inside((-5e-324, 3.0)) && !inside((2.0, -5e-324)), "{d}");
    }
}

#[test]
fn points_not_finite_are_outside() {
    let square = path("M0 0H4V4H0Z");
    for x in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        assert_eq!(square.winding_number(DVec2::new(x, 2.0)), 0);
        assert_eq!(square.winding_number(DVec2::new(2.0, x)), 0);
    }
    assert_eq!(Path::default().winding_number(DVec2::ZERO), 0);
    assert!(!Path::default().contains(DVec2::ZERO, FillRule::EvenOdd));
}

#[test]
fn winding_numbers_of_adversarial_curves_do_not_pass_their_degree() {
    let mut rng = Rng(24);
    for _ in 0..20_000 {
        let kind = rng.pick(&adversarial::ALL);
        let degree = rng.pick(&[1, 2, 3, 3, 5, 16, 64]);
        let points = adversarial::points(&mut rng, kind, degree, 2);
        let points: Vec<DVec2> = points.iter().map(|p| p.truncate()).collect();
        let curve = Curve::new(&points).expect("finite");
        let path = Path::from(curve.clone());
        // On the curve the last digits decide.
        let winding = path.winding_number(curve.eval(rng.unit()));
        assert!(winding.unsigned_abs() <= 64, "{kind:?}");
        path.winding_number(rng.pick(&points));
    }
}
