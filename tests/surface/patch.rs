//! Patches: evaluation, derivatives, normals, isocurves, subdivision.

use crate::support::nets::{RandomNet, assert_near, graph, net, patch, points};
use crate::support::{Rng, assert_refused};
use casteljau::Patch;
use casteljau::curve::bernstein;
use casteljau::glam::{DAffine3, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const DEGREES: [[usize; 9]; 2] = [[1, 2, 3, 1, 3, 4, 9, 3, 64], [1, 2, 3, 3, 2, 5, 1, 64, 2]];
const TS: [f64; 6] = [0.0, 0.125, 1.0 / 3.0, 0.5, 0.9, 1.0];

/// A random patch of each pair of degrees.
fn patches(seed: u64) -> impl Iterator<Item = Patch> {
    let mut random = Rng(seed);
    (0..9).map(move |k| random.patch(DEGREES[0][k], DEGREES[1][k]))
}

/// Each pair of parameters.
fn everywhere() -> impl Iterator<Item = (f64, f64)> {
    TS.into_iter().flat_map(|u| TS.map(|v| (u, v)))
}

fn bernstein_sum(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let (bu, bv) = (bernstein(m, u).unwrap(), bernstein(n, v).unwrap());
    let weights = bv.iter().flat_map(|wv| bu.iter().map(move |wu| wu * wv));
    let terms = patch.control_points().iter().zip(weights);
    terms.fold(DVec3::ZERO, |sum, (&p, w)| sum + p * w)
}

/// Evaluation, isocurves, bounds, elevation, maps.
#[test]
fn every_form_has_the_points_of_the_bernstein_sum() {
    let map = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 2.0) / 3.0, 0.7)
        * DAffine3::from_scale(DVec3::new(1.0, -2.0, 0.5))
        * DAffine3::from_translation(DVec3::new(3.0, -1.0, 2.0));
    for patch in patches(1) {
        let (bounds, slack) = (patch.control_bounds(), DVec3::splat(1e-15));
        let (low, high) = (bounds.min - slack, bounds.max + slack);
        let (raised, image) = (patch.elevate(), patch.transform(&map).unwrap());
        let largest = patch.degree_u().max(patch.degree_v());
        assert_eq!(raised.is_err(), largest == 64);
        // Outside, rounding errors grow with the degrees.
        let outside = [(-0.25, 0.5), (0.75, 1.5), (1.25, -0.5)].map(|at| (at, 1e-13));
        let outside = outside.into_iter().filter(|_| largest <= 5);
        for ((u, v), max) in everywhere().map(|at| (at, 4e-15)).chain(outside) {
            let p = patch.eval(u, v);
            assert_near(p, bernstein_sum(&patch, u, v), max);
            assert_near(patch.isocurve_at_u(u).eval(v), p, max);
            assert_near(patch.isocurve_at_v(v).eval(u), p, max);
        }
        for (u, v) in everywhere() {
            let p = patch.eval(u, v);
            assert!(p.cmpge(low).all() && p.cmple(high).all());
            assert_near(image.eval(u, v), map.transform_point3(p), 2e-14);
            if let Ok(raised) = &raised {
                assert_eq!(raised.degree_u(), patch.degree_u() + 1);
                assert_eq!(raised.degree_v(), patch.degree_v() + 1);
                assert_near(raised.eval(u, v), p, 4e-15);
            }
        }
    }
}

#[test]
fn corners_and_sides_are_exact() {
    for patch in patches(2) {
        let (net, m) = (patch.control_points(), patch.degree_u());
        let last = net.len() - 1;
        for (u, v, index) in [
            (0.0, 0.0, 0),
            (1.0, 0.0, m),
            (0.0, 1.0, last - m),
            (1.0, 1.0, last),
        ] {
            assert_eq!(patch.eval(u, v), net[index]);
        }
        assert_eq!(patch.isocurve_at_v(0.0).control_points(), &net[..=m]);
        let right: Vec<DVec3> = net.iter().skip(m).step_by(m + 1).copied().collect();
        assert_eq!(patch.isocurve_at_u(1.0).control_points(), &right[..]);
    }
}

