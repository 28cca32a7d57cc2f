//! The surfaces of the tests.

pub(crate) use crate::support::nets::{part, scaled, teapot};
use casteljau::glam::DVec3;
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::models::Up;
use casteljau::surface::{EdgeUse, PatchEdge};
use casteljau::{Grid, Mesh, Patch, Surface};

/// The tea set, with names.
pub(crate) fn all() -> [(&'static str, Surface); 3] {
    [
        ("teapot", teapot()),
        ("teacup", Surface::teacup(Up::Z)),
        ("teaspoon", Surface::teaspoon(Up::Z)),
    ]
}

pub(crate) fn diagonal(surface: &Surface) -> f64 {
    surface.control_bounds().unwrap().diagonal()
}

/// The largest absolute coordinate.
pub(crate) fn largest(surface: &Surface) -> f64 {
    let numbers = surface.vertices().iter().flat_map(|p| p.to_array());
    numbers.fold(0.0, |max: f64, x| max.max(x.abs()))
}

pub(crate) fn segments(u: usize, v: usize) -> TessellationOptions {
    let (segments_u, segments_v) = (u, v);
    TessellationOptions::segments(Grid {
        segments_u,
        segments_v,
    })
}

pub(crate) fn tolerance(tolerance: f64) -> TessellationOptions {
    TessellationOptions::tolerance(tolerance)
}

pub(crate) fn meshed(surface: &Surface, options: TessellationOptions, weld: Weld) -> Mesh {
    surface.tessellate(&options.weld(weld)).unwrap()
}

/// The patch edges in the order of their names.
pub(crate) const SIDES: [PatchEdge; 4] =
    [PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1];

/// The parameter along an edge if (u, v) lies on it.
pub(crate) fn along(side: PatchEdge, [u, v]: [f64; 2]) -> Option<f64> {
    let (across, along, at) = match side {
        PatchEdge::U0 => (u, v, 0.0),
        PatchEdge::U1 => (u, v, 1.0),
        PatchEdge::V0 => (v, u, 0.0),
        PatchEdge::V1 => (v, u, 1.0),
    };
    (across == at).then_some(along)
}

/// The control points of an edge, in the direction of its parameter.
pub(crate) fn side_points(patch: &Patch, side: PatchEdge) -> Vec<DVec3> {
    let (points, columns) = (patch.control_points(), patch.degree_u() + 1);
    let (from, step) = match side {
        PatchEdge::U0 => (0, columns),
        PatchEdge::U1 => (columns - 1, columns),
        PatchEdge::V0 => (0, 1),
        PatchEdge::V1 => (points.len() - columns, 1),
    };
    let count = if step == 1 {
        columns
    } else {
        points.len() / columns
    };
    (0..count).map(|k| points[from + k * step]).collect()
}

/// Every edge with all edges that are the same line, found by comparing each pair. Each edge occurs once; an edge that
/// is a point is alone.
pub(crate) fn lines(surface: &Surface) -> Vec<Vec<EdgeUse>> {
    let mut lines: Vec<(Vec<DVec3>, Vec<EdgeUse>)> = Vec::new();
    for (patch, net) in surface.patches().enumerate() {
        for side in SIDES {
            let points = side_points(&net, side);
            let backwards: Vec<_> = points.iter().rev().copied().collect();
            let mut same = lines.iter_mut();
            let same = same.find(|(other, _)| *other == points || *other == backwards);
            let mut used = EdgeUse {
                patch,
                edge: side,
                reversed: false,
            };
            match same {
                Some((other, uses)) if !is_point(&points) => {
                    used.reversed = *other != points;
                    uses.push(used);
                }
                _ => lines.push((points, vec![used])),
            }
        }
    }
    lines.into_iter().map(|(_, uses)| uses).collect()
}

pub(crate) fn is_point(points: &[DVec3]) -> bool {
    points.iter().all(|p| *p == points[0])
}
