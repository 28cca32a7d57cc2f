//! Random surfaces: joined patches have no cracks, and the mesh keeps its tolerance.

use super::checks::Three;
use super::distance::greatest;
use super::networks;
use super::shapes::{
    SIDES, along, diagonal, is_point, largest, lines, part, segments, side_points,
};
use super::soup::{Corners, Soup, add, vectors};
use crate::support::threads::on_all;
use crate::support::{Rng, cases};
use casteljau::glam::DVec3;
use casteljau::mesh::{Detail, TessellationOptions, Weld};
use casteljau::surface::PatchEdge;
use casteljau::{Mesh, Surface};
use std::collections::HashSet;

const CASES: usize = 20_000;
const DEEP_CASES: usize = 200_000;

#[test]
fn random_networks_have_no_cracks() {
    let mut rng = Rng(1986);
    let cases = (0..cases(CASES, DEEP_CASES)).map(|case| {
        let surface = networks::random(&mut rng);
        let options = options(&mut rng, &surface);
        (case, surface, options)
    });
    on_all(cases, |(case, surface, options)| {
        let outcome = std::panic::catch_unwind(|| check(&surface, &surface, &options));
        assert!(outcome.is_ok(), "case {case}: {options:?} of {surface:?}");
    });
}

pub(crate) fn options(rng: &mut Rng, surface: &Surface) -> TessellationOptions {
    let size = diagonal(surface).max(largest(surface) * 1e-4);
    if size == 0.0 || rng.chance(0.4) {
        return segments(1 + rng.below(4), 1 + rng.below(4));
    }
    TessellationOptions::tolerance(size * rng.magnitude(-2.0, -0.5))
}

/// Checks all guarantees of a mesh, for a surface whose patches are joined as those of another one.
pub(crate) fn check(surface: &Surface, joined: &Surface, options: &TessellationOptions) {
    let three = Three::new(surface, options);
    three.assert_alike(surface.patch_count());
    let mesh = &three.own;
    let soup = Soup::new(mesh);
    soup.assert_no_collapsed_triangle();
    assert_inside_is_closed(surface, mesh, &soup);
    assert_lines_agree(surface, joined, mesh);
    assert_covers(mesh);
    assert_locations(surface, options);
    if let Detail::Tolerance(tolerance) = options.detail {
        let max = distance_of_sheets(surface, mesh, &soup);
        assert!(max <= tolerance, "{max} for {tolerance}");
    }
}

/// The vertices of a patch on one of its edges, in the order of the parameter; none for a patch that is a curve.
fn polyline(mesh: &Mesh, patch: usize, side: PatchEdge) -> Vec<usize> {
    let range = mesh.patch_ranges[patch];
    let own = range.first_vertex as usize..(range.first_vertex + range.vertices) as usize;
    let location = |k: usize| along(side, [mesh.uvs[2 * k].into(), mesh.uvs[2 * k + 1].into()]);
    let mut line: Vec<(f64, usize)> = own.filter_map(|k| Some((location(k)?, k))).collect();
    line.sort_by(|a, b| a.0.total_cmp(&b.0));
    line.into_iter().map(|(_, k)| k).collect()
}

/// Checks that the edges of a patch's triangles cancel, except along its four edges.
fn assert_inside_is_closed(surface: &Surface, mesh: &Mesh, soup: &Soup) {
    for (patch, range) in mesh.patch_ranges.iter().enumerate() {
        if range.vertices == 0 {
            continue;
        }
        let (from, count) = (range.first_index as usize / 3, range.indices as usize / 3);
        let mut expected = Corners::new();
        for side in SIDES {
            let line = polyline(mesh, patch, side);
            for pair in line.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|k| soup.position_of[k]);
                // Counter-clockwise: v = 0 and u = 1 are traversed forwards, the others backwards.
                match side {
                    PatchEdge::V0 | PatchEdge::U1 => add(&mut expected, a, b),
                    PatchEdge::V1 | PatchEdge::U0 => add(&mut expected, b, a),
                }
            }
        }
        let rim = Soup::rim(&soup.triangles[from..from + count]);
        assert!(expected == rim, "patch {patch} of {surface:?}");
    }
}

