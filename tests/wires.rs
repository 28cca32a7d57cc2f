//! A surface as a mesh of its lines: tubes and ribbons.

mod nets;

use casteljau::glam::{DAffine3, DVec3};
use casteljau::surface::{Up, Wire, WireframeOptions};
use casteljau::{Mesh, Surface, TeapotOptions};
use nets::Random;
use std::collections::HashMap;
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

fn teapot() -> Surface {
    Surface::teapot(TeapotOptions::default())
}

fn single(net: Vec<DVec3>, m: usize, n: usize) -> Surface {
    let indices = (0..u32::try_from(net.len()).unwrap()).collect();
    Surface::new(net, indices, m, n).unwrap()
}

fn tubes(surface: &Surface, lines: usize, radius: f64, sides: usize) -> Mesh {
    let wire = Wire::Tube { radius, sides };
    surface
        .wireframe(&WireframeOptions { lines, wire })
        .unwrap()
}

fn ribbons(surface: &Surface, lines: usize, width: f64) -> Mesh {
    let wire = Wire::Ribbon { width };
    surface
        .wireframe(&WireframeOptions { lines, wire })
        .unwrap()
}

fn vector(list: &[f32], vertex: usize) -> DVec3 {
    let [x, y, z] = [0, 1, 2].map(|axis| f64::from(list[3 * vertex + axis]));
    DVec3::new(x, y, z)
}

fn triangles(mesh: &Mesh) -> Vec<[usize; 3]> {
    let indices: Vec<usize> = mesh.indices.iter().collect();
    indices.chunks(3).map(|t| [t[0], t[1], t[2]]).collect()
}

/// Checks lengths and normals, and that ranges cover the mesh; V − E + F if it is closed.
fn euler(mesh: &Mesh) -> isize {
    let vertices = mesh.vertex_count();
    assert_eq!(mesh.normals.len(), 3 * vertices);
    assert!(mesh.uvs.is_empty() && mesh.patch_ids.is_empty());
    for vertex in 0..vertices {
        assert!(vector(&mesh.positions, vertex).is_finite());
        let length = vector(&mesh.normals, vertex).length();
        assert!((length - 1.0).abs() < 3e-7, "{vertex}: {length}");
    }
    let mut edges: HashMap<(usize, usize), isize> = HashMap::new();
    for triangle in triangles(mesh) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            assert!(a < vertices && a != b);
            *edges.entry((a, b)).or_default() += 1;
        }
    }
    // Each edge once in each direction: closed, and turned the same way.
    for (&(a, b), &times) in &edges {
        assert_eq!((times, edges.get(&(b, a))), (1, Some(&1)));
    }
    let count = |n: usize| isize::try_from(n).unwrap();
    count(vertices) - count(edges.len() / 2) + count(mesh.triangle_count())
}

fn volume(mesh: &Mesh) -> f64 {
    let corner = |vertex| vector(&mesh.positions, vertex);
    let tetrahedron = |t: [usize; 3]| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0;
    triangles(mesh).into_iter().map(tetrahedron).sum()
}

