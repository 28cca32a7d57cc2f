//! Tubes: closed bodies around the isocurves of a surface.

use super::{euler, tubes};
use crate::support::Rng;
use crate::support::measure::from_segment;
use crate::support::nets::{RandomNet, net, single, teapot, triangles, vector, vectors, volume};
use casteljau::glam::{DAffine3, DVec3};
use std::f64::consts::PI;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn straight_tubes_are_capsules() {
    // Four straight edges of a rectangle of 3 × 2.
    let surface = single(&net(1, 1, |i, j| DVec3::new(3.0 * i, 2.0 * j, 1.0)), 1, 1);
    for sides in [3, 4, 5, 8, 16, 64] {
        let radius = 0.1;
        let mesh = tubes(&surface, 1, radius, sides);
        assert_eq!(euler(&mesh), 2 * 4);
        let capsule = |length: f64| PI * radius * radius * (length + 4.0 / 3.0 * radius);
        let share = volume(&mesh) / (2.0 * capsule(3.0) + 2.0 * capsule(2.0));
        // An inscribed polygon has the fraction sin(2π/n)·n/2π of the area of its circle; ends have less.
        let polygon = (2.0 * PI / sides as f64).sin() * sides as f64 / (2.0 * PI);
        let range = polygon * polygon - 0.03..polygon;
        assert!(range.contains(&share), "{sides}: {share}");
        for t in triangles(&mesh) {
            let [a, b, c] = t.map(|vertex| vector(&mesh.positions, vertex));
            let outwards: DVec3 = t.map(|vertex| vector(&mesh.normals, vertex)).iter().sum();
            assert!((b - a).cross(c - a).dot(outwards) > 0.0, "{a} {b} {c}");
        }
        for p in vectors(&mesh.positions) {
            let beyond = |x: f64, max: f64| (x - x.clamp(0.0, max)).abs();
            // On the capsule around one of the edges.
            let along_x = |y: f64| DVec3::new(beyond(p.x, 3.0), p.y - y, p.z - 1.0).length();
            let along_y = |x: f64| DVec3::new(p.x - x, beyond(p.y, 2.0), p.z - 1.0).length();
            let distances = [along_x(0.0), along_x(2.0), along_y(0.0), along_y(3.0)];
            let off = distances.map(|d| (d - radius).abs());
            assert!(off.into_iter().fold(1.0, f64::min) < 1e-6, "{p}");
        }
    }
}

#[test]
fn teapot_s_tubes_are_closed_bodies() {
    for (lines, sides) in [(1, 3), (2, 5), (4, 8)] {
        let mesh = tubes(&teapot(), lines, 0.02, sides);
        // 32 patches with lines + 1 curves in each direction, minus 52 shared edges and 8 collapsed ones. The lid's
        // profile has no cusp, so each line is one body.
        let curves = 32 * 2 * (lines + 1) - 52 - 8;
        assert_eq!(euler(&mesh), 2 * isize::try_from(curves).unwrap());
        assert!(volume(&mesh) > 0.0);
    }
}

#[test]
fn centres_lie_on_the_lines() {
    let surface = single(&Rng(3).net(3, 3), 3, 3);
    let (radius, sides) = (0.02, 8);
    let mesh = tubes(&surface, 2, radius, sides);
    euler(&mesh);
    let curves = surface.isocurves(2).unwrap();
    let ts = (0..=2000).map(|k| f64::from(k) / 2000.0);
    let samples = curves
        .iter()
        .flat_map(|curve| ts.clone().map(|t| curve.eval(t)));
    let samples: Vec<DVec3> = samples.collect();
    let mut centres = Vec::new();
    for vertex in 0..mesh.vertex_count() {
        let centre = vector(&mesh.positions, vertex) - vector(&mesh.normals, vertex) * radius;
        let distances = samples.iter().map(|p| p.distance(centre));
        let nearest = distances.fold(1.0, f64::min);
        assert!(nearest < 2e-3, "{centre} is {nearest} off");
        centres.push(centre);
    }
    // The line is within r (1 − cos(π/8)) of the polygon of the centres: the rings are dense enough.
    let tolerance = radius * (1.0 - (PI / 8.0).cos());
    for p in samples.iter().step_by(7) {
        let windows = centres.windows(sides + 1);
        let off = windows.flat_map(|w| [w[sides], w[1]].map(|end| from_segment(*p, w[0], end)));
        let off = off.fold(1.0, f64::min);
        assert!(off <= tolerance + 1e-6, "{p}: {off} > {tolerance}");
    }
}

#[test]
fn tubes_of_plane_lines_do_not_twist() {
    // All lines of a plane patch: the component of a corner's normal perpendicular to the plane is constant along the
    // line.
    let net = net(3, 3, |x, y| {
        DVec3::new(x + 0.4 * y * y, y + 0.3 * x * x, 0.0)
    });
    // Rotated, so that the first corners are neither in the plane nor perpendicular to it.
    let turn = DAffine3::from_rotation_x(0.8) * DAffine3::from_rotation_y(0.5);
    let surface = single(&net, 3, 3).transform(&turn).unwrap();
    let sides = 6;
    let mesh = tubes(&surface, 1, 0.05, sides);
    assert_eq!(euler(&mesh), 8);
    // The vertices of a line: pole, ring of the cap, rings, ring of the cap, pole.
    let up = turn.transform_vector3(DVec3::Z);
    let height = |vertex| vector(&mesh.normals, vertex).dot(up);
    let heights: Vec<f64> = (0..mesh.vertex_count()).map(height).collect();
    let ring = |at: usize| heights[at..at + sides].to_vec();
    let mut at = 0;
    let mut rings = 0;
    while at < heights.len() {
        let first = ring(at + 1 + sides);
        at += 1 + 2 * sides;
        loop {
            let next = ring(at);
            let same = next.iter().zip(&first).all(|(a, b)| (a - b).abs() < 1e-6);
            if !same {
                break;
            }
            at += sides;
            rings += 1;
        }
        at += sides + 1;
    }
    assert_eq!(at, heights.len());
    assert!(rings > 12);
}
