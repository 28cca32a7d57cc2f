//! Construction of splines: valid and invalid input.

use crate::spline::{STRUCTURES, control, plane, random};
use crate::support::{Rng, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn open_takes_n_degree_plus_1_points_closed_n_degree() {
    for degree in [1, 2, 3, 4, 64] {
        for count in 0..=2 * degree + 2 {
            let points = vec![DVec2::ONE; count];
            for closed in [false, true] {
                let inner = count + usize::from(closed);
                let fits = inner > degree && (inner - 1) % degree == 0;
                let spline = Spline::new(&points, degree, closed);
                assert_eq!(
                    spline.is_ok(),
                    fits,
                    "{count} points of degree {degree}, closed: {closed}"
                );
                let Ok(spline) = spline else {
                    assert!(
                        matches!(spline, Err(Error::Count { what: "points", got, .. }) if got == count)
                    );
                    continue;
                };
                assert_eq!(spline.segment_count(), (inner - 1) / degree);
                assert_eq!(spline.degrees(), vec![degree; spline.segment_count()]);
                assert_eq!(
                    (spline.is_closed(), spline.control_points().len()),
                    (closed, count)
                );
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refused_degrees_and_values() {
    for degree in [0, 65, usize::MAX] {
        let refused = Spline::new(&[DVec2::ZERO; 7], degree, false);
        assert!(
            matches!(refused, Err(Error::Range { what: "degree", .. })),
            "{degree}"
        );
        let refused = Spline::with_degrees(vec![DVec2::ZERO; 7], &[3, degree], false);
        assert!(
            matches!(
                refused,
                Err(Error::Range {
                    what: "degrees",
                    ..
                })
            ),
            "{degree}"
        );
    }
    for (degrees, closed) in [
        (&[][..], false),
        (&[3][..], false),
        (&[3, 2][..], false),
        (&[3, 3][..], true),
    ] {
        let refused = Spline::with_degrees(vec![DVec2::ZERO; 7], degrees, closed);
        assert!(
            matches!(
                refused,
                Err(Error::Count {
                    what: "points",
                    got: 7,
                    ..
                })
            ),
            "{degrees:?}"
        );
    }
    let bad = [DVec2::ZERO, DVec2::ONE, DVec2::new(0.0, f64::NAN)];
    assert!(matches!(
        Spline::new(&bad, 2, false),
        Err(Error::NotFinite {
            what: "points",
            index: 2,
            ..
        })
    ));
}

#[wasm_bindgen_test(unsupported = test)]
fn segments_share_the_points_of_their_joints() {
    let mut rng = Rng(1);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            assert_eq!(spline.degrees(), degrees);
            let segments = spline.segments().collect::<Vec<_>>();
            for (k, segment) in segments.iter().enumerate() {
                assert_eq!(
                    segment.control_points(),
                    control(spline.control_points(), degrees, k)
                );
                assert_eq!(spline.segment(k).as_ref(), Some(segment));
            }
            assert_eq!(spline.segment(segments.len()), None);
            assert_eq!(Spline::from_curves(&segments, closed), Ok(spline));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn curves_that_do_not_follow_each_other_are_refused_with_their_gap() {
    let line = |from: f64, to: f64| {
        Curve::new(&[DVec2::new(from, 0.0), DVec2::new(to, 0.0)]).expect("finite")
    };
    let join = |gap: f64| {
        Spline::from_curves(
            &[line(0.0, 4.0), line(4.0, 6.0), line(6.0 + gap, 8.0)],
            false,
        )
    };
    assert_eq!(join(0.5), Err(Error::Gap { index: 2, got: 0.5 }));
    // Points within 10⁻⁹ of the largest coordinate, which is 8, count as equal; the point of the earlier curve is kept.
    assert!(join(8.1e-9).is_err());
    let spline = join(7.9e-9).expect("near enough");
    assert_eq!(
        spline
            .control_points()
            .iter()
            .map(|p| p.x)
            .collect::<Vec<f64>>(),
        [0.0, 4.0, 6.0, 8.0]
    );
    assert_eq!(
        Spline::from_curves(&[line(0.0, 1.0), line(1.0, 3.0)], true),
        Err(Error::Gap { index: 0, got: 3.0 })
    );
    let closed = Spline::from_curves(&[line(0.0, 1.0), line(1.0, 0.0)], true).expect("closed");
    assert_eq!(closed.control_points().len(), 2);
    let none: [Curve<DVec2>; 0] = [];
    assert!(matches!(
        Spline::from_curves(&none, false),
        Err(Error::Count {
            what: "curves",
            got: 0,
            ..
        })
    ));
}

#[wasm_bindgen_test(unsupported = test)]
fn appending_goes_on_in_the_direction_of_arrival() {
    let mut rng = Rng(3);
    for degrees in [&[1][..], &[2], &[3], &[5], &[1, 3], &[3, 2]] {
        let spline = random(&mut rng, degrees, false);
        let to = rng.point(3) * 3.0;
        let longer = spline.append(to).expect("open");
        let (old, new) = (spline.control_points(), longer.control_points());
        assert_eq!(new[..old.len()], *old);
        assert_eq!(new[new.len() - 1], to);
        let degree = degrees[degrees.len() - 1].min(3);
        assert_eq!(longer.degrees(), [degrees, &[degree]].concat());
        let joint = longer.continuity(degrees.len(), None).expect("a joint");
        assert!(degree == 1 || joint.g1, "{degrees:?}: {joint:?}");
    }
    // After a segment that is a point there is no direction: the new segment is straight.
    let still = plane(&[(1.0, 1.0); 4], 3, false)
        .append(DVec2::new(4.0, 1.0))
        .expect("open");
    assert!(
        still
            .control_points()
            .iter()
            .all(|p| p.y == 1.0 && (1.0..=4.0).contains(&p.x))
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn refused_appending() {
    let closed = plane(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], 3, true);
    assert!(matches!(
        closed.append(DVec2::ONE),
        Err(Error::Range { what: "closed", .. })
    ));
    let open = plane(&[(0.0, 0.0), (1.0, 0.0)], 1, false);
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = open.append(DVec2::new(0.0, bad));
        assert!(matches!(
            refused,
            Err(Error::NotFinite { what: "point", .. })
        ));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_means_the_same_structure_and_near_points() {
    let points: Vec<DVec3> = (0..7).map(|i| DVec3::splat(real(i))).collect();
    let of =
        |degrees: &[usize]| Spline::with_degrees(points.clone(), degrees, false).expect("a spline");
    assert!(of(&[3, 3]).approx_eq(&of(&[3, 3]), 0.0));
    assert!(!of(&[3, 3]).approx_eq(&of(&[2, 4]), 10.0));
    let closed = Spline::new(&points[..6], 3, true).expect("a spline");
    assert!(!of(&[3, 3]).approx_eq(&closed, 10.0));
    let mut moved = points.clone();
    moved[4].y += 0.25;
    let moved = Spline::new(&moved, 3, false).expect("a spline");
    assert!(of(&[3, 3]).approx_eq(&moved, 0.25) && !of(&[3, 3]).approx_eq(&moved, 0.2));
}