#[wasm_bindgen_test(unsupported = test)]
fn straight_tubes_are_capsules() {
    // Four straight sides of a square of 3 × 2.
    let square = [[0.0, 0.0], [3.0, 0.0], [0.0, 2.0], [3.0, 2.0]];
    let surface = single(square.map(|[x, y]| DVec3::new(x, y, 1.0)).to_vec(), 1, 1);
    for sides in [3, 4, 5, 8, 16, 64] {
        let radius = 0.1;
        let mesh = tubes(&surface, 1, radius, sides);
        assert_eq!(euler(&mesh), 2 * 4);
        let capsule = |length: f64| PI * radius * radius * (length + 4.0 / 3.0 * radius);
        let share = volume(&mesh) / (2.0 * capsule(3.0) + 2.0 * capsule(2.0));
        // An inscribed polygon has the share sin(2π/n)·n/2π of its circle, ends have less.
        let polygon = (2.0 * PI / sides as f64).sin() * sides as f64 / (2.0 * PI);
        assert!(
            share < polygon && share > polygon * polygon - 0.03,
            "{sides}: {share}"
        );
        for vertex in 0..mesh.vertex_count() {
            let p = vector(&mesh.positions, vertex);
            let beyond = |x: f64, most: f64| (x - x.clamp(0.0, most)).abs();
            // On the capsule about one of the sides.
            let along_x = |y: f64| DVec3::new(beyond(p.x, 3.0), p.y - y, p.z - 1.0).length();
            let along_y = |x: f64| DVec3::new(p.x - x, beyond(p.y, 2.0), p.z - 1.0).length();
            let distances = [along_x(0.0), along_x(2.0), along_y(0.0), along_y(3.0)];
            let off = distances.map(|d| (d - radius).abs());
            assert!(off.into_iter().fold(1.0, f64::min) < 1e-6, "{p}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn teapot_s_tubes_are_closed_bodies() {
    for (lines, sides) in [(1, 3), (2, 5), (4, 8)] {
        let mesh = tubes(&teapot(), lines, 0.02, sides);
        // 32 patches with lines + 1 curves each way, less 52 shared sides and 8 collapsed ones; the lid's profile has a cusp
        // nowhere, so that each line is one body.
        let curves = 32 * 2 * (lines + 1) - 52 - 8;
        assert_eq!(euler(&mesh), 2 * isize::try_from(curves).unwrap());
        assert!(volume(&mesh) > 0.0);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn centres_lie_on_the_lines() {
    let surface = single(Random(3).net(3, 3), 3, 3);
    let (radius, sides) = (0.02, 8);
    let mesh = tubes(&surface, 2, radius, sides);
    euler(&mesh);
    let curves = surface.isocurves(2).unwrap();
    let samples: Vec<DVec3> = curves
        .iter()
        .flat_map(|curve| (0..=2000).map(|k| curve.eval(f64::from(k) / 2000.0)))
        .collect();
    let mut centres = Vec::new();
    for vertex in 0..mesh.vertex_count() {
        let centre = vector(&mesh.positions, vertex) - vector(&mesh.normals, vertex) * radius;
        let nearest = samples
            .iter()
            .map(|p| p.distance(centre))
            .fold(1.0, f64::min);
        assert!(nearest < 2e-3, "{centre} is {nearest} off");
        centres.push(centre);
    }
    // And the line is nowhere farther from the centres' polygon than r (1 − cos(π/8)): rings are that dense.
    let tolerance = radius * (1.0 - (PI / 8.0).cos());
    for p in samples.iter().step_by(7) {
        let nearest = centres
            .windows(sides + 1)
            .flat_map(|w| [(w[0], w[sides]), (w[0], w[1])]);
        let distance = nearest
            .map(|(a, b)| distance_to_segment(*p, a, b))
            .fold(1.0, f64::min);
        assert!(
            distance <= tolerance + 1e-6,
            "{p}: {distance} > {tolerance}"
        );
    }
}

fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let t = (p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
    p.distance(a + along * t.clamp(0.0, 1.0))
}

#[wasm_bindgen_test(unsupported = test)]
fn tubes_of_plane_lines_do_not_twist() {
    // All lines of a plane patch: the part of a corner's normal across the plane is the same along the whole line.
    let net = (0..16).map(|i| {
        let (x, y) = (f64::from(i % 4), f64::from(i / 4));
        DVec3::new(x + 0.4 * y * y, y + 0.3 * x * x, 0.0)
    });
    let sides = 6;
    let mesh = tubes(&single(net.collect(), 3, 3), 1, 0.05, sides);
    assert_eq!(euler(&mesh), 8);
    // A line: pole, ring of the cap, rings, ring of the cap, pole.
    let heights: Vec<f64> = (0..mesh.vertex_count())
        .map(|v| vector(&mesh.normals, v).z)
        .collect();
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

#[wasm_bindgen_test(unsupported = test)]
fn ribbons_lie_in_the_tangent_planes() {
    let surface = single(Random(8).net(3, 3), 3, 3);
    let width = 0.04;
    let mesh = ribbons(&surface, 1, width);
    let patch = surface.patch(0).unwrap();
    let curves = surface.isocurves(1).unwrap();
    assert_eq!(curves.len(), 4);
    for vertex in (0..mesh.vertex_count()).step_by(2) {
        let [left, right] = [0, 1].map(|k| vector(&mesh.positions, vertex + k));
        assert!((left.distance(right) - width).abs() < 1e-6);
        let normal = vector(&mesh.normals, vertex);
        assert_eq!(normal, vector(&mesh.normals, vertex + 1));
        assert!(normal.dot(right - left).abs() < 1e-7);
        // The middle is a point of a side, and the normal is the patch's there.
        let middle = 0.5 * (left + right);
        let places = (0..4).flat_map(|side| (0..=4000).map(move |k| (side, f64::from(k) / 4000.0)));
        let uv = |(side, t): (usize, f64)| [(0.0, t), (1.0, t), (t, 0.0), (t, 1.0)][side];
        let nearest = places
            .map(|place| (patch.eval(uv(place).0, uv(place).1).distance(middle), place))
            .fold((1.0, (0, 0.0)), |a, b| if b.0 < a.0 { b } else { a });
        assert!(nearest.0 < 2e-3);
        let (u, v) = uv(nearest.1);
        assert!(normal.dot(patch.normal(u, v)) > 0.999);
    }
    for [a, b, c] in triangles(&mesh) {
        let [p, q, r] = [a, b, c].map(|vertex| vector(&mesh.positions, vertex));
        let cross = (q - p).cross(r - p);
        assert!(cross.dot(vector(&mesh.normals, a)) > 0.0);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn ribbons_turn_with_the_surface() {
    // z = 20xy: every line is straight, but the surface turns about it by nearly half a turn from end to end.
    let net = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let net = net.map(|(x, y)| DVec3::new(x - 0.5, y - 0.5, 20.0 * (x - 0.5) * (y - 0.5)));
    let mesh = ribbons(&single(net.to_vec(), 1, 1), 2, 0.01);
    assert!(mesh.vertex_count() > 2 * 3 * 6);
    let mut sides = 0;
    for [a, b, ..] in triangles(&mesh) {
        let turn = vector(&mesh.normals, a).dot(vector(&mesh.normals, b));
        assert!(turn >= (PI / 4.0).cos() - 1e-6);
        sides += 1;
    }
    assert_eq!(sides, mesh.triangle_count());
}

#[wasm_bindgen_test(unsupported = test)]
fn ranges_tell_which_patch_drew() {
    for mesh in [tubes(&teapot(), 3, 0.02, 4), ribbons(&teapot(), 3, 0.02)] {
        assert_eq!(mesh.patch_ranges.len(), 32);
        let (mut vertex, mut index) = (0, 0);
        for range in &mesh.patch_ranges {
            assert_eq!((range.first_vertex, range.first_index), (vertex, index));
            (vertex, index) = (vertex + range.vertices, index + range.indices);
        }
        assert_eq!(vertex as usize, mesh.vertex_count());
        assert_eq!(index as usize, mesh.indices.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn results_follow_the_surface() {
    let turn =
        DAffine3::from_rotation_y(0.7) * DAffine3::from_translation(DVec3::new(1.0, 2.0, 3.0));
    let count = |mesh: &Mesh| (mesh.vertex_count(), mesh.triangle_count());
    let cup = Surface::teacup(Up::Z);
    let (plain, turned) = (
        ribbons(&cup, 2, 0.02),
        ribbons(&cup.transform(&turn), 2, 0.02),
    );
    assert!(count(&plain).0.abs_diff(count(&turned).0) < 20);
    for scale in [1e-9, 1e9] {
        let scaled = cup.transform(&DAffine3::from_scale(DVec3::splat(scale)));
        let mesh = tubes(&scaled, 2, 0.02 * scale, 8);
        assert!(count(&mesh).0.abs_diff(count(&tubes(&cup, 2, 0.02, 8)).0) < 100);
        let share = volume(&mesh) / volume(&tubes(&cup, 2, 0.02, 8)) / scale.powi(3);
        assert!((share - 1.0).abs() < 1e-3, "{share}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn degenerate_lines() {
    let point = single(vec![DVec3::ONE; 16], 3, 3);
    assert_eq!(tubes(&point, 3, 0.1, 8), empty(1));
    assert_eq!(ribbons(&point, 3, 0.1), empty(1));
    let nothing = Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap();
    assert_eq!(tubes(&nothing, 3, 0.1, 8), empty(0));
    // A patch that is a curve has no normals; one whose lines turn back, and one whose lines have cusps.
    let along = |xs: [f64; 4]| {
        let row = move |y: f64| xs.map(|x| DVec3::new(x, y, 0.0));
        [0.0, 0.0, 0.0, 0.0].map(row).concat()
    };
    let cusp = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
    let cusps: Vec<DVec3> = (0..16)
        .map(|i| DVec3::new(cusp[i % 4].0, cusp[i % 4].1, (i / 4) as f64))
        .collect();
    for net in [
        along([0.0, 1.0, 2.0, 3.0]),
        along([0.0, 3.0, -2.0, 1.0]),
        along([0.0; 4]),
        cusps,
    ] {
        let surface = single(net, 3, 3);
        euler(&tubes(&surface, 2, 0.01, 7));
        check_ribbons(&ribbons(&surface, 2, 0.01));
    }
    // The cusp ends a line: both arms are bodies of their own.
    let cusps = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let net = [0.0, 1.0]
        .map(|z| cusps.map(|[x, y]| DVec3::new(x, y, z)))
        .concat();
    assert_eq!(
        euler(&tubes(&single(net, 3, 1), 1, 0.01, 8)),
        2 * (2 + 2 * 2)
    );
}

fn empty(patches: usize) -> Mesh {
    Mesh {
        patch_ranges: vec![casteljau::surface::PatchRange::default(); patches],
        ..Mesh::default()
    }
}

fn check_ribbons(mesh: &Mesh) {
    let finite = |list: &[f32]| list.iter().all(|x| x.is_finite());
    assert!(finite(&mesh.positions) && finite(&mesh.normals));
    for vertex in 0..mesh.vertex_count() {
        assert!((vector(&mesh.normals, vertex).length() - 1.0).abs() < 3e-7);
    }
    assert!(
        triangles(mesh)
            .iter()
            .flatten()
            .all(|&v| v < mesh.vertex_count())
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn wild_nets() {
    let mut random = Random(11);
    for case in 0..300 {
        let (m, n) = (1 + case % 5, 1 + case / 5 % 4);
        let scale = [1.0, 1e-30, 1e30][case % 3];
        let net = random.net(m, n).into_iter().map(|p| p * scale);
        let surface = single(net.collect(), m, n);
        let size = [0.001, 0.1, 3.0][case % 7 % 3] * scale;
        euler(&tubes(&surface, 1 + case % 3, size, 3 + case % 6));
        check_ribbons(&ribbons(&surface, 1 + case % 3, size));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refused() {
    let of = |lines, wire| {
        let result = teapot().wireframe(&WireframeOptions { lines, wire });
        result.unwrap_err().to_string()
    };
    let tube = |radius, sides| Wire::Tube { radius, sides };
    let ribbon = |width| Wire::Ribbon { width };
    assert_eq!(
        of(0, ribbon(0.1)),
        "lines: expected a whole number from 1, got 0"
    );
    assert_eq!(
        of(1, tube(0.1, 2)),
        "sides: expected a whole number from 3, got 2"
    );
    assert_eq!(
        of(1, tube(0.0, 8)),
        "radius: expected a finite number above 0, got 0"
    );
    assert_eq!(
        of(1, ribbon(f64::NAN)),
        "width: expected a finite number above 0, got NaN"
    );
    assert_eq!(
        of(1, ribbon(f64::INFINITY)),
        "width: expected a finite number above 0, got inf"
    );
    assert!(of(1, tube(1e-9, 8)).starts_with("radius: expected at least "));
    assert!(of(1, ribbon(1e-9)).starts_with("width: expected at least "));
    assert!(of(1, ribbon(1e39)).starts_with("vertices: expected coordinates that f32 can hold"));
    assert!(of(1_000_000, ribbon(0.1)).starts_with("vertices: expected at most "));
    assert!(of(usize::MAX, ribbon(0.1)).starts_with("vertices: expected at most "));
    assert!(of(2, tube(0.1, usize::MAX)).starts_with("vertices: expected at most "));
    assert!(of(1, tube(2.0, 100_000)).contains("expected at "));
}
