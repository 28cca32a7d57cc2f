//! Meshes of surfaces of rational patches: no cracks, the tolerance at every triangle, and normals in closed form.

use super::surface::random_patch;
use super::within;
use crate::support::nets::{triangles, vectors};
use crate::support::{Rng, cases};
use casteljau::glam::{DMat4, DVec2, DVec3, DVec4};
use casteljau::mesh::{TessellationOptions, View, Weld};
use casteljau::{Mesh, NurbsCurve, NurbsSurface, RationalPatch, RationalSurface};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

/// A body: its surface, the Euler characteristic, the number of boundary loops, and for a point near it the vector from the
/// nearest point of the whole implicit surface, whose direction is that of the normal or opposite to it.
struct Body {
    name: &'static str,
    nurbs: NurbsSurface,
    euler: i64,
    is_closed: bool,
    /// The signed distance.
    distance: Box<dyn Fn(DVec3) -> f64>,
    /// The outward normal at a point of the surface; 0 where there is none.
    normal: Box<dyn Fn(DVec3) -> DVec3>,
}

const CENTER: DVec3 = DVec3::new(0.3, -0.2, 0.5);

fn axis() -> DVec3 {
    DVec3::new(1.0, 2.0, 3.0).normalize()
}

/// The distance from the axis through the center, the height along it, and the direction away from the axis.
fn in_half_plane(p: DVec3) -> (DVec2, DVec3) {
    let (off, axis) = (p - CENTER, axis());
    let height = off.dot(axis);
    let radius = off - axis * height;
    (
        DVec2::new(radius.length(), height),
        radius.normalize_or_zero(),
    )
}

/// The vector of a half-plane at a point.
fn from_half_plane(p: DVec3, [r, z]: [f64; 2]) -> DVec3 {
    in_half_plane(p).1 * r + axis() * z
}

/// A profile in the half-plane, in space.
fn profile(points: &[(f64, f64)], weights: Option<&[f64]>, knots: &[f64]) -> NurbsCurve<DVec3> {
    let radius = axis().any_orthonormal_vector();
    let points: Vec<DVec3> = points
        .iter()
        .map(|&(r, z)| CENTER + radius * r + axis() * z)
        .collect();
    let degree = knots.len() - points.len() - 1;
    NurbsCurve::new(degree, &points, weights, knots, false).expect("valid")
}

fn bodies() -> Vec<Body> {
    let slope = DVec2::new(1.0, 2.0).normalize(); // of a cone with radius 2 and height 1: its normal
    let half = 0.5_f64.sqrt();
    let quarter_turns = [1.0, half, 1.0, half, 1.0];
    // A torus from a profile that is a full circle, turned by less than a full turn.
    let tube = [(2.5, 0.0), (2.5, 0.5), (2.0, 0.5), (1.5, 0.5), (1.5, 0.0)];
    let upper = profile(
        &tube,
        Some(&quarter_turns),
        &[0.0, 0.0, 0.0, 0.4, 0.4, 1.0, 1.0, 1.0],
    );
    let circle = |height: f64, radius: f64| {
        let (x, y) = axis().any_orthonormal_pair();
        NurbsCurve::arc(CENTER + axis() * height, x * radius, y * radius, 0.0, TAU).expect("valid")
    };
    let valid = |surface: Result<NurbsSurface, casteljau::Error>| surface.expect("valid");
    let torus = |p: DVec3| (in_half_plane(p).0 - DVec2::new(2.0, 0.0)).length() - 0.5;
    let torus_normal = |p: DVec3| {
        let n = (in_half_plane(p).0 - DVec2::new(2.0, 0.0)).normalize();
        from_half_plane(p, [n.x, n.y])
    };
    vec![
        Body {
            name: "sphere",
            nurbs: valid(NurbsSurface::sphere(CENTER, 1.5, axis())),
            euler: 2,
            is_closed: true,
            distance: Box::new(|p| (p - CENTER).length() - 1.5),
            normal: Box::new(|p| (p - CENTER).normalize()),
        },
        Body {
            name: "torus",
            nurbs: valid(NurbsSurface::torus(CENTER, 2.0, 0.5, axis())),
            euler: 0,
            is_closed: true,
            distance: Box::new(torus),
            normal: Box::new(torus_normal),
        },
        Body {
            name: "cylinder",
            nurbs: valid(NurbsSurface::cylinder(CENTER, 1.5, 2.0, axis())),
            euler: 0,
            is_closed: false,
            distance: Box::new(|p| in_half_plane(p).0.x - 1.5),
            normal: Box::new(|p| from_half_plane(p, [1.0, 0.0])),
        },
        Body {
            name: "cone",
            nurbs: valid(NurbsSurface::cone(CENTER, 2.0, 1.0, axis())),
            euler: 1,
            is_closed: false,
            distance: Box::new(move |p| (in_half_plane(p).0 - DVec2::new(0.0, 1.0)).dot(slope)),
            normal: Box::new(move |p| {
                // Without a direction at the tip.
                if in_half_plane(p).0.x < 1e-9 {
                    return DVec3::ZERO;
                }
                from_half_plane(p, [slope.x, slope.y])
            }),
        },
        Body {
            name: "half of a turn of half a torus",
            nurbs: valid(NurbsSurface::revolve(&upper, CENTER, axis(), PI)),
            euler: 1,
            is_closed: false,
            distance: Box::new(torus),
            normal: Box::new(torus_normal),
        },
        Body {
            name: "loft of circles",
            nurbs: valid(NurbsSurface::loft(
                &[circle(0.0, 2.0), circle(0.5, 1.0), circle(0.8, 0.4)],
                1,
            )),
            euler: 0,
            is_closed: false,
            distance: Box::new(move |p| (in_half_plane(p).0 - DVec2::new(0.0, 1.0)).dot(slope)),
            normal: Box::new(move |p| from_half_plane(p, [slope.x, slope.y])),
        },
    ]
}