/// Checks that all patches at a line have the same positions along it.
fn assert_lines_agree(surface: &Surface, joined: &Surface, mesh: &Mesh) {
    let points: Vec<DVec3> = vectors(&mesh.positions).collect();
    for uses in lines(joined) {
        let (patch, side) = (uses[0].patch, uses[0].edge);
        let controls = side_points(&surface.patch(patch).unwrap(), side);
        let collapsed = is_point(&side_points(&joined.patch(patch).unwrap(), side));
        let mut seen: Option<Vec<DVec3>> = None;
        for used in &uses {
            let vertices = polyline(mesh, used.patch, used.edge).into_iter();
            let mut line: Vec<DVec3> = vertices.map(|k| points[k]).collect();
            if line.is_empty() {
                continue;
            }
            if used.reversed {
                line.reverse();
            }
            let ends = |line: &[DVec3]| [line[0], line[line.len() - 1]];
            let expected = ends(&controls).map(|p| p.as_vec3().as_dvec3());
            assert_eq!(ends(&line), expected);
            assert!(!collapsed || is_point(&line));
            let first = seen.get_or_insert_with(|| line.clone());
            assert!(*first == line, "a crack along {uses:?}");
        }
    }
}

/// Checks that all triangles are counter-clockwise in u and v, and that they cover the unit square if none is
/// collapsed.
fn assert_covers(mesh: &Mesh) {
    let uv = |k: usize| [0, 1].map(|axis| f64::from(mesh.uvs[2 * k + axis]));
    let indices: Vec<usize> = mesh.indices.iter().collect();
    for range in mesh.patch_ranges.iter().filter(|range| range.vertices > 0) {
        let own = &indices[range.first_index as usize..][..range.indices as usize];
        let mut sum = 0.0;
        for &[a, b, c] in own.as_chunks().0 {
            let ([ua, va], [ub, vb], [uc, vc]) = (uv(a), uv(b), uv(c));
            let area = ((ub - ua) * (vc - va) - (vb - va) * (uc - ua)) / 2.0;
            assert!(area > 0.0, "a triangle of area {area} over u and v");
            sum += area;
        }
        assert!(sum < 1.0 + 1e-6);
        let first = range.first_vertex as usize;
        let vertices = range.vertices as usize;
        // Adding 0 makes −0 and 0 one position, as they are for the mesh.
        let bits = |k: usize| [0, 1, 2].map(|axis| (mesh.positions[3 * k + axis] + 0.0).to_bits());
        let distinct: HashSet<_> = (first..first + vertices).map(bits).collect();
        let covered = distinct.len() < vertices || sum > 1.0 - 1e-6;
        assert!(covered, "only {sum} of the square");
    }
}

/// Checks that in f64 every vertex is on its patch; patches without vertices are curves.
fn assert_locations(surface: &Surface, options: &TessellationOptions) {
    let mesh = surface.tessellate_f64(&options.weld(Weld::None)).unwrap();
    let full = match options.detail {
        Detail::Segments(grid) => (grid.segments_u * grid.segments_v) as f64,
        _ => (1_u64 << 24) as f64,
    };
    let slack = largest(surface) * 1e-13;
    let patches: Vec<_> = surface.patches().collect();
    for (k, p) in vectors(&mesh.positions).enumerate() {
        let [u, v] = [0, 1].map(|axis| (f64::from(mesh.uvs[2 * k + axis]) * full).round() / full);
        let exact = patches[mesh.patch_ids[k] as usize].eval(u, v);
        assert!((p - exact).length() <= slack, "({u}, {v}): {p} for {exact}");
    }
    for (patch, range) in patches.iter().zip(&mesh.patch_ranges) {
        let partials = patch.partials(0.371, 0.618);
        let size = patch.control_bounds().diagonal();
        let flat = partials.u.cross(partials.v).length() <= 1e-9 * size * size;
        assert!(range.vertices > 0 || flat, "an inside without vertices");
    }
}

/// The distance of the patches that are not curves.
fn distance_of_sheets(surface: &Surface, mesh: &Mesh, soup: &Soup) -> f64 {
    let with_inside = |&k: &usize| mesh.patch_ranges[k].vertices > 0;
    let patches: Vec<usize> = (0..surface.patch_count()).filter(with_inside).collect();
    if patches.is_empty() {
        return 0.0;
    }
    greatest(&part(surface, &patches), soup, 16 * patches.len()).0
}
