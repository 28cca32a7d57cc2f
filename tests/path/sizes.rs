//! Areas, moments, arc lengths and bounding boxes, under affine maps and compared with polygons.

use crate::path::inside::OUTLINES;
use crate::support::paths::{RandomPlane, closed, path, polygons, random_splines, sides};
use crate::support::{Rng, near, real};
use casteljau::curve::Moments;
use casteljau::glam::{DAffine2, DMat2, DVec2};
use casteljau::path::{PathIntersection, PathPoint, PathTime};
use casteljau::{Curve, Path, Spline};

/// The moments of polygons, by triangles from the origin to each side.
fn polygon_moments(rings: &[Vec<DVec2>]) -> Moments {
    let mut sum = Moments::default();
    for (a, b) in rings.iter().flat_map(|ring| sides(ring)) {
        let area = 0.5 * (a.x * b.y - b.x * a.y);
        sum += Moments {
            area,
            x: area * (a.x + b.x) / 3.0,
            y: area * (a.y + b.y) / 3.0,
            xx: area * (a.x * a.x + a.x * b.x + b.x * b.x) / 6.0,
            xy: area * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 12.0,
            yy: area * (a.y * a.y + a.y * b.y + b.y * b.y) / 6.0,
        };
    }
    sum
}

fn numbers(m: Moments) -> [f64; 6] {
    [m.area, m.x, m.y, m.xx, m.xy, m.yy]
}

pub(super) fn paths() -> Vec<Path> {
    let mut rng = Rng(31);
    let random = (0..200).map(|_| {
        let count = 1 + rng.below(3);
        Path::new(&random_splines(&mut rng, count))
    });
    OUTLINES.iter().map(|d| path(d)).chain(random).collect()
}

fn length(path: &Path) -> f64 {
    path.length()
}

#[test]
fn moments_are_those_of_fine_polygons() {
    for path in paths() {
        let size = path.max_coordinate().max(1e-300);
        let tolerance = 1e-6 * size;
        let rings = polygons(&path, tolerance);
        let chords = rings.iter().flat_map(|ring| ring.windows(2));
        let around: f64 = chords.map(|pair| pair[0].distance(pair[1])).sum();
        // The error is at most a strip of the tolerance's width along the outline, at the maximum distance from the
        // origin.
        let strip = 1.1 * tolerance * (around + size);
        let powers = [1.0, size, size, size * size, size * size, size * size];
        let (got, expected) = (numbers(path.moments()), numbers(polygon_moments(&rings)));
        for k in 0..6 {
            near(got[k], expected[k], strip * powers[k]);
        }
        near(path.area(), got[0], 1e-14 * size * size);
        let length = length(&path);
        let range = around * (1.0 - 1e-12)..=around + 1e-3 * (around + size);
        assert!(range.contains(&length), "{length} {around}");
        let rough = path.length_within(1e-3 * size).expect("a tolerance");
        near(rough, length, 1e-3 * size + 1e-12 * length);
    }
}

pub(super) trait Largest {
    fn max_coordinate(&self) -> f64;
}

impl Largest for Path {
    fn max_coordinate(&self) -> f64 {
        self.control_bounds()
            .map_or(0.0, |b| b.min.abs().max(b.max.abs()).max_element())
    }
}

#[test]
fn areas_follow_maps_by_their_determinant() {
    let mut rng = Rng(32);
    for path in paths() {
        let matrix = DMat2::from_cols(rng.spot(3.0), rng.spot(3.0));
        let by = rng.spot(1000.0);
        let image = DAffine2::from_mat2_translation(matrix, by) * &path;
        let (m, n) = (path.moments(), image.moments());
        let size = image.max_coordinate();
        near(n.area, m.area * matrix.determinant(), 1e-11 * size * size);
        near(image.area(), n.area, 1e-12 * size * size);
        // ∬ p over the image is det · (M ∬ p + area · by).
        let first = (matrix * DVec2::new(m.x, m.y) + by * m.area) * matrix.determinant();
        near(n.x, first.x, 1e-11 * size.powi(3));
        near(n.y, first.y, 1e-11 * size.powi(3));
        let (back, own) = (path.reverse(), path.max_coordinate());
        near(back.area(), -path.area(), 1e-14 * own * own);
        assert_eq!(back.reverse(), path);
        near(length(&back), length(&path), 1e-12 * length(&path));
    }
}

#[test]
fn far_from_the_origin_nothing_is_lost() {
    let letter = path(OUTLINES[0]);
    let by = DVec2::new(2_f64.powi(30), -(2_f64.powi(31)));
    let far = DAffine2::from_translation(by) * &letter;
    near(far.area(), letter.area(), 1e-9 * letter.area().abs());
    let (m, n) = (letter.moments(), far.moments());
    near(n.x / n.area - by.x, m.x / m.area, 1e-5);
    near(n.y / n.area - by.y, m.y / m.area, 1e-5);
}