/// Asserts that each edge has two triangles that traverse it in opposite directions, or one; returns the number of edges with
/// one, and the Euler characteristic.
pub(super) fn edges<T>(mesh: &Mesh<T>) -> (usize, i64) {
    let mut uses: HashMap<[usize; 2], [u32; 2]> = HashMap::new();
    let mut vertices = vec![false; mesh.vertex_count()];
    for triangle in triangles(mesh) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            assert_ne!(a, b, "a triangle without area");
            vertices[a] = true;
            uses.entry([a.min(b), a.max(b)]).or_default()[usize::from(a < b)] += 1;
        }
    }
    let mut open = 0;
    for both in uses.values() {
        assert!(both[0] <= 1 && both[1] <= 1, "an edge of several triangles");
        open += usize::from(both[0] + both[1] == 1);
    }
    let count = |n: usize| i64::try_from(n).expect("few");
    let used = vertices.iter().filter(|used| **used).count();
    (
        open,
        count(used) - count(uses.len()) + count(mesh.triangle_count()),
    )
}

fn distance(a: DVec3, b: DVec3) -> f64 {
    (a - b).length()
}

/// The denominator of a patch.
fn denominator(patch: &RationalPatch, u: f64, v: f64) -> f64 {
    let row = |row: &[f64], t: f64| {
        let mut row = row.to_vec();
        while row.len() > 1 {
            row = row
                .windows(2)
                .map(|w| w[0] * (1.0 - t) + w[1] * t)
                .collect();
        }
        row[0]
    };
    let rows = patch.weights().chunks(patch.degree_u() + 1);
    row(&rows.map(|w| row(w, u)).collect::<Vec<_>>(), v)
}

/// The largest distance between a point of a triangle and the point of the patch that linear interpolation of homogeneous
/// coordinates maps to it: it bounds the distance of the mesh from the surface, and of the surface from the mesh.
pub(super) fn deviation(surface: &RationalSurface, mesh: &Mesh<f64>) -> f64 {
    largest_of(surface, mesh, distance)
}

