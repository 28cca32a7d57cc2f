//! Areas, moments, arc lengths and bounding boxes, under affine maps and compared with polygons.

use crate::path::inside::{OUTLINES, random_spline};
use crate::support::{Rng, real};
use casteljau::curve::Moments;
use casteljau::glam::{DAffine2, DMat2, DVec2};
use casteljau::path::PathTime;
use casteljau::{Curve, Path, Spline};

/// The moments of polygons, by triangles from the first point of each.
fn polygon_moments(rings: &[Vec<DVec2>]) -> Moments {
    let mut sum = Moments::default();
    for ring in rings {
        for pair in ring
            .windows(2)
            .chain([[ring[ring.len() - 1], ring[0]].as_slice()])
        {
            let [a, b] = [pair[0], pair[1]];
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
    }
    sum
}

fn numbers(m: Moments) -> [f64; 6] {
    [m.area, m.x, m.y, m.xx, m.xy, m.yy]
}

fn near(got: f64, expected: f64, max: f64, what: &str) {
    assert!(
        (got - expected).abs() <= max,
        "{what}: {got}, not {expected} within {max}"
    );
}

fn paths() -> Vec<Path> {
    let mut rng = Rng(31);
    let outlines = OUTLINES
        .iter()
        .map(|d| Path::from_svg(d).expect("an outline"));
    let random = (0..200).map(|_| {
        let splines: Vec<Spline<DVec2>> = (0..1 + rng.below(3))
            .map(|_| random_spline(&mut rng))
            .collect();
        Path::new(&splines)
    });
    outlines.chain(random.collect::<Vec<_>>()).collect()
}

#[test]
fn moments_are_those_of_fine_polygons() {
    for path in paths() {
        let size = path.max_coordinate().max(1e-300);
        let tolerance = 1e-6 * size;
        let lines = path.flatten(tolerance).expect("a tolerance");
        let rings: Vec<Vec<DVec2>> = lines.into_iter().map(|line| line.points).collect();
        let around: f64 = rings
            .iter()
            .flat_map(|ring| ring.windows(2))
            .map(|pair| pair[0].distance(pair[1]))
            .sum();
        // The error is at most a strip of the tolerance's width along the outline, at the maximum distance from the
        // origin.
        let strip = 1.1 * tolerance * (around + size);
        let powers = [1.0, size, size, size * size, size * size, size * size];
        let (got, expected) = (numbers(path.moments()), numbers(polygon_moments(&rings)));
        for k in 0..6 {
            near(got[k], expected[k], strip * powers[k], "moment");
        }
        near(path.area(), got[0], 1e-14 * size * size, "area");
        let length = path.length(None).expect("no tolerance");
        assert!(
            length >= around * (1.0 - 1e-12) && length <= around + 1e-3 * (around + size),
            "{length} {around}"
        );
        let rough = path.length(Some(1e-3 * size)).expect("a tolerance");
        near(
            rough,
            length,
            1e-3 * size + 1e-12 * length,
            "length with a tolerance",
        );
    }
}

trait Largest {
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
        let matrix = DMat2::from_cols(rng.point(2).truncate() * 3.0, rng.point(2).truncate() * 3.0);
        let by = rng.point(2).truncate() * 1000.0;
        let map = DAffine2::from_mat2_translation(matrix, by);
        let image = path.transform(&map).expect("a finite image");
        let (m, n) = (path.moments(), image.moments());
        let size = image.max_coordinate();
        near(
            n.area,
            m.area * matrix.determinant(),
            1e-11 * size * size,
            "area",
        );
        near(image.area(), n.area, 1e-12 * size * size, "area alone");
        // ∬ p over the image is det · (M ∬ p + area · by).
        let first = (matrix * DVec2::new(m.x, m.y) + by * m.area) * matrix.determinant();
        near(n.x, first.x, 1e-11 * size.powi(3), "x");
        near(n.y, first.y, 1e-11 * size.powi(3), "y");
        let back = path.reverse();
        near(
            back.area(),
            -path.area(),
            1e-14 * path.max_coordinate().powi(2),
            "reversed",
        );
        assert_eq!(back.reverse(), path);
        let length = path.length(None).expect("no tolerance");
        near(
            back.length(None).expect("no tolerance"),
            length,
            1e-12 * length,
            "length reversed",
        );
    }
}

