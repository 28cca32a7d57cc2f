//! Construction of splines: valid and invalid input.

use crate::spline::{continuity, control, each_spline, random};
use crate::support::{Rng, real, refused, spline};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Spline};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn open_takes_n_degree_plus_1_points_closed_n_degree() {
    for degree in [1, 2, 3, 4, 64] {
        for (count, closed) in (0..=2 * degree + 2).flat_map(|n| [(n, false), (n, true)]) {
            let spline = Spline::new(&vec![DVec2::ONE; count], degree, closed);
            let inner = count + usize::from(closed);
            if inner <= degree || (inner - 1) % degree != 0 {
                refused(spline, &format!("Count points {count}"));
                continue;
            }
            let spline = spline.expect("a fitting count");
            assert_eq!(spline.degrees(), vec![degree; (inner - 1) / degree]);
            assert_eq!(spline.segment_count(), (inner - 1) / degree);
            let found = (spline.is_closed(), spline.control_points().len());
            assert_eq!(found, (closed, count));
        }
    }
}

#[test]
fn segments_share_the_points_of_their_joints() {
    each_spline(1, |spline, degrees| {
        assert_eq!(spline.degrees(), degrees);
        let segments: Vec<_> = spline.segments().collect();
        for (k, segment) in segments.iter().enumerate() {
            let expected = control(spline.control_points(), degrees, k);
            assert_eq!(segment.control_points(), expected);
            assert_eq!(spline.segment(k).as_ref(), Some(segment));
        }
        assert_eq!(spline.segment(segments.len()), None);
        assert_eq!(spline.segments().len(), degrees.len());
        let back: Vec<_> = spline.segments().rev().collect();
        assert!(back.iter().rev().eq(&segments));
        let joined = Spline::from_curves(&segments, spline.is_closed());
        assert_eq!(joined.as_ref(), Ok(spline));
    });
}

#[test]
fn curves_that_do_not_follow_each_other_are_refused_with_their_gap() {
    let line = |from: f64, to: f64| Curve::line(DVec2::new(from, 0.0), DVec2::new(to, 0.0));
    let join = |gap: f64| {
        let lines = [line(0.0, 4.0), line(4.0, 6.0), line(6.0 + gap, 8.0)];
        Spline::from_curves(&lines, false)
    };
    refused(join(0.5), "Gap 2 0.5");
    // Points within 10⁻⁹ of the largest coordinate, which is 8, count as equal; the point of the earlier curve is kept.
    assert!(join(8.1e-9).is_err());
    assert_eq!(join(7.9e-9), Ok(spline("0 0, 4 0, 6 0, 8 0", 1, false)));
    refused(
        Spline::from_curves(&[line(0.0, 1.0), line(1.0, 3.0)], true),
        "Gap 0 3",
    );
    let closed = Spline::from_curves(&[line(0.0, 1.0), line(1.0, 0.0)], true);
    assert_eq!(closed, Ok(spline("0 0, 1 0", 1, true)));
    let none: [Curve<DVec2>; 0] = [];
    refused(Spline::from_curves(&none, false), "Count curves 0");
}

#[test]
fn appending_goes_on_in_the_direction_of_arrival() {
    let mut rng = Rng(3);
    for degrees in [&[1][..], &[2], &[3], &[5], &[1, 3], &[3, 2]] {
        let spline = random::<DVec3>(&mut rng, degrees, false);
        let to = rng.point(3) * 3.0;
        let longer = spline.append(to).expect("open");
        let (old, new) = (spline.control_points(), longer.control_points());
        assert!(new.starts_with(old) && new.ends_with(&[to]));
        let degree = degrees[degrees.len() - 1].min(3);
        assert_eq!(longer.degrees(), [degrees, &[degree]].concat());
        let joint = continuity(&longer, degrees.len(), None);
        assert!(degree == 1 || joint.g1, "{degrees:?}: {joint:?}");
    }
    // After a segment that is a point there is no direction: the new segment is straight.
    let still = spline("1 1, 1 1, 1 1, 1 1", 3, false).append(DVec2::new(4.0, 1.0));
    let between = |p: &DVec2| p.y == 1.0 && (1.0..=4.0).contains(&p.x);
    assert!(still.expect("open").control_points().iter().all(between));
}

#[test]
fn equal_means_the_same_structure_and_near_points() {
    let points: Vec<DVec3> = (0..7).map(|i| DVec3::splat(real(i))).collect();
    let of = |points: &[DVec3], degrees: &[usize]| {
        let closed = points.len() == 6;
        Spline::with_degrees(points.to_vec(), degrees, closed).expect("a spline")
    };
    let spline = of(&points, &[3, 3]);
    assert!(spline.approx_eq(&spline, 0.0));
    for other in [of(&points, &[2, 4]), of(&points[..6], &[3, 3])] {
        assert!(!spline.approx_eq(&other, 10.0));
    }
    let mut moved = points.clone();
    moved[4].y += 0.25;
    let moved = of(&moved, &[3, 3]);
    assert!(spline.approx_eq(&moved, 0.25) && !spline.approx_eq(&moved, 0.2));
}