/// The largest value of a function of a point of the surface and the corresponding point of a triangle.
fn largest_of(
    surface: &RationalSurface,
    mesh: &Mesh<f64>,
    distance: impl Fn(DVec3, DVec3) -> f64,
) -> f64 {
    let patches: Vec<RationalPatch> = surface.patches().collect();
    let points: Vec<DVec3> = vectors(&mesh.positions).collect();
    let uv = |k: usize| DVec2::new(f64::from(mesh.uvs[2 * k]), f64::from(mesh.uvs[2 * k + 1]));
    let parts = [
        [1.0, 1.0, 1.0],
        [2.0, 1.0, 1.0],
        [1.0, 3.0, 0.0],
        [0.0, 1.0, 1.0],
        [2.0, 0.0, 1.0],
    ];
    let mut largest: f64 = 0.0;
    for triangle in triangles(mesh) {
        let patch = &patches[mesh.patch_ids[triangle[0]] as usize];
        let weights = triangle.map(|k| denominator(patch, uv(k).x, uv(k).y));
        for shares in parts {
            let sum: f64 = shares.iter().sum();
            let (mut at, mut point, mut weight) = (DVec2::ZERO, DVec3::ZERO, 0.0);
            for k in 0..3 {
                let share = shares[k] / sum;
                at += uv(triangle[k]) * share;
                point += points[triangle[k]] * (share * weights[k]);
                weight += share * weights[k];
            }
            largest = largest.max(distance(patch.eval(at.x, at.y), point / weight));
        }
    }
    largest
}

/// Eight tolerances from 0.2 to 0.0004.
fn tolerances() -> impl Iterator<Item = f64> {
    (0..8).map(|k| 0.2 * 0.41_f64.powi(k))
}

fn options(tolerance: f64, weld: Weld) -> TessellationOptions {
    TessellationOptions::tolerance(tolerance).weld(weld)
}