#[test]
fn partials_of_a_polynomial() {
    // z = u³v² − 2uv + 5v³ over the unit square has known derivatives.
    for (m, n) in [(3, 3), (4, 3), (3, 6)] {
        let patch = graph(m, n, &[(1.0, 3, 2), (-2.0, 1, 1), (5.0, 0, 3)]);
        for (u, v) in everywhere() {
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

#[test]
fn partials_of_the_lowest_degrees() {
    let saddle = graph(1, 1, &[(1.0, 1, 1)]).partials(0.25, 0.5);
    let got = [saddle.u, saddle.v, saddle.uu, saddle.uv, saddle.vv];
    assert_eq!(got[..], points("1 0 0.5  0 1 0.25  0 0 0  0 0 1  0 0 0"));
    let parabola = graph(2, 1, &[(1.0, 2, 0)]).partials(0.25, 0.5);
    assert_eq!(parabola.uu, DVec3::new(0.0, 0.0, 2.0));
}

#[test]
fn pieces_join_and_lie_on_the_patch() {
    for patch in patches(4) {
        for (u, v) in everywhere() {
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
            let outer = [
                p00.eval(0.0, 0.0),
                p10.eval(1.0, 0.0),
                p01.eval(0.0, 1.0),
                p11.eval(1.0, 1.0),
            ];
            let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
            assert_eq!(outer, corners.map(|(u, v)| patch.eval(u, v)));
        }
    }
}

#[test]
fn normal_of_a_graph() {
    // z = u² − v³: the normal is (−2u, 3v², 1), normalised.
    let patch = graph(3, 3, &[(1.0, 2, 0), (-1.0, 0, 3)]);
    for (u, v) in everywhere() {
        let true_normal = DVec3::new(-2.0 * u, 3.0 * v * v, 1.0).normalize();
        assert_near(patch.normal(u, v), true_normal, 1e-14);
    }
}

/// A cap of the paraboloid z = −r² as one patch with a collapsed edge: u runs around, v outwards from the pole. u runs
/// counter-clockwise as seen from above, so ∂u × ∂v points down.
fn cap() -> Patch {
    let (pole, rim) = (
        DVec3::new(0.1, 0.2, 0.3),
        points("1 0 -1  1 0.5 -1  0.5 1 -1  0 1 -1"),
    );
    let inner = |p: &DVec3| pole + DVec3::new(0.5 * p.x, 0.5 * p.y, 0.0);
    let middle = rim.iter().map(inner);
    let rows = [
        vec![pole; 4],
        middle.collect(),
        rim.iter().map(|&p| pole + p).collect(),
    ];
    patch(&rows.concat(), 3, 2)
}

#[test]
fn normal_at_a_collapsed_side_is_the_limit() {
    let net = cap().control_points().to_vec();
    let backwards: Vec<DVec3> = net.iter().rev().copied().collect();
    // u and v exchanged: the normal is reversed.
    let exchanged: Vec<DVec3> = (0..12).map(|k| net[4 * (k % 3) + k / 3]).collect();
    for t in TS {
        assert_near(cap().normal(t, 0.0), -DVec3::Z, 1e-14);
        assert_near(patch(&backwards, 3, 2).normal(t, 1.0), -DVec3::Z, 1e-14);
        assert_near(patch(&exchanged, 2, 3).normal(0.0, t), DVec3::Z, 1e-14);
        // The normal is continuous towards the edge, however near.
        for v in [1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-15, 1e-300] {
            let tilt = cap().normal(t, v).angle_between(-DVec3::Z);
            assert!(tilt <= 8.0 * v + 1e-14, "{tilt:e} at v = {v:e}");
        }
    }
}

#[test]
fn normal_at_a_collapsed_side_of_high_degree_is_the_limit() {
    let mut high = cap();
    while high.degree_u() < 36 {
        high = high.elevate().expect("a low degree");
    }
    assert_near(high.normal(0.3, 0.0), -DVec3::Z, 1e-10);
}

#[test]
fn normal_at_a_degenerate_corner_is_the_limit() {
    // Both handles at (0, 0) have length 0, or they are parallel: flat in z = 0, so the normal is z from every direction.
    for copies in [&[(1, 0), (4, 0), (5, 0)][..], &[(4, 1)]] {
        let mut net = graph(3, 3, &[]).control_points().to_vec();
        copies.iter().for_each(|&(to, from)| net[to] = net[from]);
        assert_near(patch(&net, 3, 3).normal(0.0, 0.0), DVec3::Z, 1e-14);
    }
}

#[test]
fn normals_do_not_depend_on_size_or_position() {
    for a in patches(7) {
        for size in [1e-300, 1e-9, 1e9, 1e149] {
            let map = DAffine3::from_scale(DVec3::splat(size));
            let b = a.transform(&map).unwrap();
            for (u, v) in [(0.0, 0.0), (0.3, 0.6), (1.0, 0.5)] {
                assert_near(a.normal(u, v), b.normal(u, v), 1e-11);
                assert!(b.eval(u, v).is_finite());
            }
        }
    }
}

#[test]
fn patches_without_a_normal_have_none() {
    let point = patch(&[DVec3::ONE; 16], 3, 3);
    let line = patch(&net(3, 3, |i, j| DVec3::X * (i + 4.0 * j)), 3, 3);
    for (u, v) in everywhere() {
        assert_near(point.eval(u, v), DVec3::ONE, 1e-15);
        assert_eq!(point.normal(u, v), DVec3::ZERO);
        assert_eq!(line.normal(u, v), DVec3::ZERO);
        let p = point.partials(u, v);
        assert_eq!([p.u, p.v, p.uu, p.uv, p.vv], [DVec3::ZERO; 5]);
    }
}

#[test]
fn moving_a_point_moves_only_that() {
    let before = Rng(9).patch(3, 3);
    let mut moved = before.clone();
    moved.move_point(5, DVec3::ONE).unwrap();
    let mut expected = before.control_points().to_vec();
    expected[5] = DVec3::ONE;
    assert_eq!(moved.control_points(), expected);
    assert!(before.approx_eq(&before, 0.0));
    assert!(!before.approx_eq(&moved, 1e-9));
    assert!(before.approx_eq(&moved, 4.0));
    assert!(!before.approx_eq(&before.elevate().unwrap(), 1e9));
}

#[test]
fn refusals() {
    let net = [DVec3::ZERO; 16];
    let count = "net: expected (degree_u + 1)·(degree_v + 1) control points, got";
    assert_refused(Patch::new(&net[..15], 3, 3), &format!("{count} 15"));
    assert_refused(Patch::new(&[], 1, 1), &format!("{count} 0"));
    let degree = |name: &str| format!("degree_{name}: expected a whole number from 1 to 64, got ");
    assert_refused(Patch::new(&net, 0, 3), &(degree("u") + "0"));
    assert_refused(Patch::new(&net, 3, 65), &(degree("v") + "65"));
    assert_refused(Patch::new(&net, usize::MAX, 3), &degree("u"));
    let mut good = patch(&net, 3, 3);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut broken = net;
        broken[7].z = bad;
        let finite = "expected a finite number";
        assert_refused(Patch::new(&broken, 3, 3), &format!("net[7]: {finite}"));
        let to = good.move_point(0, DVec3::new(0.0, bad, 0.0));
        assert_refused(to, &format!("to[0]: {finite}"));
    }
    let last = "index: expected an index from 0 to 15, got 16";
    assert_refused(good.move_point(16, DVec3::ZERO), last);
    assert_eq!(good, patch(&net, 3, 3));
}
