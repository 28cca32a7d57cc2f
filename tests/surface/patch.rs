//! Patches: evaluation, derivatives, normals, isocurves, subdivision.

use crate::support::Rng;
use crate::support::nets::{RandomNet, assert_near, graph};
use casteljau::curve::bernstein;
use casteljau::glam::{DAffine3, DVec3};
use casteljau::{Error, Patch};
use wasm_bindgen_test::wasm_bindgen_test;

const DEGREES: [(usize, usize); 9] = [
    (1, 1),
    (2, 2),
    (3, 3),
    (1, 3),
    (3, 2),
    (4, 5),
    (9, 1),
    (3, 64),
    (64, 2),
];
const TS: [f64; 6] = [0.0, 0.125, 1.0 / 3.0, 0.5, 0.9, 1.0];

/// Runs a check on a random patch of each pair of degrees, at each pair of parameters.
fn everywhere(seed: u64, check: impl Fn(&Patch, f64, f64)) {
    let mut random = Rng(seed);
    for (m, n) in DEGREES {
        let patch = random.patch(m, n);
        for u in TS {
            for v in TS {
                check(&patch, u, v);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn eval_is_the_double_bernstein_sum() {
    everywhere(1, |patch, u, v| {
        let (m, n) = (patch.degree_u(), patch.degree_v());
        let (bu, bv) = (bernstein(m, u).unwrap(), bernstein(n, v).unwrap());
        let mut sum = DVec3::ZERO;
        for (j, wv) in bv.iter().enumerate() {
            for (i, wu) in bu.iter().enumerate() {
                sum += patch.control_points()[j * (m + 1) + i] * (wu * wv);
            }
        }
        assert_near(patch.eval(u, v), sum, 4e-15);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn corners_and_sides_are_exact() {
    let mut random = Rng(2);
    for (m, n) in DEGREES {
        let patch = random.patch(m, n);
        let net = patch.control_points();
        let corners = [(0.0, 0.0, 0), (1.0, 0.0, m), (0.0, 1.0, n * (m + 1))];
        for (u, v, index) in corners {
            assert_eq!(patch.eval(u, v), net[index]);
        }
        assert_eq!(patch.eval(1.0, 1.0), net[net.len() - 1]);
        assert_eq!(patch.isocurve_at_v(0.0).control_points(), &net[..=m]);
        let right: Vec<DVec3> = net.iter().skip(m).step_by(m + 1).copied().collect();
        assert_eq!(patch.isocurve_at_u(1.0).control_points(), &right[..]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn isocurves_lie_on_the_patch() {
    everywhere(3, |patch, u, v| {
        assert_near(patch.isocurve_at_u(u).eval(v), patch.eval(u, v), 4e-15);
        assert_near(patch.isocurve_at_v(v).eval(u), patch.eval(u, v), 4e-15);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn partials_of_a_polynomial() {
    // z = u³v² − 2uv + 5v³ over the unit square has known derivatives.
    for (m, n) in [(3, 3), (4, 3), (3, 6)] {
        let patch = graph(m, n, &[(1.0, 3, 2), (-2.0, 1, 1), (5.0, 0, 3)]);
        for u in TS {
            for v in TS {
                let got = patch.partials(u, v);
                let z = |value: f64| DVec3::new(0.0, 0.0, value);
                assert_near(got.u, z(3.0 * u * u * v * v - 2.0 * v) + DVec3::X, 1e-13);
                let along_v = 2.0 * u * u * u * v - 2.0 * u + 15.0 * v * v;
                assert_near(got.v, z(along_v) + DVec3::Y, 1e-13);
                assert_near(got.uu, z(6.0 * u * v * v), 1e-13);
                assert_near(got.uv, z(6.0 * u * u * v - 2.0), 1e-13);
                assert_near(got.vv, z(2.0 * u * u * u + 30.0 * v), 1e-13);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn partials_of_the_lowest_degrees() {
    let saddle = graph(1, 1, &[(1.0, 1, 1)]).partials(0.25, 0.5);
    assert_eq!(saddle.u, DVec3::new(1.0, 0.0, 0.5));
    assert_eq!(saddle.v, DVec3::new(0.0, 1.0, 0.25));
    assert_eq!(saddle.uv, DVec3::Z);
    assert_eq!((saddle.uu, saddle.vv), (DVec3::ZERO, DVec3::ZERO));
    let parabola = graph(2, 1, &[(1.0, 2, 0)]).partials(0.25, 0.5);
    assert_eq!(parabola.uu, DVec3::new(0.0, 0.0, 2.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn pieces_join_and_lie_on_the_patch() {
    everywhere(4, |patch, u, v| {
        let (before, after) = patch.split_u(u);
        assert_eq!(before.isocurve_at_u(1.0), after.isocurve_at_u(0.0));
        let (below, above) = patch.split_v(v);
        assert_eq!(below.isocurve_at_v(1.0), above.isocurve_at_v(0.0));
        let [p00, p10, p01, p11] = patch.split(u, v);
        for (a, b) in [(0.25, 0.75), (0.0, 1.0), (1.0, 0.5)] {
            let (low_u, low_v) = (a * u, b * v);
            let (high_u, high_v) = (u + a * (1.0 - u), v + b * (1.0 - v));
            assert_near(p00.eval(a, b), patch.eval(low_u, low_v), 1e-14);
            assert_near(p10.eval(a, b), patch.eval(high_u, low_v), 1e-14);
            assert_near(p01.eval(a, b), patch.eval(low_u, high_v), 1e-14);
            assert_near(p11.eval(a, b), patch.eval(high_u, high_v), 1e-14);
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn pieces_keep_the_outer_corners() {
    let patch = Rng(5).patch(3, 3);
    let net = patch.control_points();
    let [p00, p10, p01, p11] = patch.split(0.3, 0.6);
    assert_eq!(p00.control_points()[0], net[0]);
    assert_eq!(p10.control_points()[3], net[3]);
    assert_eq!(p01.control_points()[12], net[12]);
    assert_eq!(p11.control_points()[15], net[15]);
}

#[wasm_bindgen_test(unsupported = test)]
fn elevation_keeps_the_patch() {
    everywhere(6, |patch, u, v| {
        let Ok(raised) = patch.elevate() else {
            assert_eq!(patch.degree_u().max(patch.degree_v()), 64);
            return;
        };
        assert_eq!(raised.degree_u(), patch.degree_u() + 1);
        assert_eq!(raised.degree_v(), patch.degree_v() + 1);
        assert_near(raised.eval(u, v), patch.eval(u, v), 4e-15);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn normal_of_a_graph() {
    // z = u² − v³: the normal is (−2u, 3v², 1), normalised.
    let patch = graph(3, 3, &[(1.0, 2, 0), (-1.0, 0, 3)]);
    for u in TS {
        for v in TS {
            let true_normal = DVec3::new(-2.0 * u, 3.0 * v * v, 1.0).normalize();
            assert_near(patch.normal(u, v), true_normal, 1e-14);
        }
    }
}

/// A cap of the paraboloid z = −r² as one patch with a collapsed edge: u runs around, v outwards from the pole; the
/// outside is up.
fn cap() -> Patch {
    let rim = [
        DVec3::new(1.0, 0.0, -1.0),
        DVec3::new(1.0, 0.5, -1.0),
        DVec3::new(0.5, 1.0, -1.0),
        DVec3::new(0.0, 1.0, -1.0),
    ];
    let mut net = vec![DVec3::new(0.1, 0.2, 0.3); 4];
    let pole = net[0];
    net.extend(rim.map(|p| pole + DVec3::new(0.5 * p.x, 0.5 * p.y, 0.0)));
    net.extend(rim.map(|p| pole + p));
    // v runs from the pole to the rim, u counter-clockwise as seen from above, so ∂u × ∂v points down.
    Patch::new(&net, 3, 2).unwrap()
}

#[wasm_bindgen_test(unsupported = test)]
fn normal_at_a_collapsed_side_is_the_limit() {
    for u in TS {
        assert_near(cap().normal(u, 0.0), -DVec3::Z, 1e-14);
        let mut reversed = cap().control_points().to_vec();
        reversed.reverse();
        let reversed = Patch::new(&reversed, 3, 2).unwrap();
        assert_near(reversed.normal(u, 1.0), -DVec3::Z, 1e-14);
    }
    // The normal is continuous towards the edge, however near.
    for v in [1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-15, 1e-300] {
        for u in TS {
            let tilt = cap().normal(u, v).angle_between(-DVec3::Z);
            assert!(tilt <= 8.0 * v + 1e-14, "{tilt:e} at v = {v:e}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn normal_at_a_collapsed_column_is_the_limit() {
    let net = cap();
    let points = net.control_points();
    let across: Vec<DVec3> = (0..4)
        .flat_map(|i| (0..3).map(move |j| 4 * j + i))
        .map(|index| points[index])
        .collect();
    let across = Patch::new(&across, 2, 3).unwrap();
    for t in TS {
        // u and v exchanged: the normal is reversed.
        assert_near(across.normal(0.0, t), DVec3::Z, 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn normal_at_a_degenerate_corner_is_the_limit() {
    // Both handles at (0, 0) have length 0: flat in z = 0, so the normal is z from every direction.
    let mut net = graph(3, 3, &[]).control_points().to_vec();
    (net[1], net[4], net[5]) = (net[0], net[0], net[0]);
    let patch = Patch::new(&net, 3, 3).unwrap();
    assert_near(patch.normal(0.0, 0.0), DVec3::Z, 1e-14);
    // Parallel handles: the corner's tangents coincide.
    let mut net = graph(3, 3, &[]).control_points().to_vec();
    net[4] = net[1];
    let patch = Patch::new(&net, 3, 3).unwrap();
    assert_near(patch.normal(0.0, 0.0), DVec3::Z, 1e-14);
}

#[wasm_bindgen_test(unsupported = test)]
fn normals_do_not_depend_on_size_or_position() {
    let mut random = Rng(7);
    for (m, n) in DEGREES {
        let net = random.net(m, n);
        for size in [1e-300, 1e-9, 1e9, 1e149] {
            let scaled: Vec<DVec3> = net.iter().map(|&p| p * size).collect();
            let (a, b) = (
                Patch::new(&net, m, n).unwrap(),
                Patch::new(&scaled, m, n).unwrap(),
            );
            for (u, v) in [(0.0, 0.0), (0.3, 0.6), (1.0, 0.5)] {
                assert_near(a.normal(u, v), b.normal(u, v), 1e-11);
                assert!(b.eval(u, v).is_finite());
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn patches_without_a_normal_have_none() {
    let point = Patch::new(&[DVec3::ONE; 16], 3, 3).unwrap();
    let line: Vec<DVec3> = (0..16_u8).map(|i| DVec3::X * f64::from(i)).collect();
    let line = Patch::new(&line, 3, 3).unwrap();
    for u in TS {
        for v in TS {
            assert_near(point.eval(u, v), DVec3::ONE, 1e-15);
            assert_eq!(point.normal(u, v), DVec3::ZERO);
            assert_eq!(line.normal(u, v), DVec3::ZERO);
            let p = point.partials(u, v);
            assert_eq!([p.u, p.v, p.uu, p.uv, p.vv], [DVec3::ZERO; 5]);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_map_of_a_point_is_a_point_of_the_map() {
    let map = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 2.0) / 3.0, 0.7)
        * DAffine3::from_scale(DVec3::new(1.0, -2.0, 0.5))
        * DAffine3::from_translation(DVec3::new(3.0, -1.0, 2.0));
    everywhere(8, |patch, u, v| {
        let image = patch.transform(&map).expect("a finite image");
        let expected = map.transform_point3(patch.eval(u, v));
        assert_near(image.eval(u, v), expected, 2e-14);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn moving_a_point_moves_only_that() {
    let patch = Rng(9).patch(3, 3);
    let moved = patch.move_point(5, DVec3::ONE).unwrap();
    for (index, (a, b)) in (0..).zip(patch.control_points().iter().zip(moved.control_points())) {
        assert_eq!(*b, if index == 5 { DVec3::ONE } else { *a });
    }
    assert!(patch.approx_eq(&patch, 0.0));
    assert!(!patch.approx_eq(&moved, 1e-9));
    assert!(patch.approx_eq(&moved, 4.0));
    assert!(!patch.approx_eq(&patch.elevate().unwrap(), 1e9));
}

#[wasm_bindgen_test(unsupported = test)]
fn control_bounds_contain_the_patch() {
    everywhere(10, |patch, u, v| {
        let bounds = patch.control_bounds();
        let p = patch.eval(u, v);
        let slack = DVec3::splat(1e-15);
        assert!(p.cmpge(bounds.min - slack).all() && p.cmple(bounds.max + slack).all());
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals() {
    let net = [DVec3::ZERO; 16];
    let count = |got| Error::Count {
        what: "net",
        expected: "(degree_u + 1)·(degree_v + 1) control points",
        got,
    };
    assert_eq!(Patch::new(&net[..15], 3, 3), Err(count(15)));
    assert_eq!(Patch::new(&[], 1, 1), Err(count(0)));
    let degree = |what, got| Error::Range {
        what,
        expected: "a whole number from 1 to 64",
        got,
    };
    assert_eq!(Patch::new(&net, 0, 3), Err(degree("degree_u", 0.0)));
    assert_eq!(Patch::new(&net, 3, 65), Err(degree("degree_v", 65.0)));
    let huge = Patch::new(&net, usize::MAX, 3);
    assert!(matches!(huge, Err(Error::Range { .. })));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut broken = net;
        broken[7].z = bad;
        let error = Patch::new(&broken, 3, 3).unwrap_err();
        assert!(matches!(
            error,
            Error::NotFinite {
                what: "net",
                index: 7,
                ..
            }
        ));
        let patch = Patch::new(&net, 3, 3).unwrap();
        let error = patch.move_point(0, DVec3::new(0.0, bad, 0.0)).unwrap_err();
        assert!(matches!(error, Error::NotFinite { what: "to", .. }));
    }
    let error = Patch::new(&net, 3, 3)
        .unwrap()
        .move_point(16, DVec3::ZERO)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "index: expected an index from 0 to 15, got 16"
    );
}

#[cfg(not(target_family = "wasm"))]
mod properties {
    use super::{DVec3, Patch};
    use proptest::prelude::*;

    /// A coordinate that is often 0, repeated, huge or tiny.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            Just(0.0),
            Just(1.0),
            -1.0..1.0_f64,
            -1e150..1e150_f64,
            -1e-300..1e-300_f64,
        ]
    }

    fn any_patch() -> impl Strategy<Value = Patch> {
        (1..6_usize, 1..6_usize).prop_flat_map(|(m, n)| {
            let point = [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from);
            prop::collection::vec(point, (m + 1) * (n + 1))
                .prop_map(move |net| Patch::new(&net, m, n).unwrap())
        })
    }

    proptest! {
        #[test]
        fn nothing_is_nan(patch in any_patch(), u in 0.0..=1.0, v in 0.0..=1.0) {
            prop_assert!(patch.eval(u, v).is_finite());
            let normal = patch.normal(u, v);
            let length = normal.length();
            prop_assert!(length == 0.0 || (length - 1.0).abs() < 1e-14, "{normal}");
            for piece in patch.split(u, v) {
                prop_assert!(piece.control_points().iter().all(|p| p.is_finite()));
            }
        }
    }
}