#[test]
fn far_from_the_origin_nothing_is_lost() {
    let letter = Path::from_svg(OUTLINES[0]).expect("an outline");
    let by = DVec2::new(2_f64.powi(30), -(2_f64.powi(31)));
    let far = letter
        .transform(&DAffine2::from_translation(by))
        .expect("a finite image");
    near(
        far.area(),
        letter.area(),
        1e-9 * letter.area().abs(),
        "area",
    );
    let (m, n) = (letter.moments(), far.moments());
    near(n.x / n.area - by.x, m.x / m.area, 1e-5, "centre");
    near(n.y / n.area - by.y, m.y / m.area, 1e-5, "centre");
}

#[test]
fn sizes_beyond_f64_are_infinite_and_never_nan() {
    let mut rng = Rng(33);
    for _ in 0..2_000 {
        let scale = rng.pick(&[1e150, 1e120, 1e-200, 5e-324, 1e100, 0.0]);
        let points: Vec<DVec2> = (0..6)
            .map(|_| (rng.point(2).truncate() * 2.0).round() * scale)
            .collect();
        let path = Path::from(Spline::new(&points, 3, true).expect("six points"));
        for number in numbers(path.moments())
            .into_iter()
            .chain([path.area(), path.length(None).expect("no tolerance")])
        {
            assert!(!number.is_nan(), "{points:?}");
        }
        let bounds = path.bounds().expect("not empty");
        assert!(bounds.min.is_finite() && bounds.max.is_finite());
    }
}

#[test]
fn boxes_hold_their_path_and_touch_it() {
    for path in paths() {
        let (exact, loose) = (
            path.bounds().expect("not empty"),
            path.control_bounds().expect("not empty"),
        );
        assert!(loose.min.cmple(exact.min).all() && loose.max.cmpge(exact.max).all());
        let points: Vec<DVec2> = path
            .subpaths()
            .collect::<Vec<_>>()
            .iter()
            .flat_map(|s| s.sample(64).expect("few"))
            .collect();
        let noise = 1e-15 * path.max_coordinate();
        let (mut min, mut max) = (points[0], points[0]);
        for &p in &points {
            (min, max) = (min.min(p), max.max(p));
        }
        assert!(
            (min - exact.min).min_element() >= -noise && (exact.max - max).min_element() >= -noise
        );
        // 64 steps per segment are close enough.
        let close = exact.diagonal().max(noise) * 0.05;
        assert!(
            (min - exact.min).max_element() <= close && (exact.max - max).max_element() <= close
        );
    }
    assert_eq!(Path::default().bounds(), None);
}

#[test]
fn splines_in_and_out() {
    let mut rng = Rng(34);
    for _ in 0..500 {
        let splines: Vec<Spline<DVec2>> =
            (0..rng.below(4)).map(|_| random_spline(&mut rng)).collect();
        let path = Path::new(&splines);
        assert_eq!(path.subpaths().collect::<Vec<_>>(), splines);
        assert_eq!(path.subpath_count(), splines.len());
        assert_eq!(
            path.segment_count(),
            splines.iter().map(Spline::segment_count).sum::<usize>()
        );
        for (k, spline) in splines.iter().enumerate() {
            assert_eq!(path.subpath(k).as_ref(), Some(spline));
            let lines = path.flatten(1e-2).expect("a tolerance");
            assert_eq!(lines[k], spline.flatten(1e-2).expect("a tolerance"));
            assert_eq!(path.reverse().subpath(k), Some(spline.reverse()));
        }
        assert!(path.subpath(splines.len()).is_none());
        assert!(path.approx_eq(&path.clone(), 0.0));
        if !splines.is_empty() {
            let moved = path
                .transform(&DAffine2::from_translation(DVec2::splat(1e-3)))
                .expect("a finite image");
            assert!(path.approx_eq(&moved, 2e-3) && !path.approx_eq(&moved, 1e-4));
            assert!(!path.approx_eq(&Path::new(&splines[1..]), real(1000)));
        }
    }
}

#[test]
fn nothing_is_nearer_than_the_nearest_point() {
    let mut rng = Rng(35);
    for path in paths() {
        let splines = path.subpaths().collect::<Vec<_>>();
        let samples: Vec<DVec2> = splines
            .iter()
            .flat_map(|s| s.sample(200).expect("few"))
            .collect();
        let size = path.max_coordinate();
        for _ in 0..20 {
            let p = match rng.below(3) {
                0 => rng.pick(&samples),
                1 => rng.pick(&samples) + rng.point(2).truncate() * size * 0.1,
                _ => rng.point(2).truncate() * size * 2.0,
            };
            let nearest = path.nearest(p).expect("finite").expect("not empty");
            let min = samples
                .iter()
                .map(|q| q.distance(p))
                .fold(f64::INFINITY, f64::min);
            let off = nearest.distance - min;
            assert!(off <= 1e-12 * size, "{p}: {off}");
            let there = splines[nearest.subpath].eval(nearest.t);
            assert!(there.distance(nearest.point) <= 1e-14 * size, "{p}");
            near(
                nearest.point.distance(p),
                nearest.distance,
                4e-15 * size,
                "distance",
            );
        }
        assert!(path.nearest(DVec2::new(f64::NAN, 0.0)).is_err());
    }
    assert_eq!(Path::default().nearest(DVec2::ZERO), Ok(None));
}