#[test]
fn sizes_beyond_f64_are_infinite_and_never_nan() {
    let mut rng = Rng(33);
    for _ in 0..2_000 {
        let scale = rng.pick(&[1e150, 1e120, 1e-200, 5e-324, 1e100, 0.0]);
        let points = [(); 6].map(|()| rng.spot(2.0).round() * scale);
        let path = closed(&points, 3);
        let numbers = numbers(path.moments()).into_iter();
        let mut numbers = numbers.chain([path.area(), length(&path)]);
        assert!(numbers.all(|number| !number.is_nan()), "{points:?}");
        let bounds = path.bounds().expect("not empty");
        assert!(bounds.min.is_finite() && bounds.max.is_finite());
    }
}

#[test]
fn boxes_hold_their_path_and_touch_it() {
    for path in paths() {
        let [exact, loose] = [path.bounds(), path.control_bounds()].map(|b| b.expect("not empty"));
        assert!(loose.min.cmple(exact.min).all() && loose.max.cmpge(exact.max).all());
        let points = samples(&path, 64);
        let noise = 1e-15 * path.max_coordinate();
        let min = points.iter().copied().reduce(DVec2::min).expect("points");
        let max = points.iter().copied().reduce(DVec2::max).expect("points");
        let gaps = [min - exact.min, exact.max - max];
        // 64 steps per segment are close enough.
        let close = exact.diagonal().max(noise) * 0.05;
        for gap in gaps {
            assert!(gap.min_element() >= -noise && gap.max_element() <= close);
        }
    }
    assert_eq!(Path::default().bounds(), None);
}

fn samples(path: &Path, count: usize) -> Vec<DVec2> {
    let samples = |spline: Spline<DVec2>| spline.sample(count).expect("few");
    path.subpaths().flat_map(samples).collect()
}

#[test]
fn polylines_and_reversed_paths_are_those_of_the_splines() {
    let mut rng = Rng(34);
    for _ in 0..500 {
        let count = rng.below(4);
        let splines = random_splines(&mut rng, count);
        let path = Path::new(&splines);
        let (lines, back) = (path.flatten(1e-2).expect("a tolerance"), path.reverse());
        for (k, spline) in splines.iter().enumerate() {
            assert_eq!(Ok(&lines[k]), spline.flatten(1e-2).as_ref());
            assert_eq!(back.subpath(k), Some(spline.reverse()));
        }
        if !splines.is_empty() {
            let moved = DAffine2::from_translation(DVec2::splat(1e-3)) * &path;
            assert!(path.approx_eq(&moved, 2e-3) && !path.approx_eq(&moved, 1e-4));
            assert!(!path.approx_eq(&Path::new(&splines[1..]), 1000.0));
        }
    }
}

#[test]
fn nothing_is_nearer_than_the_nearest_point() {
    let mut rng = Rng(35);
    for path in paths() {
        let (samples, size) = (samples(&path, 200), path.max_coordinate());
        for _ in 0..20 {
            let p = match rng.below(3) {
                0 => rng.pick(&samples),
                1 => rng.pick(&samples) + rng.spot(size * 0.1),
                _ => rng.spot(size * 2.0),
            };
            let nearest = path.nearest(p).expect("finite").expect("not empty");
            let distances = samples.iter().map(|q| q.distance(p));
            let off = nearest.distance - distances.fold(f64::INFINITY, f64::min);
            assert!(off <= 1e-12 * size, "{p}: {off}");
            let spline = path.subpath(nearest.subpath).expect("a spline");
            let off = spline.eval(nearest.t).distance(nearest.point);
            assert!(off <= 1e-14 * size, "{p}");
            near(nearest.point.distance(p), nearest.distance, 4e-15 * size);
        }
        assert!(path.nearest(DVec2::new(f64::NAN, 0.0)).is_err());
    }
    assert_eq!(Path::default().nearest(DVec2::ZERO), Ok(None));
}

/// The arc length of a spline from its start to t, segment by segment.
fn length_up_to(spline: &Spline<DVec2>, t: f64) -> f64 {
    let length = |curve: Curve<DVec2>| curve.length();
    let count = spline.segment_count();
    let k = (0..count).rfind(|&k| real(k) <= t).unwrap_or(0);
    let full: f64 = spline.segments().take(k).map(length).sum();
    let last = spline.segment(k).expect("a segment");
    full + length(last.subsegment(0.0..t - real(k)))
}

