//! Intersections of curves, compared with a slow reference that discards only what is certain, and with known cases.

mod adversarial;
mod covering;
pub(crate) mod generate;
mod known;
mod metamorphic;
mod random;
mod reference;
mod reported;
mod selves;
mod splines;

use casteljau::curve::{Intersection, IntersectionKind};

/// The parameters and the kind of each intersection.
pub(crate) fn kinds(found: &[Intersection]) -> Vec<(f64, f64, IntersectionKind)> {
    found.iter().map(|p| (p.t, p.u, p.kind)).collect()
}

fn overlap(t_end: f64, u_end: f64) -> IntersectionKind {
    IntersectionKind::Overlap { t_end, u_end }
}

/// Where two curves meet: the parameters of each intersection, also those of the end of an overlap.
fn spots(p: &Intersection) -> Vec<(f64, f64)> {
    match p.kind {
        IntersectionKind::Overlap { t_end, u_end } => vec![(p.t, p.u), (t_end, u_end)],
        _ => vec![(p.t, p.u)],
    }
}