#[test]
fn bodies_keep_the_tolerance_without_cracks() {
    for body in bodies() {
        let (name, surface) = (body.name, body.nurbs.to_surface().expect("valid"));
        let topology = surface.topology();
        assert_eq!(topology.open.is_empty(), body.is_closed, "{name}");
        assert!(topology.non_manifold.is_empty() && topology.components.len() == 1);
        for tolerance in tolerances() {
            let mesh = surface
                .tessellate_f64(&options(tolerance, Weld::Position))
                .expect("valid");
            let (open, euler) = edges(&mesh);
            assert_eq!(open == 0, body.is_closed, "{name} at {tolerance}");
            assert_eq!(euler, body.euler, "{name} at {tolerance}");
            let own = surface
                .tessellate_f64(&options(tolerance, Weld::None))
                .expect("valid");
            let off = deviation(&surface, &own);
            assert!(off <= tolerance, "{name} at {tolerance}: {off}");
            let points: Vec<DVec3> = vectors(&own.positions).collect();
            for (p, normal) in points.iter().zip(vectors(&own.normals)) {
                assert!((body.distance)(*p).abs() < 4e-15, "{name}");
                let expected = (body.normal)(*p);
                if expected != DVec3::ZERO {
                    // v of a profile may run either way.
                    let off = distance(normal, expected).min(distance(normal, -expected));
                    assert!(off < 1e-13, "{name} at {p}: {normal} for {expected}");
                }
            }
            for triangle in triangles(&own) {
                let [a, b, c] = triangle.map(|k| points[k]);
                for p in [(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0] {
                    let off = (body.distance)(p).abs();
                    assert!(off <= tolerance, "{name} at {tolerance}: {off}");
                }
            }
        }
    }
}

#[test]
fn random_patches_keep_the_tolerance() {
    let mut rng = Rng(11);
    for case in 0..cases(120, 2000) {
        // Weights from 1e-3 to 1e3.
        let spread = 10.0 * rng.unit();
        let patch = random_patch(&mut rng, spread);
        let surface = RationalSurface::from(&patch);
        let tolerance = 10.0_f64.powf(within(&mut rng, -3.0, -0.5));
        let mesh = surface
            .tessellate_f64(&options(tolerance, Weld::None))
            .expect("valid");
        let off = deviation(&surface, &mesh);
        assert!(off <= tolerance, "{case} at {tolerance}: {off}");
        let (_, euler) = edges(&mesh);
        assert_eq!(euler, 1);
        for (k, uv) in mesh.uvs.as_chunks().0.iter().enumerate() {
            let [u, v] = uv.map(f64::from);
            let normal = DVec3::from_slice(&mesh.normals[3 * k..3 * k + 3]);
            let p = DVec3::from_slice(&mesh.positions[3 * k..3 * k + 3]);
            assert!(distance(p, patch.eval(u, v)) < 1e-13);
            assert!(distance(normal, patch.normal(u, v)) < 1e-8, "{case}");
        }
    }
}

#[test]
fn weights_along_one_direction_take_few_triangles() {
    let half = 0.5_f64.sqrt();
    let net = [
        (1.0, 0.0, 0.0),
        (1.0, 1.0, 0.0),
        (0.0, 1.0, 0.0),
        (1.0, 0.0, 2.0),
        (1.0, 1.0, 2.0),
        (0.0, 1.0, 2.0),
    ]
    .map(DVec3::from);
    // A quarter of a cylinder: a factor of the weights of a row changes only v.
    let mesh = |factor: f64| {
        let weights = [1.0, half, 1.0, factor, half * factor, factor];
        let patch = RationalPatch::new(&net, &weights, 2, 1).expect("valid");
        let surface = RationalSurface::from(&patch);
        let mesh = surface
            .tessellate_f64(&options(0.05, Weld::None))
            .expect("few triangles");
        let off = deviation(&surface, &mesh);
        assert!(off <= 0.05, "{factor}: {off}");
        mesh.triangle_count()
    };
    let first = mesh(10.0);
    for digits in 2..6 {
        // Weights that change by a further factor of 10 take about as many triangles as the first one.
        let count = mesh(10.0_f64.powi(digits));
        assert!(
            count <= 2 * digits.unsigned_abs() as usize * first,
            "10^{digits}: {count}, not {first}"
        );
    }
}

#[test]
fn pixels_on_the_screen() {
    let mut rng = Rng(12);
    let surface = NurbsSurface::torus(CENTER, 2.0, 0.5, axis()).expect("valid");
    let surface = surface.to_surface().expect("valid");
    let viewport = DVec2::new(640.0, 480.0);
    let mut counts = Vec::new();
    for pixels in [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0] {
        let eye = CENTER + DVec3::new(rng.signed(), rng.signed(), rng.signed()).normalize() * 6.0;
        let back = (eye - CENTER).normalize();
        let right = DVec3::Z.cross(back).normalize();
        let row = |axis: DVec3, zoom: f64| (axis * zoom).extend(-axis.dot(eye) * zoom);
        let (x, y) = (row(right, 1.5), row(back.cross(right), 2.0));
        let view_projection = DMat4::from_rows(x, y, DVec4::W, row(-back, 1.0));
        let on_screen = |p: DVec3| {
            let q = view_projection * p.extend(1.0);
            DVec2::new(q.x, q.y) / q.w * viewport / 2.0
        };
        let options = TessellationOptions::pixels(View {
            pixels,
            view_projection,
            viewport,
        });
        let mesh = surface
            .tessellate_f64(&options.weld(Weld::None))
            .expect("valid");
        let off = largest_of(&surface, &mesh, |p, q| {
            let ends = [on_screen(p), on_screen(q)];
            let is_seen = ends.iter().all(|at| at.abs().cmple(viewport / 2.0).all());
            let pixels = (ends[0] - ends[1]).length();
            if is_seen { pixels } else { 0.0 }
        });
        assert!(off <= pixels, "{off} of {pixels}");
        assert!(off > pixels / 40.0, "{off} of {pixels}");
        let mesh = surface
            .tessellate_f64(&options.weld(Weld::Position))
            .expect("valid");
        assert_eq!(edges(&mesh), (0, 0));
        counts.push(mesh.triangle_count());
    }
    assert!(counts[0] > 10 * counts[7]);
}

/// On a sphere and on a torus the mixed derivatives are at right angles to the others. If all three lengths were added up, the
/// meshes would have 25,040 and 83,808 triangles.
#[test]
fn mixed_derivatives_count_at_right_angles() {
    let sphere = NurbsSurface::sphere(DVec3::ZERO, 1.0, DVec3::Z).expect("valid");
    let torus = NurbsSurface::torus(DVec3::ZERO, 3.0, 1.0, DVec3::Z).expect("valid");
    for (nurbs, most) in [(sphere, 18_000), (torus, 72_000)] {
        let surface = nurbs.to_surface().expect("valid");
        let mesh = surface
            .tessellate(&options(1e-3, Weld::Position))
            .expect("valid");
        assert!(mesh.triangle_count() < most, "{}", mesh.triangle_count());
    }
}