#[test]
fn times_by_length_have_that_length_behind_them() {
    let mut rng = Rng(36);
    for path in paths() {
        let whole = length(&path);
        let splines = path.subpaths().collect::<Vec<_>>();
        let lengths: Vec<f64> = splines.iter().map(Spline::length).collect();
        let slack = 1e-9 * whole + 1e-14 * path.max_coordinate();
        let assert_behind = |time: PathTime, expected: f64| {
            let before: f64 = lengths[..time.subpath].iter().sum();
            let behind = before + length_up_to(&splines[time.subpath], time.t);
            near(behind, expected, slack);
        };
        for _ in 0..10 {
            let s = rng.unit() * whole;
            let time = path.time_at_length(s);
            assert_behind(time.expect("not empty"), s);
        }
        let count = 1 + rng.below(20);
        let times = path.equidistant_times(count).expect("few");
        assert_eq!(times.len(), count + 1);
        assert_eq!(times[0], PathTime { subpath: 0, t: 0.0 });
        let subpath = splines.len() - 1;
        let t = real(splines[subpath].segment_count());
        assert_eq!(times[count], PathTime { subpath, t });
        for (i, &time) in times.iter().enumerate() {
            assert_behind(time, whole * real(i) / real(count));
        }
    }
}

#[test]
fn times_on_paths_without_length() {
    assert_eq!(Path::default().time_at_length(1.0), None);
    assert_eq!(Path::default().equidistant_times(3), Ok(Vec::new()));
    let (dot, subpath) = (path("M1 1ZM2 2Z"), 1);
    let times = dot.equidistant_times(2).expect("few");
    assert_eq!(times[1], PathTime { subpath, t: 0.0 });
    let time = dot.time_at_length(5.0);
    assert_eq!(time, Some(PathTime { subpath, t: 1.0 }));
}

#[test]
fn paths_intersect_where_their_splines_do() {
    let mut rng = Rng(37);
    for _ in 0..200 {
        let [ours, theirs] = [(); 2].map(|()| {
            let count = rng.below(4);
            random_splines(&mut rng, count)
        });
        let (a, b) = (Path::new(&ours), Path::new(&theirs));
        let mut expected = Vec::new();
        for (i, one) in ours.iter().enumerate() {
            for (j, other) in theirs.iter().enumerate() {
                let found = one.intersections(other).into_iter();
                expected.extend(found.map(|m| (i, j, m.t, m.u, m.point)));
            }
        }
        let got = a.intersections(&b).into_iter();
        let fields = |m: PathIntersection| (m.subpath, m.other_subpath, m.t, m.u, m.point);
        assert_eq!(got.map(fields).collect::<Vec<_>>(), expected);
        let own = ours.iter().flat_map(Spline::self_intersections);
        let selves = a.self_intersections();
        let same = selves.iter().filter(|m| m.subpath == m.other_subpath);
        assert!(same.map(|m| m.point).eq(own.map(|m| m.point)));
        let ordered = |m: &PathIntersection| (m.subpath, m.t) < (m.other_subpath, m.u);
        assert!(selves.iter().all(ordered));
    }
}

#[test]
fn the_nearest_of_several_paths() {
    let centers = (0..60).map(|k| DVec2::new(real(k % 10), real(k / 10)) * 20.0);
    let mut paths: Vec<Path> = centers
        .map(|center| Path::circle(center, 9.0).expect("a circle"))
        .collect();
    paths.insert(0, Path::default());
    for p in [(0.0, 0.0), (10.0, 10.0), (33.0, 71.0), (-50.0, 60.0)].map(DVec2::from) {
        let all = paths.iter().enumerate().filter_map(|(index, path)| {
            let found = path.nearest(p).expect("finite")?;
            Some((index, found))
        });
        let first = |best: (usize, PathPoint), other: (usize, PathPoint)| {
            if other.1.distance < best.1.distance {
                other
            } else {
                best
            }
        };
        let expected = all.reduce(first).expect("a path");
        let found = |limit: f64| Path::nearest_of(&paths, p, limit).expect("finite");
        assert_eq!(found(f64::INFINITY), Some(expected));
        assert_eq!(found(expected.1.distance), Some(expected));
        assert_eq!(found(0.999 * expected.1.distance), None);
    }
    assert_eq!(Path::nearest_of([], DVec2::ZERO, 1.0), Ok(None));
    for limit in [-1.0, f64::NAN] {
        assert!(Path::nearest_of(&paths, DVec2::ZERO, limit).is_err());
    }
    assert!(Path::nearest_of(&paths, DVec2::NAN, 1.0).is_err());
}