/// The arc length of a spline from its start to t, segment by segment.
fn length_up_to(spline: &Spline<DVec2>, t: f64) -> f64 {
    let length = |curve: Curve<DVec2>| curve.length(None).expect("no tolerance");
    let count = spline.segment_count();
    let k = (0..count).rfind(|&k| real(k) <= t).unwrap_or(0);
    let full: f64 = spline.segments().take(k).map(length).sum();
    let last = spline.segment(k).expect("a segment");
    full + length(last.subsegment(0.0, t - real(k)))
}

#[test]
fn times_by_length_have_that_length_behind_them() {
    let mut rng = Rng(36);
    for path in paths() {
        let whole = path.length(None).expect("no tolerance");
        let splines = path.subpaths().collect::<Vec<_>>();
        let lengths: Vec<f64> = splines
            .iter()
            .map(|s| s.length(None).expect("no tolerance"))
            .collect();
        let behind = |time: PathTime| {
            lengths[..time.subpath].iter().sum::<f64>()
                + length_up_to(&splines[time.subpath], time.t)
        };
        for _ in 0..10 {
            let s = rng.unit() * whole;
            let time = path
                .time_at_length(s, None)
                .expect("finite")
                .expect("not empty");
            near(
                behind(time),
                s,
                1e-9 * whole + 1e-14 * path.max_coordinate(),
                "length behind",
            );
        }
        let count = 1 + rng.below(20);
        let times = path.equidistant_times(count).expect("few");
        assert_eq!(times.len(), count + 1);
        assert_eq!(times[0], PathTime { subpath: 0, t: 0.0 });
        let last = splines.len() - 1;
        assert_eq!(
            times[count],
            PathTime {
                subpath: last,
                t: real(splines[last].segment_count())
            }
        );
        for (i, &time) in times.iter().enumerate() {
            near(
                behind(time),
                whole * real(i) / real(count),
                1e-9 * whole + 1e-14 * path.max_coordinate(),
                "even",
            );
        }
    }
}

#[test]
fn times_on_paths_without_length() {
    assert_eq!(Path::default().time_at_length(1.0, None), Ok(None));
    assert_eq!(Path::default().equidistant_times(3), Ok(Vec::new()));
    let dot = Path::from_svg("M1 1ZM2 2Z").expect("dots");
    assert_eq!(
        dot.equidistant_times(2).expect("few")[1],
        PathTime { subpath: 1, t: 0.0 }
    );
    assert_eq!(
        dot.time_at_length(5.0, None),
        Ok(Some(PathTime { subpath: 1, t: 1.0 }))
    );
}

#[test]
fn paths_intersect_where_their_splines_do() {
    let mut rng = Rng(37);
    for _ in 0..200 {
        let mut some = || -> Vec<Spline<DVec2>> {
            (0..rng.below(4)).map(|_| random_spline(&mut rng)).collect()
        };
        let (ours, theirs) = (some(), some());
        let (a, b) = (Path::new(&ours), Path::new(&theirs));
        let mut expected = Vec::new();
        for (i, one) in ours.iter().enumerate() {
            for (j, other) in theirs.iter().enumerate() {
                expected.extend(
                    one.intersections(other)
                        .into_iter()
                        .map(|time| (i, j, time.t, time.u, time.point)),
                );
            }
        }
        let got: Vec<_> = a
            .intersections(&b)
            .into_iter()
            .map(|time| (time.subpath, time.other_subpath, time.t, time.u, time.point))
            .collect();
        assert_eq!(got, expected);
        let own: Vec<_> = ours
            .iter()
            .flat_map(Spline::self_intersections)
            .map(|time| time.point)
            .collect();
        let selves = a.self_intersections();
        let same: Vec<_> = selves
            .iter()
            .filter(|m| m.subpath == m.other_subpath)
            .map(|m| m.point)
            .collect();
        assert_eq!(same, own);
        assert!(
            selves
                .iter()
                .all(|m| (m.subpath, m.t) < (m.other_subpath, m.u))
        );
    }
}
