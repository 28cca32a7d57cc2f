//! Points, derivatives and parts of paths: those of the subpaths.

use super::sizes::{Largest, paths};
use crate::support::paths::path;
use crate::support::{Rng, near, real};
use casteljau::Path;
use casteljau::path::PathTime;

#[test]
fn values_are_those_of_the_subpath() {
    let mut rng = Rng(2801);
    for path in paths() {
        for (subpath, spline) in path.subpaths().enumerate() {
            let count = real(spline.segment_count());
            for _ in 0..10 {
                let t = rng.unit() * (count + 1.0) - 0.5;
                let time = PathTime::new(subpath, t);
                assert_eq!(path.eval(time), Ok(spline.eval(t)));
                assert_eq!(path.eval_at(&[time]), Ok(vec![spline.eval(t)]));
                assert_eq!(path.tangent(time), Ok(spline.tangent(t)));
                assert_eq!(path.normal(time), Ok(spline.normal(t)));
                assert_eq!(path.derivative_at(time, 2), Ok(spline.derivative_at(t, 2)));
                let curvature = path.curvature(time).map(f64::to_bits);
                assert_eq!(curvature, Ok(spline.curvature(t).to_bits()));
            }
            let sampled = path.sample(3).expect("few");
            assert_eq!(Ok(&sampled[subpath]), spline.sample(3).as_ref());
        }
    }
}

#[test]
fn positions_by_length_have_point_and_directions() {
    for path in paths() {
        let s = 0.4 * path.length();
        let found = path.point_at_length(s).expect("not empty");
        assert_eq!(Some(found.t), path.time_at_length(s));
        assert_eq!(Ok(found.point), path.eval(found.t));
        assert_eq!(Ok(found.tangent), path.tangent(found.t));
        assert_eq!(found.normal, found.tangent.perp());
        let slack = 1e-9 * path.length() + 1e-14 * path.max_coordinate();
        near(path.length_at(found.t).expect("a position"), s, slack);
    }
    assert_eq!(Path::default().point_at_length(1.0), None);
}

#[test]
fn kept_lengths_answer_as_the_path_does() {
    for path in paths() {
        let mut lengths = path.lengths();
        let total = path.length();
        assert_eq!(lengths.total(), total);
        for part in [0.4, 0.41, -1.0, 0.0, 0.9, 0.1, 1.0, 2.0] {
            let s = part * total;
            // Within the accuracy of a position: a segment that is asked again has a table.
            let (time, at) = (lengths.time_at(s), lengths.point_at(s));
            let (time, at) = (time.expect("not empty"), at.expect("not empty"));
            let expected = path.point_at_length(s).expect("not empty");
            for found in [time, at.t] {
                assert_eq!(found.subpath, expected.t.subpath);
                near(found.t, expected.t.t, 1e-11);
            }
            assert_eq!(Ok(at.point), path.eval(at.t));
        }
    }
    let empty = Path::default();
    let mut none = empty.lengths();
    assert_eq!(
        (none.total(), none.time_at(1.0), none.point_at(1.0)),
        (0.0, None, None)
    );
}

#[test]
fn the_parts_of_a_split_are_the_path() {
    let mut rng = Rng(2802);
    for path in paths() {
        let whole = path.length();
        let slack = 1e-9 * whole + 1e-14 * path.max_coordinate();
        for _ in 0..5 {
            let time = path.time_at_length(rng.unit() * whole).expect("not empty");
            let (before, after) = path.split(time).expect("a position");
            near(before.length() + after.length(), whole, slack);
            assert_eq!(path.subsegment(..time).as_ref(), Ok(&before));
            let parts = [before.clone(), Path::default(), after.clone()];
            assert_eq!(path.split_at(&[time, time]), Ok(parts.to_vec()));
            let cut = before.subpath_count() + after.subpath_count();
            assert!((path.subpath_count()..=path.subpath_count() + 1).contains(&cut));
            let backwards = path
                .subsegment(time..PathTime::new(0, 0.0))
                .expect("a part");
            near(backwards.length(), before.length(), slack);
        }
    }
    let two = path("M0 0H4 M0 1H4V3H0Z");
    let (before, after) = two.split(PathTime::new(1, 0.5)).expect("a position");
    assert_eq!(before, path("M0 0H4 M0 1H2"));
    assert_eq!(after, path("M2 1H4V3H0L0 1"));
    assert_eq!(
        two.split(PathTime::new(1, 0.0)),
        Ok((path("M0 0H4"), path("M0 1H4V3H0Z")))
    );
    let [a, b] = [PathTime::new(0, 0.5), PathTime::new(1, 0.5)];
    let parts = ["M0 0H2", "", "M2 0H4 M0 1H2", "M2 1H4V3H0L0 1"].map(path);
    assert_eq!(two.split_at(&[b, a, a]), Ok(parts.to_vec()));
    assert_eq!(two.split_at(&[]), Ok(vec![two.clone()]));
    assert_eq!(Path::default().split_at(&[]), Ok(vec![Path::default()]));
    assert_eq!(two.subsegment(..), Ok(two.clone()));
    assert_eq!(two.subsegment(..PathTime::new(0, 0.0)), Ok(Path::default()));
    let (from, to) = (PathTime::new(1, 1.5), PathTime::new(0, 0.5));
    assert_eq!(two.subsegment(from..to), Ok(path("M4 2V1H0 M4 0H2")));
    let point = two.subsegment(from..from).expect("a point");
    assert_eq!((point.segment_count(), point.length()), (1, 0.0));
}

#[test]
fn positions_of_found_points_are_positions() {
    let square = path("M0 0H4V4H0Z");
    let nearest = square
        .nearest((5.0, 1.0).into())
        .expect("finite")
        .expect("not empty");
    assert_eq!(square.eval(nearest.time()), Ok((4.0, 1.0).into()));
    let line = path("M2 -1V1");
    let found = square.intersections(&line)[0];
    assert_eq!(square.eval(found.time()), Ok(found.point));
    assert_eq!(line.eval(found.other_time()), Ok(found.point));
    assert!(PathTime::new(0, 3.0) < PathTime::new(1, 0.0));
}
